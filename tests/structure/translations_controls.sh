#!/bin/bash
# Shows that translations.sh misses a text without a translation, and that messages.py finds templates where they stand.
# Usage: translations_controls.sh ROOT
set -euo pipefail
root="$1"
check="$(dirname "${BASH_SOURCE[0]}")/translations.sh"
german="$root/resources/translations/hexoderm_de.ts"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
failed=0

refused() {
  if bash "$check" "$root" "$folder/changed.ts" >"$folder/said"; then
    echo "Not noticed: $1"
    failed=1
  elif ! grep -qF "$2" "$folder/said"; then
    echo "Noticed for another reason: $1"
    cat "$folder/said"
    failed=1
  fi
}

python3 - "$german" "$folder/changed.ts" <<'CODE'
import re
import sys
text = open(sys.argv[1], encoding="utf-8").read()
block = r"    <message>\n        <source>The skin has no cells\.</source>\n.*?    </message>\n"
changed, count = re.subn(block, "", text, flags=re.DOTALL)
assert count == 1, count
open(sys.argv[2], "w", encoding="utf-8").write(changed)
CODE
refused "a template of core without German" "hexoderm::Message: no translation of: The skin has no cells."

sed 's|<translation>{} und {}</translation>|<translation>{} und</translation>|' "$german" >"$folder/changed.ts"
refused "a translation that leaves an argument out" "The translation takes other arguments: {} and {}"

mkdir "$folder/core"
cat >"$folder/core/new.cpp" <<'CODE'
void f() {
  // message("in a comment");
  throw Error(located(file, message(
                                "a \"quoted\" {} in "
                                "two literals",
                                cell)));
  const Message message = other.message();
}
CODE
expected='QT_TRANSLATE_NOOP("hexoderm::Message", "a \"quoted\" {} in two literals")'
found="$(python3 "$root/packaging/messages.py" "$folder/core")"
if [ "$found" != "$expected" ]; then
  printf 'Templates were expected to be found as\n%s\nand were found as\n%s\n' "$expected" "$found"
  failed=1
fi
exit $failed
