# Completion of Hexoderm's programs for bash: they are asked with --help what they take.

_hexoderm() {
  local words=() word before program help commands options="" spelled value
  # "--option=value" comes as three words.
  for word in "${COMP_WORDS[@]:0:COMP_CWORD+1}"; do
    [ "$word" = = ] || words+=("$word")
  done
  [ "$word" != = ] || words+=("")
  before="${words[-2]}"

  program="${words[0]/#\~/$HOME}"
  help="$("$program" --help 2>/dev/null)"
  commands="$(sed -nE '/^Subcommands:/,/^$/s/^  ([a-z]+) .*/\1/p' <<<"$help")"
  for word in "${words[@]:1:${#words[@]}-2}"; do
    if grep -qxF -e "$word" <<<"$commands"; then
      commands=""
      help="$("$program" "$word" --help 2>/dev/null)"
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
