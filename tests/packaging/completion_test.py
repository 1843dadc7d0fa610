"""completion_test.py BUILD SCRATCH SHELL: the shell itself offers every subcommand and option, by the installed files."""
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import installed

build, prefix, shell = sys.argv[1:4]
share = f"{prefix}/share"

bash_script = """source {file}
COMP_WORDS=({words}) COMP_CWORD={last}
_{function}
printf '%s\\n' "${{COMPREPLY[@]}}"
"""


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True, timeout=60).stdout


def bash(program, lines):
    file = f"{share}/bash-completion/completions/{program}"
    offered = {}
    for line in lines:
        words = line.split(" ")
        script = bash_script.format(file=file, words=" ".join(f"'{word}'" for word in words), last=len(words) - 1,
                                    function=program.replace("-", "_"))
        offered[line] = run("bash", "-c", script).split()
    return offered


def fish(program, lines):
    file = f"{share}/fish/vendor_completions.d/{program}.fish"
    script = f"source {file}\n" + "\n".join(f"echo '== {line}'; complete -C '{line}'" for line in lines)
    return by_line(run("fish", "-c", script))


def zsh(program, lines):
    log = pathlib.Path(prefix, f"{program}-zsh.log")
    script = pathlib.Path(__file__).with_name("offered.zsh")
    run("zsh", script, f"{share}/zsh/vendor-completions", log, *lines)
    return by_line(log.read_text())


def by_line(log):
    """The first word of each line below "== LINE", by LINE."""
    parts = re.split(r"^== (.*)\n", log, flags=re.MULTILINE)[1:]
    return {line: re.findall(r"^[^\t\n]+", text, re.MULTILINE) for line, text in zip(parts[::2], parts[1::2])}


class Completion(unittest.TestCase):
    complete = staticmethod({"bash": bash, "zsh": zsh, "fish": fish}[shell])

    def test_every_subcommand_and_option_is_offered(self):
        for program in installed.programs(prefix):
            texts = installed.help_texts(program)
            offered = self.complete(program.name, [f"{name} {dashes}" for name in texts for dashes in ("", "-", "--")])
            for name, text in texts.items():
                self.assertGreaterEqual(set(offered[f"{name} "]), set(installed.subcommands(text)), name)
                for option in installed.options(text):
                    dashes = re.match("-+", option)[0]
                    self.assertIn(option, offered[f"{name} {dashes}"], name)

    def test_only_what_can_follow_is_offered(self):
        expected = {"settle schema c": ["campaign", "case"],
                    "settle run --fr": ["--fresh"], "settle run a.toml --set construction.l": ["construction.layers="]}
        offered = self.complete("settle", expected)
        for line, words in expected.items():
            self.assertEqual(sorted(set(offered[line]) - {"END"}), words, line)


if not shutil.which(shell):
    print(f"skipped: {shell} is not installed")
    sys.exit(77)
installed.install(build, prefix)
unittest.main(argv=sys.argv[:1])
