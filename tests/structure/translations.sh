#!/bin/bash
# Fails if a text that stands in the sources, the templates of core's messages included, has no finished translation, or
# if a translation does not take the arguments of its template, or has no key or dots where the text has them.
# Usage: translations.sh ROOT [FILE.ts]   (default: the German of the root)
set -euo pipefail
root="$1"
shipped="${2:-$root/resources/translations/hexoderm_de.ts}"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cp "$shipped" "$folder/updated.ts"
bash "$root/packaging/translations.sh" "$folder/updated.ts"

python3 - "$folder/updated.ts" <<'CODE'
import re
import sys
import xml.etree.ElementTree as tree


def marks(text):
    """The arguments and the key of a text of the window, and the dots that announce a dialog."""
    return set(re.findall(r"%[1-9]", text)), text.count("&"), text.endswith("…")


def placeholders(text):
    found = re.findall(r"\{(\d*)\}", text.replace("{{", "").replace("}}", ""))
    return sorted(number or str(k) for k, number in enumerate(found))


failed = False
for context in tree.parse(sys.argv[1]).getroot().findall("context"):
    for message in context.findall("message"):
        source, translation = message.findtext("source"), message.find("translation")
        if translation.get("type") == "unfinished" or not "".join(translation.itertext()).strip():
            print(f"{context.findtext('name')}: no translation of: {source}")
            failed = True
        elif context.findtext("name") == "hexoderm::Message" and placeholders(source) != placeholders(translation.text):
            print(f"The translation takes other arguments: {source}: {translation.text}")
            failed = True
        elif marks(source) != marks("".join(translation.itertext()).strip()):
            print(f"The translation has other arguments, keys or dots: {source}: {''.join(translation.itertext())}")
            failed = True
sys.exit(failed)
CODE
