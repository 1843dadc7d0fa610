"""What the programs' own --help says, as data: the one source of manual pages and completions."""
import dataclasses
import json
import re
import subprocess


@dataclasses.dataclass
class Entry:
    """One line of a list: `names` ("-j", "--jobs"; or a positional's or subcommand's name), `value` ("INT:POSITIVE")."""

    names: list
    value: str
    text: str
    choices: list = dataclasses.field(default_factory=list)  # the words that may be given; none: anything

    def __post_init__(self):
        if words := re.search(r"\{([^}]*)\}", self.value):
            self.choices = words[1].split(",")


@dataclasses.dataclass
class Help:
    """One program or subcommand: `name` as it is typed ("settle run")."""

    name: str
    purpose: str
    usage: str
    positionals: list = dataclasses.field(default_factory=list)
    options: list = dataclasses.field(default_factory=list)
    commands: list = dataclasses.field(default_factory=list)
    footer: str = ""

    def list_of(self, title, entry):
        """The list an entry of a block with this title belongs to."""
        if entry.names[0].startswith("-"):
            return self.options
        return self.positionals if title == "Positionals:" else self.commands


def entries_of(lines):
    """The entries of one block: two blanks, what is typed, two blanks or a new line, what it means."""
    entries = []
    for line in lines:
        if match := re.fullmatch(r"  (\S.*?)(?:  +(\S.*))?", line):
            typed, _, value = match[1].partition(" ")
            entries.append(Entry(typed.split(","), value.strip(), match[2] or ""))
        elif entries:
            entries[-1].text = f"{entries[-1].text} {line.strip()}".strip()
    return entries


def parse(name, text):
    """The help of `name`: purpose and usage, blocks of entries under a title, and what stands after them."""
    head, *blocks = re.split(r"\n\n(?=\S)", text.strip("\n"))
    purpose, _, usage = head.partition("\n")
    parsed = Help(name, purpose.strip(), usage.removeprefix("Usage: ").strip())
    for block in blocks:
        title, _, body = block.partition("\n")
        if title.endswith(":") and body.startswith("  "):
            for entry in entries_of(body.splitlines()):
                parsed.list_of(title, entry).append(entry)
        else:
            parsed.footer += ("\n\n" if parsed.footer else "") + block
    return parsed


def ask(program, *words):
    return subprocess.run([program, *words], check=True, capture_output=True, text=True).stdout


def all_of(program, name, *words):
    """The help of a program, or of its subcommand `words`, and of all subcommands below, depth first."""
    top = parse(" ".join([name, *words]), ask(program, *words, "--help"))
    below = [all_of(program, name, *words, command.names[0]) for command in top.commands]
    return [top] + [text for texts in below for text in texts]


def keys_of(schema, path=""):
    """The dotted keys of a JSON Schema of `settle schema`; what lies below names that people choose is left out."""
    if "properties" not in schema:
        return [] if schema.get("type") == "object" or "properties" in schema.get("items", {}) else [path]
    inside = schema["properties"].items()
    return [key for name, each in inside for key in keys_of(each, f"{path}.{name}" if path else name)]


def case_keys(settle):
    """What --set takes: the dotted keys of a case."""
    return keys_of(json.loads(ask(settle, "schema", "case")))
