"""completion_test.py BUILD SCRATCH: the shells themselves offer every subcommand and option, by the installed files."""
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import installed

build, prefix = sys.argv[1:3]
share = f"{prefix}/share"
needs = {shell: unittest.skipUnless(shutil.which(shell), f"{shell} is not installed") for shell in ("bash", "zsh", "fish")}

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


class Completions(unittest.TestCase):
    def everything_is_offered(self, complete):
        for program in installed.programs(prefix):
            texts = installed.help_texts(program)
            offered = complete(program.name, [f"{name} {dashes}" for name in texts for dashes in ("", "-", "--")])
            for name, text in texts.items():
                self.assertGreaterEqual(set(offered[f"{name} "]), set(installed.subcommands(text)), name)
                for option in installed.options(text):
                    dashes = re.match("-+", option)[0]
                    self.assertIn(option, offered[f"{name} {dashes}"], name)

    @needs["bash"]
    def test_bash_offers_every_subcommand_and_option(self):
        self.everything_is_offered(bash)

    @needs["fish"]
    def test_fish_offers_every_subcommand_and_option(self):
        self.everything_is_offered(fish)

    @needs["zsh"]
    def test_zsh_offers_every_subcommand_and_option(self):
        self.everything_is_offered(zsh)

    def only_what_can_follow_is_offered(self, complete):
        expected = {"settle run --solvers ": ["fem", "mpm"], "settle schema c": ["campaign", "case"],
                    "settle run --fr": ["--fresh"], "settle run a.toml --set construction.l": ["construction.layers="]}
        offered = complete("settle", expected)
        for line, words in expected.items():
            self.assertEqual(sorted(set(offered[line]) - {"END"}), words, line)

    @needs["bash"]
    def test_bash_offers_only_what_can_follow(self):
        self.only_what_can_follow_is_offered(bash)

    @needs["fish"]
    def test_fish_offers_only_what_can_follow(self):
        self.only_what_can_follow_is_offered(fish)

    @needs["zsh"]
    def test_zsh_offers_only_what_can_follow(self):
        self.only_what_can_follow_is_offered(zsh)


installed.install(build, prefix)
unittest.main(argv=sys.argv[:1])
