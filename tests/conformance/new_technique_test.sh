#!/bin/bash
# A technique is one folder (docs/architecture.md): in a copy of the working tree, copies a filter with scripts/new_technique.sh,
# puts the tutorial's filter beside it (docs/adding_a_technique.md), builds, and checks that the copy is listed and renders like its
# model, that both pass the conformance tests, and that no other file was touched. Usage: new_technique_test.sh SOURCE_DIR WORK_DIR. The work folder is kept: later runs build only what changed.
set -eu
source=$1 work=$2
tree=$work/tree build=$work/build
fail() {
  echo "FAILED: $*" >&2
  exit 1
}

rm -rf "$tree"
mkdir -p "$tree" "$work/pictures"
# With their times, so that the kept build folder knows what is up to date.
(cd "$source" && git ls-files -z --cached --others --exclude-standard | while IFS= read -r -d '' file; do
  [ -e "$file" ] && printf '%s\0' "$file"
done | tar -c --null -T - -f -) | tar -x -C "$tree" -f -
cd "$tree"
export GIT_AUTHOR_DATE='2000-01-01T00:00:00Z' GIT_COMMITTER_DATE='2000-01-01T00:00:00Z'
git init -q .
git add -A
git -c user.name=test -c user.email=test@localhost -c core.hooksPath=/dev/null -c commit.gpgsign=false commit -q -m 'working tree'

scripts/new_technique.sh filter pcf pcf_copy
/usr/bin/python3 -B "$source/tests/documents/test_tutorial.py" --write "$tree"
touched=$(git status --porcelain | tr '\n' ' ')
expected='?? src/shadow/map/filter/my_filter/ ?? src/shadow/map/filter/pcf_copy/ '
[ "$touched" = "$expected" ] || fail "other files changed: $touched"

cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE='-O0 -DNDEBUG' >"$work/configure.log" 2>&1 ||
  { tail -20 "$work/configure.log"; fail 'configuring'; }
ninja -C "$build" gnomon gnomon_conformance_tests >"$work/build.log" 2>&1 || { tail -40 "$work/build.log"; fail 'building'; }

"$build/bin/gnomon" list techniques | grep -q 'single/pcf_copy' || fail "'gnomon list' does not show it"
"$build/bin/gnomon" describe single/pcf_copy | grep -q 'pcf_copy' || fail "'gnomon describe' does not know it"
for filter in pcf pcf_copy; do
  "$build/bin/gnomon" render chart/fence -o "$work/pictures/$filter.png" --size 96x72 --technique "single/$filter" --set "$filter.size=5" ||
    fail "rendering with $filter"
done
cmp "$work/pictures/pcf.png" "$work/pictures/pcf_copy.png" || fail 'the copy renders another picture than its model'

"$build/bin/gnomon_conformance_tests" --gtest_filter='*pcf_copy*:*my_filter*' >"$work/tests.log" 2>&1 || { tail -40 "$work/tests.log"; fail 'conformance'; }
for filter in pcf_copy my_filter; do
  grep -q "EveryTechnique.*single_$filter" "$work/tests.log" || fail "no conformance test of single/$filter ran"
done
grep -q 'EveryParameter.*pcf_copy_size' "$work/tests.log" || fail 'no conformance test of its parameters ran'
[ "$(git status --porcelain | tr '\n' ' ')" = "$expected" ] || fail 'the build touched the tree'
echo "pcf_copy, my_filter: $(grep -c '       OK' "$work/tests.log") conformance tests passed; two folders were added, nothing else changed"
