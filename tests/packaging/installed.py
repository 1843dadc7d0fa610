"""An installation of this build in a scratch folder, and what a program's --help says, read in the simplest way."""
import pathlib
import re
import subprocess


adapters = {"settle-calculix"}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def install(build, prefix):
    output("cmake", "--install", build, "--prefix", prefix)


def programs(prefix):
    """Those whose manual pages and completions are made from --help; adapters are scripts without options."""
    return sorted(path for path in pathlib.Path(prefix, "bin").iterdir() if path.name not in adapters)


def help_texts(program):
    """The --help of a program and of every subcommand at any depth, by what is typed: "settle run"."""
    texts, left = {}, [[]]
    while left:
        words = left.pop()
        text = texts[" ".join([program.name, *words])] = output(program, *words, "--help")
        left += [[*words, word] for word in subcommands(text)]
    return texts


def subcommands(text):
    block = re.search(r"^Subcommands:\n((?:  .*\n?)*)", text, re.MULTILINE)
    return re.findall(r"^  (\w[\w-]*)", block[1], re.MULTILINE) if block else []


def options(text):
    """Every name of every option: what opens a line, up to the first blank."""
    lines = re.findall(r"^  (-\S+)", text, re.MULTILINE)
    return [name for line in lines for name in line.split(",")]
