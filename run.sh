#!/usr/bin/env bash
# From a fresh machine to a report: installs what is missing, builds, compares every technique on one scene.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
source "$root/scripts/stage.sh"

usage() {
  cat <<'USAGE'
usage: ./run.sh [SCENE] [OPTION...]   compare the techniques on SCENE (default: courtyard); options as of 'gnomon compare'
       ./run.sh SUBCOMMAND ...        any subcommand of gnomon, e.g. ./run.sh list scenes
Results go to out/SCENE below this folder (out/FOLDER-FILE.EXTENSION for a file) unless -o says otherwise. Missing packages are installed (scripts/setup.sh), and
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

# The program itself says what it knows.
subcommands=$("$gnomon" --help | sed -n '/^Subcommands:/,$ s/^  \([a-z][a-z]*\).*/\1/p' | paste -sd ' ')
if [[ ${1:-} == --version || " $subcommands " == *" ${1:-none} "* ]]; then exec "$gnomon" "$@"; fi

scene=courtyard
if (($#)) && [[ $1 != -* ]]; then scene=$1; shift; fi
scenes=$("$gnomon" list scenes --json | sed -n 's/^ *"name": "\(.*\)",*$/\1/p' | paste -sd ' ')
if [[ $scene != *.* && $scene != */* && " $scenes " != *" $scene "* ]]; then
  echo "run.sh: '$scene' is neither a subcommand (${subcommands// /, }) nor a scene (${scenes// /, }, or a path to .obj, .gltf, .glb)" >&2
  exit 2
fi
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
  # Files of one name are told apart by their folder and extension: models/a.obj -> out/models-a.obj
  name=${scene//\//-}
  if [[ $scene == *.* && -e $scene ]]; then
    path=$(realpath -- "$scene")
    folder=${path%/*}
    name=${folder##*/}-${path##*/}
  fi
  output=$root/out/${name#-}
  arguments+=(-o "$output")
fi
# One of each kind, so that the first report is there in a minute or two; all: --techniques all.
if [[ " ${arguments[*]} " != *" --techniques"* && " ${arguments[*]} " != *" --preset"* ]]; then
  arguments+=(--techniques ray_traced,single/hard,single/pcf,single/vsm,cascaded/hard,cascaded/pcf,cascaded/pcss,sample_distribution/hard)
fi
"$gnomon" compare "$scene" "${arguments[@]}"
echo
echo "Report: $(realpath -- "$output/report.html")"
