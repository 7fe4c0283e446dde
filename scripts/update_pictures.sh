#!/usr/bin/env bash
# Makes the stored pictures of the picture tests again, after a change that is meant to be seen. Look at each before committing.
# usage: scripts/update_pictures.sh [PROGRAM]
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
program=${1:-$root/build/release/bin/gnomon}
exec /usr/bin/python3 -B "$root/tests/picture/test_pictures.py" --update "$program" "$root/tests/picture/expected"
