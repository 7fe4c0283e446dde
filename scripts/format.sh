#!/usr/bin/env bash
# clang-format (scripts/setup.sh --with-tools) over the C++ files that differ from HEAD, or over all with --all; --check only tells.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
all=0 mode=(-i)
for argument in "$@"; do
  case "$argument" in
    --all) all=1 ;;
    --check) mode=(--dry-run --Werror) ;;
    *) echo "format.sh: unknown option '$argument'; valid: --all, --check" >&2; exit 2 ;;
  esac
done
if ((all)); then
  mapfile -d '' files < <(git ls-files -z 'src/*.cpp' 'src/*.h' 'tests/*.cpp' 'tests/*.h')
else
  mapfile -d '' files < <(git diff -z --name-only --diff-filter=d HEAD -- 'src/*.cpp' 'src/*.h' 'tests/*.cpp' 'tests/*.h')
fi
if ((${#files[@]} == 0)); then echo "format.sh: no file to format" >&2; exit 0; fi
clang-format "${mode[@]}" "${files[@]}"
