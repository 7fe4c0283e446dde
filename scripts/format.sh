#!/usr/bin/env bash
# clang-format over the C++ files of the tree; --check only tells which lines are not as it would write them. Its versions differ in
# details, so it is version 14 (Debian 12's) wherever that exists; with another version --check says so and ends with 77 (skipped).
# It does not know GLSL: shaders are wrapped by hand, and checked for lines beyond 128 columns.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
mode=(-i)
for argument in "$@"; do
  case "$argument" in
    --check) mode=(--dry-run --Werror) ;;
    *) echo "format.sh: unknown option '$argument'; valid: --check" >&2; exit 2 ;;
  esac
done
mapfile -d '' shaders < <(git ls-files -z 'src/*.'{glsl,comp,vert,frag,geom,mesh,task,rgen,rmiss,rahit,rchit,in})
long=$(awk 'length($0) > 128 {print FILENAME ":" FNR ": " length($0) " columns; a line of a shader has 128 at most"}' "${shaders[@]}")
if [[ -n $long ]]; then printf '%s\n' "$long" >&2; exit 1; fi

clang_format=$(command -v clang-format-14 || command -v clang-format) || { echo "format.sh: clang-format is missing (scripts/setup.sh)" >&2; exit 1; }
version=$("$clang_format" --version)
if [[ ! $version =~ version\ 14\. ]]; then
  echo "format.sh: the tree is formatted by clang-format 14; this is '$version'" >&2
  if [[ ${mode[0]} == --dry-run ]]; then exit 77; fi
fi
git ls-files -z 'src/*.cpp' 'src/*.h' 'tests/*.cpp' 'tests/*.h' 'bench/*.cpp' 'examples/*.cpp' 'examples/*.h' |
  xargs -0 --no-run-if-empty -P "$(nproc)" -n 40 "$clang_format" "${mode[@]}"
