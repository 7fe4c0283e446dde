#!/usr/bin/env bash
# Makes the pictures of docs/viewer.md again, with the viewer itself on a display of its own. usage: scripts/viewer_screenshots.sh [NAME...]
# GNOMON names another program than build/release/bin/gnomon.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
command -v pngquant >/dev/null || { echo "viewer_screenshots.sh: pngquant is missing; scripts/setup.sh --with-tools installs it" >&2; exit 1; }
export GNOMON=${GNOMON:-$root/build/release/bin/gnomon}
exec /usr/bin/python3 -B "$root/tests/window/screenshots.py" "$root/docs/images/viewer" "$@"
