#!/usr/bin/env bash
# From a fresh machine to a test result: installs what is missing, builds everything, runs the tests under validation.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
source "$root/scripts/stage.sh"

usage() {
  cat <<'USAGE'
usage: ./test.sh [--all] [--label L] [CTEST OPTION...]
  --all       also the tests labelled 'slow'
  --label L   only the tests of one label: unit, gpu, conformance, picture, cli, web, window, fuzz; repeat for several
Other arguments go to ctest, e.g. ./test.sh -R unit/check_layers
USAGE
}

all=0 labels=() others=()
while (($#)); do
  case "$1" in
    -h | --help) usage; exit 0 ;;
    --all) all=1 ;;
    --label)
      if (($# < 2)); then usage >&2; exit 2; fi
      labels+=("$2"); shift ;;
    --label=*) labels+=("${1#--label=}") ;;
    *) others+=("$1") ;;
  esac
  shift
done

prepare "$root"
stage build cmake --build "$root/build/release"

# More than a few at a time gain nothing: on a software device every test uses all cores by itself.
jobs=$(nproc)
if ((jobs > 4)); then jobs=4; fi
arguments=(--test-dir "$root/build/release" --output-on-failure --no-tests=error -j "$jobs")
if ((!all)); then arguments+=(-LE '^slow$'); fi
if ((${#labels[@]})); then arguments+=(-L "^($(IFS='|'; echo "${labels[*]}"))\$"); fi
GNOMON_VALIDATE=1 exec ctest "${arguments[@]}" ${others[@]+"${others[@]}"}
