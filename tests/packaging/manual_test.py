"""manual_test.py BUILD SCRATCH: the manual pages that are installed say all that the programs' --help says."""
import re
import subprocess
import sys
import unittest

import installed

build, prefix = sys.argv[1:3]


def page(program):
    """The manual page as text: without font changes and escaped hyphens."""
    with open(f"{prefix}/share/man/man1/{program.name}.1") as file:
        return re.sub(r"\\f[BIR]|\\&", "", file.read()).replace("\\-", "-").replace("\\e", "\\")


def part(text, name):
    """The part on a subcommand, or the one on the program's own options."""
    start = f"\n.SS {name}\n" if " " in name else "\n.SH OPTIONS\n"
    return re.split(r"\n\.S[SH] ", text.split(start)[1])[0]


class ManualPages(unittest.TestCase):
    def test_every_option_of_every_command_is_explained(self):
        for program in installed.programs(prefix):
            text = page(program)
            for name, help_text in installed.help_texts(program).items():
                wanted = installed.options(help_text)
                self.assertIn("--help", wanted)
                for option in wanted:
                    with self.subTest(command=name, option=option):
                        explained = re.search(rf"^\.TP\n.*(?<![\w-]){option}(?![\w-]).*\n\S", part(text, name), re.MULTILINE)
                        self.assertTrue(explained)

    def test_every_exit_code_is_listed(self):
        for program in installed.programs(prefix):
            codes = re.findall(r"\b\d+\b", installed.output(program, "--help").partition("Exit codes:")[2])
            self.assertIn("2", codes, program.name)
            listed = re.findall(r"^\.B (\d+)$", page(program).partition("EXIT STATUS")[2], re.MULTILINE)
            self.assertEqual(listed, codes, program.name)

    def test_groff_has_nothing_to_complain_about(self):
        for program in installed.programs(prefix):
            file = f"{prefix}/share/man/man1/{program.name}.1"
            done = subprocess.run(["groff", "-man", "-ww", "-z", file], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""), program.name)


installed.install(build, prefix)
unittest.main(argv=sys.argv[:1])
