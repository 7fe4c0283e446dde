#!/bin/sh
# Starts a new technique as a copy of one that exists: copies its folder, renames the files and the name inside them.
# Nothing else needs an edit (docs/architecture.md, "Adding a technique"). Usage: scripts/new_technique.sh KIND FROM TO
# KIND: projection, filter or direct.
set -eu

usage() {
  echo "usage: scripts/new_technique.sh projection|filter|direct FROM TO" >&2
  exit 2
}
[ $# -eq 3 ] || usage
kind=$1 from=$2 to=$3
case $kind in
  projection | filter) folder=src/shadow/map/$kind ;;
  direct) folder=src/shadow/direct ;;
  *) usage ;;
esac
cd "$(dirname "$0")/.."
if [ ! -d "$folder/$from" ]; then
  echo "$folder/$from: there is no such technique; there are: $(ls "$folder" | tr '\n' ' ')" >&2
  exit 2
fi
case $to in
  '' | *[!a-z0-9_]* | [!a-z]*)
    echo "'$to': a name is made of a-z, 0-9 and _, and begins with a letter" >&2
    exit 2
    ;;
esac
# One namespace for all: --set NAME.key=value.
for taken in src/shadow/map/projection src/shadow/map/filter src/shadow/direct; do
  if [ -e "$taken/$to" ]; then
    echo "$taken/$to exists already" >&2
    exit 2
  fi
done

cp -R "$folder/$from" "$folder/$to"
for file in "$folder/$to"/*; do
  case $(basename "$file") in
    "$from".* | "${from}_"*)
      renamed=$folder/$to/$to${file#"$folder/$to/$from"}
      mv "$file" "$renamed"
      file=$renamed
      ;;
  esac
  # The name where it is a name: NAME.key, NAME.glsl, /NAME/. A word of the text such as "hard" stays.
  sed -i -e "s/\\b$from\\.\\([a-z]\\)/$to.\\1/g" -e "s,/$from/,/$to/,g" "$file"
done
echo "made $folder/$to"
