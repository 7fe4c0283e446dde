# Sourced by run.sh and test.sh: what both of them do before their own work.
# The distribution's tools come first: shims of pyenv, conda and the like neither have nor find the distribution's packages.
export PATH="/usr/bin:/bin:$PATH"

# stage NAME COMMAND...: one line with the time on stderr. The command's output is shown on a terminal, and when it fails.
stage() {
  local name=$1 start=$EPOCHREALTIME output status=0
  shift
  if [[ -t 2 ]]; then
    "$@" >&2 || status=$?
  else
    output=$(mktemp)
    "$@" >"$output" 2>&1 || status=$?
    if ((status)); then cat -- "$output" >&2; fi
    rm -f -- "$output"
  fi
  local result=done
  if ((status)); then result="failed ($status)"; fi
  LC_ALL=C awk -v name="$name" -v result="$result" -v start="$start" -v stop="$EPOCHREALTIME" \
    'BEGIN { sub(",", ".", start); sub(",", ".", stop); printf "== %-10s %s, %.1f s\n", name, result, stop - start }' >&2
  return "$status"
}

# prepare ROOT SETUP_OPTION...: packages and build system of the release preset.
prepare() {
  local root=$1
  shift
  stage set-up "$root/scripts/setup.sh" "$@"
  stage configure cmake --log-level=NOTICE -S "$root" --preset release
}
