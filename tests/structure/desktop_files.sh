#!/bin/bash
# Fails unless what desktops are told of the window keeps to their rules, the icons it names are there, and a session is
# known by its contents, whatever it is called. Usage: desktop_files.sh ROOT HEXODERM_CLI
set -euo pipefail
files="$1/packaging/desktop"
desktop-file-validate "$files/hexoderm.desktop"
# There is no homepage. Where this is more than a hint, it can be made one; older versions don't know its name.
validate=(appstreamcli validate --no-net)
"${validate[@]}" --override=url-homepage-missing=info "$files/hexoderm.metainfo.xml" || "${validate[@]}" "$files/hexoderm.metainfo.xml"

for icon in "$(sed -n 's/^Icon=//p' "$files/hexoderm.desktop")" "$(sed -n 's/.*<icon name="\(.*\)".*/\1/p' "$files/hexoderm.mime.xml")"; do
  grep -q '<svg' "$1/resources/icons/$icon.svg"
done
type="$(sed -n 's/^MimeType=\(.*\);$/\1/p' "$files/hexoderm.desktop")"

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/mime/packages"
cp "$files/hexoderm.mime.xml" "$folder/mime/packages/hexoderm.xml"
update-mime-database "$folder/mime"
cd "$folder"
"$2" simulate --poses 1 -o session.hexo
cp session.hexo nameless
# An SQLite database of somebody else's.
head -c 4096 session.hexo | sed 's/HEXO/ELSE/' >other

# expect FILE TYPE
expect() {
  local found
  found="$(XDG_DATA_HOME="$folder" gio info -a standard::content-type "$1" | sed -n 's/.*content-type: //p')"
  [ "$found" = "$2" ] || { echo "$1: expected $2, found $found"; exit 1; }
}
expect session.hexo "$type"
expect nameless "$type"
expect other application/vnd.sqlite3
