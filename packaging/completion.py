#!/usr/bin/env python3
"""completion.py SHELL PROGRAM SETTLE: completion of a program for bash, zsh or fish on standard output, made from what
its --help says; the keys that --set takes are those of `SETTLE schema`.
"""
import pathlib
import re
import shlex
import sys

import help_text


def function_of(name):
    return "_" + re.sub(r"\W", "_", name)


def names(entries):
    return [name for entry in entries for name in entry.names]


def words(entries):
    return shlex.quote(" ".join(entries))


def bash_case(pattern, entries):
    return f"    {shlex.quote(pattern)}) echo {words(entries)} ;;\n" if entries else ""


bash_text = """# bash completion of @name@, made from its --help
@function@_commands() {
  case "$1" in
@commands@  esac
}

@function@_options() {
  case "$1" in
@options@  esac
}

# What may be given to an option, or (no option) for the positionals of a command.
@function@_values() {
  case "$1" in
@values@  esac
}

@function@() {
  local command=@name@ word current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} offered
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    [[ " $(@function@_commands "$command") " == *" $word "* ]] && command+=" $word"
  done
  offered=$(@function@_values "$command $previous")
  if [[ $offered == *= ]]; then
    compopt -o nospace 2>/dev/null
  elif [[ -z $offered && $current == -* ]]; then
    offered=$(@function@_options "$command")
  elif [[ -z $offered && $previous != -* ]]; then
    offered="$(@function@_commands "$command") $(@function@_values "$command")"
  fi
  mapfile -t COMPREPLY < <(compgen -W "$offered" -- "$current")
}
complete -o default -F @function@ @name@
"""


def bash(texts):
    """Everything is offered by functions of the command typed so far; where they offer nothing, files are."""
    values = ""
    for text in texts:
        values += bash_case(text.name, [choice for entry in text.positionals for choice in entry.choices])
        values += "".join(bash_case(f"{text.name} {name}", entry.choices) for entry in text.options
                          for name in entry.names)
    parts = {"name": texts[0].name, "function": function_of(texts[0].name), "values": values,
             "commands": "".join(bash_case(text.name, names(text.commands)) for text in texts),
             "options": "".join(bash_case(text.name, names(text.options)) for text in texts)}
    return re.sub("@(\\w+)@", lambda mark: parts[mark[1]], bash_text)


def zsh_value(entry):
    if not entry.value:
        return ""
    action = f"({' '.join(entry.choices)})" if entry.choices else "_files"
    return f":{re.sub('[^A-Za-z]+', ' ', entry.value).strip().lower()}:{action}"


def zsh_option(entry, name):
    text = re.sub(r"([][:\\])", r"\\\1", entry.text)
    return f"'*{name}'{shlex.quote(f'[{text}]{zsh_value(entry)}')}"


def zsh_function(text):
    """One command: its options, and its files or subcommands, each of which has a function of its own."""
    lines = [zsh_option(entry, name) for entry in text.options for name in entry.names]
    if not text.commands:
        lines += [shlex.quote(f"*{zsh_value(entry)}") for entry in text.positionals[-1:]]
        return f"{function_of(text.name)}() {{\n  _arguments {' '.join(lines)}\n}}\n"
    described = [shlex.quote(f"{each.names[0]}:{each.text}") for each in text.commands]
    inside = "".join(f"        {each.names[0]}) {function_of(f'{text.name} {each.names[0]}')} ;;\n"
                     for each in text.commands)
    return (f"{function_of(text.name)}() {{\n  local -a line commands=({' '.join(described)})\n  local state\n"
            f"  _arguments -C {' '.join(lines)} '1:command:->commands' '*::argument:->arguments'\n"
            "  case $state in\n    commands) _describe command commands ;;\n    arguments)\n      case $line[1] in\n"
            f"{inside}      esac ;;\n  esac\n}}\n")


def zsh(texts):
    name = texts[0].name
    return (f"#compdef {name}\n# zsh completion of {name}, made from its --help\n"
            + "\n".join(map(zsh_function, texts)) + f"\n{function_of(name)} \"$@\"\n")


def fish_condition(text):
    """Holds where this command has been typed, and no subcommand of it yet."""
    parts = [f"__fish_seen_subcommand_from {word}" for word in text.name.split()[1:]]
    if text.commands:
        parts.append(f"not __fish_seen_subcommand_from {' '.join(names(text.commands))}")
    return f" -n {shlex.quote('; and '.join(parts))}" if parts else ""


def fish_option(entry):
    typed = "".join(f" -l {name[2:]}" if name.startswith("--") else f" -s {name[1:]}" for name in entry.names)
    if not entry.value:
        return typed
    return f"{typed} -x -a {words(entry.choices)}" if entry.choices else f"{typed} -r"


def fish(texts):
    lines = [f"# fish completion of {texts[0].name}, made from its --help"]
    for text in texts:
        head = f"complete -c {texts[0].name}{fish_condition(text)}"
        lines += [f"{head} -f -a {each.names[0]} -d {shlex.quote(each.text)}" for each in text.commands]
        lines += [f"{head} -f -a {words(each.choices)}" for each in text.positionals if each.choices]
        lines += [f"{head}{fish_option(each)} -d {shlex.quote(each.text)}" for each in text.options]
    return "\n".join(lines) + "\n"


def completion(shell, program, settle):
    texts = help_text.all_of(program, pathlib.Path(program).name)
    keys = [f"{key}=" for key in help_text.case_keys(settle)]
    for text in texts:
        for option in text.options:
            if "--set" in option.names:
                option.choices = keys
    return {"bash": bash, "zsh": zsh, "fish": fish}[shell](texts)


print(completion(*sys.argv[1:]), end="")
