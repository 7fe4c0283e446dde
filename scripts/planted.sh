#!/usr/bin/env bash
# Planted mistakes: each patch of tests/planted goes into a copy of the tree, and the test that it names must then fail. The copy and
# its build folder stay below build/planted, so that a later run builds little; results of unchanged files are not made again.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
patches=$root/tests/planted work=$root/build/planted
tree=$work/tree build=$work/tree/build/release
limit_s=900 # of one test; a mistake may make it endless

usage() {
  cat <<'USAGE'
usage: scripts/planted.sh [--list | --check BUILD] [--touching FILE] [NAME...]
  NAME             a patch of tests/planted, without .patch; without names: all that have no result yet
  --touching FILE  only patches that change this file or folder; repeat for several
  --list           names, tests and reasons, and nothing is run
  --check BUILD    every patch applies, says what it must, and names tests that the build folder BUILD has; nothing is planted
The table is also in build/planted/table.txt. Exit code 1: a mistake survived without an argument, more than 5 % survived, or one
could not be built.
USAGE
}

# header PATCH KEY: the values of its lines '# KEY: value', before the diff.
header() { sed -n "/^diff /q; s/^# $2: *//p" "$patches/$1.patch"; }

# 'unit', 'gpu' and 'conformance' take the options of GoogleTest; 'cli/NAME' those of Python's unittest; all else is CTest's name.
run_test() { # BUILD TEST
  local words
  read -ra words <<<"$2"
  case "${words[0]}" in
    unit | gpu | conformance) timeout "$limit_s" "$1/bin/gnomon_${words[0]}_tests" "${words[@]:1}" --gtest_fail_fast ;;
    cli/*) GNOMON=$1/bin/gnomon timeout "$limit_s" /usr/bin/python3 -B "$tree/tests/cli/test_${words[0]#cli/}.py" -f "${words[@]:1}" ;;
    *) timeout "$limit_s" ctest --test-dir "$1" --no-tests=error --output-on-failure -R "^${words[0]}\$" ;;
  esac
}

target_of() { # TEST
  case "$1" in
    unit/*) ;;
    unit* | gpu* | conformance*) echo "gnomon_${1%% *}_tests" ;;
    web/*) echo gnomon_make_sample_report ;;
    *) echo gnomon ;;
  esac
}

# A filter that matches nothing passes, so a renamed test would never notice anything.
test_exists() { # BUILD TEST
  local words
  read -ra words <<<"$2"
  case "${words[0]}" in
    unit | gpu | conformance) "$1/bin/gnomon_${words[0]}_tests" "${words[@]:1}" --gtest_list_tests 2>/dev/null | grep -q '^  ' ;;
    cli/*)
      local file=$root/tests/cli/test_${words[0]#cli/}.py name
      [[ -f $file ]] || return 1
      for name in "${words[@]:1}"; do grep -q "def ${name##*.}(\|class ${name##*.}(" "$file" || return 1; done ;;
    *) ctest --test-dir "$1" -N -R "^${words[0]}\$" | grep -q 'Total Tests: [1-9]' ;;
  esac
}

complain() { echo "planted.sh: $*" >&2; }

check_patch() { # NAME
  local name=$1 key status=0
  for key in test why; do
    if [[ -z $(header "$name" "$key") ]]; then complain "tests/planted/$name.patch: no line '# $key: ...' before the diff"; status=1; fi
  done
  if ! git -C "$root" apply --check "$patches/$name.patch"; then
    complain "tests/planted/$name.patch does not apply: plant the same mistake in the file as it is now"; status=1
  fi
  return "$status"
}

list=0 check='' touching=() names=()
while (($#)); do
  case "$1" in
    -h | --help) usage; exit 0 ;;
    --list) list=1 ;;
    --check | --touching)
      if (($# < 2)); then usage >&2; exit 2; fi
      if [[ $1 == --check ]]; then check=$2; else touching+=("${2#"$root"/}"); fi
      shift ;;
    -*) usage >&2; exit 2 ;;
    *) names+=("$1") ;;
  esac
  shift
done

fresh=${#names[@]} # named ones are run even if they have a result
whole=0
if ((!fresh)); then
  mapfile -t names < <(cd "$patches" && ls -- *.patch | sed 's/\.patch$//')
  whole=$((!${#touching[@]}))
fi
selected=()
for name in "${names[@]}"; do
  if [[ ! -f $patches/$name.patch ]]; then complain "no patch '$name'; scripts/planted.sh --list names them"; exit 2; fi
  chosen=$((!${#touching[@]}))
  for file in ${touching[@]+"${touching[@]}"}; do
    if grep -q "^+++ b/${file%/}\(/\|\$\)" "$patches/$name.patch"; then chosen=1; fi
  done
  if ((chosen)); then selected+=("$name"); fi
done

if ((list)); then
  for name in ${selected[@]+"${selected[@]}"}; do
    printf '%s\n  %s\n' "$name" "$(header "$name" why)"
    header "$name" test | sed 's/^/  test: /'
    header "$name" survives | sed 's/^/  survives: /'
  done
  exit 0
fi

faulty=0
for name in ${selected[@]+"${selected[@]}"}; do check_patch "$name" || faulty=1; done
mapfile -t tests < <(for name in ${selected[@]+"${selected[@]}"}; do header "$name" test; done | sort -u)
must_exist() { # BUILD
  local test
  for test in ${tests[@]+"${tests[@]}"}; do
    if ! test_exists "$1" "$test"; then complain "there is no test '$test', which a patch of tests/planted names"; faulty=1; fi
  done
}
if [[ -n $check ]]; then must_exist "$check"; exit "$faulty"; fi
if ((faulty)); then exit 1; fi
if ((!${#selected[@]})); then complain "no patch touches that"; exit 2; fi

# The files as they lie, without the patches: a new patch makes no result old. Git's objects stand for their contents.
mkdir -p "$tree" "$work/log"
git_dir=$(git -C "$root" rev-parse --absolute-git-dir)
cp -- "$(git -C "$root" rev-parse --path-format=absolute --git-path index)" "$work/state_index"
export GIT_INDEX_FILE=$work/state_index
git -C "$root" add --all
git -C "$root" rm -rq --cached --ignore-unmatch tests/planted
state=$(git -C "$root" write-tree)
# Writes what differs alone, also what an interrupted run left planted.
in_tree() { GIT_INDEX_FILE=$work/index git -C "$tree" --git-dir="$git_dir" --work-tree="$tree" "$@"; }
in_tree read-tree --reset -u "$state"
unset GIT_INDEX_FILE

build_for() { # TEST...: only what they run
  local target targets=()
  mapfile -t targets < <(for target in "$@"; do target_of "$target"; done | sort -u)
  if ((${#targets[@]})); then cmake --build "$build" --target "${targets[@]}"; fi
}

# known FILE KEY: what was noted there for the key.
note() { printf '%s\t%s\n' "$2" "$3" >>"$work/$1"; }
known() { awk -F'\t' -v key="$2" '$1 == key { value = $2 "\t" $3 } END { printf "%s", value }' "$work/$1" 2>/dev/null || true; }

echo "configure and build without a mistake"
if ! { (cd "$tree" && cmake --log-level=NOTICE --preset release) && build_for "${tests[@]}"; } >"$work/log/unplanted.log" 2>&1; then
  complain "the tree does not build: $work/log/unplanted.log"; exit 1
fi
must_exist "$build"
if ((faulty)); then exit 1; fi
for test in "${tests[@]}"; do
  if [[ -n $(known passed.tsv "$state $test") ]]; then continue; fi
  start=$SECONDS
  if ! run_test "$build" "$test" >"$work/log/unplanted.log" 2>&1; then
    complain "'$test' fails without any mistake: $work/log/unplanted.log"; exit 1
  fi
  echo "passes: $test, $((SECONDS - start)) s"
  note passed.tsv "$state $test" passed
done

# outcome NAME: its status, after building and running what it names.
outcome() {
  local log=$work/log/$1.log tests test status
  mapfile -t tests < <(header "$1" test)
  if ! build_for "${tests[@]}" >"$log" 2>&1; then echo "no build"; return; fi
  for test in "${tests[@]}"; do
    status=0
    run_test "$build" "$test" >>"$log" 2>&1 || status=$?
    if ((status == 124)); then echo "caught (timed out)"; return; fi
    if ((status)); then echo caught; return; fi
  done
  if [[ -n $(header "$1" survives) ]]; then echo "survived (argued)"; else echo SURVIVED; fi
}

for name in "${selected[@]}"; do
  key="$state $name $(git hash-object "$patches/$name.patch")"
  if ((!fresh)) && [[ -n $(known results.tsv "$key") ]]; then continue; fi
  start=$SECONDS
  in_tree apply "$patches/$name.patch"
  status=$(outcome "$name")
  in_tree apply -R "$patches/$name.patch"
  note results.tsv "$key" "$status"$'\t'"$((SECONDS - start))"
  printf '%-44s %-20s %4d s\n' "$name" "$status" "$((SECONDS - start))"
done

{
  for name in "${selected[@]}"; do
    IFS=$'\t' read -r status seconds < <(known results.tsv "$state $name $(git hash-object "$patches/$name.patch")"; echo)
    printf '%-44s %-20s %4d s\n' "$name" "$status" "$seconds"
  done
} >"$work/table.txt"
echo
cat "$work/table.txt"
count() { grep -c " $1" "$work/table.txt" || true; }
survived=$(($(count 'SURVIVED ') + $(count 'survived ')))
printf '%d mistakes: %d caught, %d survived (%d argued), %d not built\n' "${#selected[@]}" "$(count 'caught')" "$survived" \
  "$(count 'survived (argued)')" "$(count 'no build')"
if (($(count 'SURVIVED ') || $(count 'no build'))); then exit 1; fi
if ((whole && survived * 20 > ${#selected[@]})); then exit 1; fi
