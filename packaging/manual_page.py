#!/usr/bin/env python3
"""manual_page.py PROGRAM: its manual page (groff, man macros) on standard output, made from what its --help says."""
import pathlib
import re
import sys

import help_text

programs = ["settle", "settle-mpm", "settle-fem"]


def roff(text):
    """Text with what groff would take for its own escaped: backslashes, hyphens, a dot or quote that opens a line."""
    return re.sub(r"^(?=[.'])", r"\\&", text.replace("\\", "\\e").replace("-", "\\-"), flags=re.MULTILINE)


def entry(item):
    names = ", ".join(f"\\fB{roff(name)}\\fR" for name in item.names)
    value = f" \\fI{roff(item.value)}\\fR" if item.value else ""
    return f".TP\n{names}{value}\n{roff(item.text)}\n"


def section(title, body):
    return f".SH {title}\n{body}" if body else ""


def arguments(text):
    return "".join(map(entry, text.positionals + text.options))


def usage(text):
    return f".B {roff(text.name)}\n{roff(text.usage.removeprefix(text.name).strip())}\n"


def command(text):
    return f".SS {roff(text.name)}\n{roff(text.purpose)}\n.PP\n{usage(text)}{arguments(text)}"


def exit_codes(footer):
    """A footer "Exit codes: 0 all passed, 1 …" as a list."""
    codes = re.findall(r"(\d+) (\D+)", footer.partition("Exit codes:")[2].replace("\n", " "))
    return "".join(f".TP\n.B {code}\n{roff(meaning.strip(' ,.'))}\n" for code, meaning in codes)


def references(name):
    return ",\n".join(f".BR {roff(other)} (1)" for other in programs if other != name) + "\n"


def page(program):
    name = pathlib.Path(program).name
    version = help_text.ask(program, "--version").split()[1]
    top, *commands = help_text.all_of(program, name)
    return (f'.TH {roff(name.upper())} 1 "" "settle {version}" "User Commands"\n'
            + section("NAME", f"{roff(name)} \\- {roff(top.purpose)}\n")
            + section("SYNOPSIS", usage(top))
            + section("OPTIONS", arguments(top))
            + section("COMMANDS", "".join(map(command, commands)))
            + section("EXIT STATUS", exit_codes(top.footer))
            + section("SEE ALSO", references(name)))


print(page(sys.argv[1]), end="")
