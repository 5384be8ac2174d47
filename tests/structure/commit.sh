#!/bin/bash
# Fails unless the source that says the commit has that of the sources: none without git and in a checkout of something
# else, and unless it stays untouched where the commit is the same. Usage: commit.sh ROOT CMAKE GIT
set -euo pipefail
script="$1/packaging/cmake/commit.cmake"
cmake="$2"
git="$3"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1

# expect WHAT COMMIT SOURCES [GIT [COMMIT_GIVEN]]
expect() {
  "$cmake" -D "SOURCES=$3" -D "GIT=${4-$git}" -D "COMMIT=${5-}" -D "OUTPUT=$folder/commit.cpp" -P "$script"
  grep -qxF "const char* const kCommit = \"$2\";" "$folder/commit.cpp" ||
    { echo "$1: expected \"$2\", found"; cat "$folder/commit.cpp"; exit 1; }
}

sources="$folder/sources"
mkdir -p "$sources/inner"
in_git() { "$git" -C "$sources" -c user.name=n -c user.email=e "$@"; }
expect "no repository" "" "$sources"
in_git init -q
expect "a repository without a commit" "" "$sources"
echo 1 >"$sources/file"
in_git add file
in_git commit -qm 1
commit="$(in_git rev-parse HEAD)"
expect "a checkout" "$commit" "$sources"
touch -d '2020-01-01' "$folder/commit.cpp"
expect "a checkout" "$commit" "$sources"
[ "$(date -r "$folder/commit.cpp" +%Y)" = 2020 ] || { echo "the source is written though nothing changed"; exit 1; }
echo 2 >"$sources/other"
expect "a checkout with a file that is not git's" "$commit" "$sources"
echo 2 >"$sources/file"
expect "a checkout with changes" "$commit with changes" "$sources"
expect "sources within a checkout of something else" "" "$sources/inner"
expect "no git" "" "$sources" ""
expect "a commit that is given" "1.2-3~x" "$sources" "$git" "1.2-3~x\""
