#!/usr/bin/env bash
# From a fresh machine to a report: installs what is missing, builds, compares every technique on one scene.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
source "$root/scripts/stage.sh"

usage() {
  cat <<'USAGE'
usage: ./run.sh [SCENE] [OPTION...]   compare the techniques on SCENE (default: courtyard); options as of 'gnomon compare'
       ./run.sh SUBCOMMAND ...        any subcommand of gnomon, e.g. ./run.sh list scenes
Results go to out/SCENE below this folder unless -o says otherwise. Missing packages are installed (scripts/setup.sh), and
the program is built, before the first run; later runs start at once.
USAGE
}

gnomon=$root/build/release/bin/gnomon
if [[ ${1:-} == -h || ${1:-} == --help ]]; then
  usage
  if [[ -x $gnomon ]]; then echo; "$gnomon" compare --help; fi
  exit 0
fi

prepare "$root" --without-web
stage build cmake --build "$root/build/release" --target gnomon

case "${1:-}" in
  list | describe | render | compare | sweep | tune | bench | bake | report | view | doctor | --version) exec "$gnomon" "$@" ;;
esac

scene=courtyard
if (($#)) && [[ $1 != -* ]]; then scene=$1; shift; fi
output=""
arguments=("$@")
for ((i = 0; i < ${#arguments[@]}; ++i)); do
  case "${arguments[i]}" in
    -o | --output) output=${arguments[i + 1]:-} ;;
    --output=*) output=${arguments[i]#--output=} ;;
    -o?*) output=${arguments[i]#-o} ;;
  esac
done
if [[ -z $output ]]; then
  name=${scene##*/}
  output=$root/out/${name%.*}
  arguments+=(-o "$output")
fi
"$gnomon" compare "$scene" "${arguments[@]}"
echo
echo "Report: $(realpath -- "$output/report.html")"
