# Completion of Hexoderm's programs for bash: they are asked with --help what they take.

# The help of a program, or of one of its commands. Nobody waits long for one that does not answer.
_hexoderm_help() {
  local limit=()
  type -P timeout >/dev/null && limit=(timeout 2)
  "${limit[@]}" "$@" --help </dev/null 2>/dev/null
}

_hexoderm() {
  local words=() word before program help commands options="" spelled value
  # "--option=value" comes as three words.
  for word in "${COMP_WORDS[@]:0:COMP_CWORD+1}"; do
    [ "$word" = = ] || words+=("$word")
  done
  [ "$word" != = ] || words+=("")
  before="${words[-2]}"

  # It comes as it is typed: without quotes and backslashes it is the name of a file, or else there may be one on PATH.
  program="${words[0]//[\\\"\']/}"
  program="${program/#\~/$HOME}"
  program="$(type -P "$program" || type -P "${program##*/}")"
  help="$(_hexoderm_help "$program")"
  commands="$(sed -nE '/^Subcommands:/,/^$/s/^  ([a-z]+) .*/\1/p' <<<"$help")"
  for word in "${words[@]:1:${#words[@]}-2}"; do
    if grep -qxF -e "$word" <<<"$commands"; then
      commands=""
      help="$(_hexoderm_help "$program" "$word")"
      break
    fi
  done

  word="${words[-1]}"
  # Of "  -o,--output OUTPUT Needs: --source   Keep the poses": how it is spelled, and the value after it.
  while read -r spelled value; do
    options+=" ${spelled//,/ }"
    if [ -n "$value" ] && [[ ",$spelled," == *",$before,"* ]]; then
      commands=""
      [[ "$value" =~ :\{(.*)\} ]] && commands="${BASH_REMATCH[1]//,/ }"
      options="$commands"
      break
    fi
  done < <(sed -nE '/^ +-/{s/^ +//; s/, -/,-/; s/  .*| (Needs|Excludes):.*//; p}' <<<"$help")
  [[ "$word" != -* ]] || commands="$options"

  if [ -n "$commands" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$word")
  else
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}
complete -F _hexoderm hexoderm hexoderm-cli hexoderm-emulator hexoderm-ros
