#!/usr/bin/env python3
"""Writes the completion of a program's command line for bash, made of what --help says.

Usage: bash_completion.py PROGRAM FILE
"""

import pathlib
import re
import sys

import help_text

SCRIPT = """\
# Completion of {program} for bash, made of what it says with --help.

{function}() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" command="" before="" at
  COMPREPLY=()
  # "--option=value" comes as three words.
  if [ "$word" = = ]; then word=""; fi
  before="${{COMP_WORDS[COMP_CWORD - 1]}}"
  if [ "$before" = = ] && [ "$COMP_CWORD" -ge 2 ]; then before="${{COMP_WORDS[COMP_CWORD - 2]}}"; fi
  if [ "${{COMP_WORDS[COMP_CWORD]}}" = = ]; then before="${{COMP_WORDS[COMP_CWORD - 1]}}"; fi
  for ((at = 1; at < COMP_CWORD; ++at)); do
    case "${{COMP_WORDS[at]}}" in
      {commands_pattern}) command="${{COMP_WORDS[at]}}"; break ;;
    esac
  done

  local options="" takes="" commands=""
  case "$command" in
{cases}
  esac
  case "$command $before" in
{choices}
  esac
  if [[ " $takes " == *" $before "* ]]; then
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  elif [[ "$word" == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  elif [ -n "$commands" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$word")
  else
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}}
complete -F {function} {program}
"""


def case_of(helped, commands):
    """The branch of a command with its options, and with those that take a value."""
    options = [spelling for option in helped.options() for spelling in option.spellings()]
    takes = [spelling for option in helped.options() if option.takes_value() for spelling in option.spellings()]
    name = helped.words[1] if len(helped.words) > 1 else '""'
    return (f'    {name})\n      options="{" ".join(options)}"\n      takes="{" ".join(takes)}"\n'
            f'      commands="{" ".join(commands)}"\n      ;;')


def choices_of(helped):
    """The branches of options whose values are known."""
    command = helped.words[1] if len(helped.words) > 1 else ""
    for option in helped.options():
        if option.choices():
            pattern = " | ".join(f'"{command} {spelling}"' for spelling in option.spellings())
            yield (f'    {pattern})\n      mapfile -t COMPREPLY < <(compgen -W "{" ".join(option.choices())}" -- "$word")\n'
                   "      return\n      ;;")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, file = sys.argv[1:]
    first, *others = help_text.all_helps(program)
    commands = [helped.words[1] for helped in others]
    cases = [case_of(first, commands)] + [case_of(helped, []) for helped in others]
    choices = [branch for helped in [first, *others] for branch in choices_of(helped)]
    script = SCRIPT.format(program=first.words[0], function="_" + re.sub(r"\W", "_", first.words[0]),
                           commands_pattern=" | ".join(commands) or '""', cases="\n".join(cases),
                           choices="\n".join(choices) or "    *) ;;")
    pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
    pathlib.Path(file).write_text(script, encoding="utf-8")


if __name__ == "__main__":
    main()
