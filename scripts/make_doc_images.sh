#!/usr/bin/env bash
# Makes the pictures of README.md and docs/ again. usage: scripts/make_doc_images.sh [PROGRAM]
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
program=${1:-$root/build/release/bin/gnomon}
images=$root/docs/images
mkdir -p "$images"

picture() {
  local name=$1
  shift
  "$program" render "$@" -o "$images/$name.png"
}

courtyard=(courtyard --size 480x320)
picture courtyard "${courtyard[@]}" --technique single/pcf
picture courtyard_mask "${courtyard[@]}" --technique single/pcf --show mask
picture courtyard_reference "${courtyard[@]}" --technique single/pcf --show reference
picture courtyard_error "${courtyard[@]}" --technique single/pcf --show error
picture courtyard_detail courtyard --camera detail --size 480x320 --technique single/pcf
picture terrain terrain --size 480x320 --technique single/pcf
