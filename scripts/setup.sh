#!/usr/bin/env bash
# Installs what gnomon needs from the distribution's own package archive, only what is missing, and says why.
# Works as root or through sudo. Known to the script: Debian 12, Debian 13, Ubuntu 24.04.
# usage: scripts/setup.sh [--without-web] [--with-tools] [--list]
set -euo pipefail

web=1 tools=0 list=0
for argument in "$@"; do
  case "$argument" in
    --without-web) web=0 ;;
    --with-tools) tools=1 ;;
    --list) list=1 ;;
    *) echo "setup.sh: unknown option '$argument'; valid: --without-web, --with-tools, --list" >&2; exit 2 ;;
  esac
done

# package | why it is needed
packages=(
  "g++|C++20 compiler"
  "cmake|build system"
  "ninja-build|build system"
  "ccache|repeated builds cost nothing"
  "git|the commit that results.jsonl records"
  "glslc|GLSL to SPIR-V at build time, and of shaders edited while gnomon view runs"
  "libvulkan-dev|Vulkan headers and loader"
  "vulkan-validationlayers|validation of every test run"
  "mesa-vulkan-drivers|Vulkan on the CPU (lavapipe), and drivers of common GPUs"
  "libvulkan-memory-allocator-dev|GPU memory"
  "libglm-dev|vectors and matrices"
  "libtinygltf-dev|glTF 2.0"
  "libdraco-dev|KHR_draco_mesh_compression"
  "libmeshoptimizer-dev|EXT_meshopt_compression, vertex cache order"
  "libstb-dev|PNG and JPEG"
  "libwebp-dev|WebP pictures"
  "libopenexr-dev|EXR pictures"
  "libembree-dev|ray-traced reference on the CPU"
  "libtbb-dev|threads of the CPU reference"
  "libglfw3-dev|window of gnomon view"
  "libimgui-dev|panels of gnomon view"
  "xvfb|window tests: a display without a screen"
  "openbox|window tests: a window manager, which minimises and closes"
  "python3-xlib|window tests: keys, mouse, drag and drop"
  "libspdlog-dev|log"
  "libfmt-dev|text formatting"
  "libcli11-dev|command line"
  "nlohmann-json3-dev|results and settings"
  "libjs-chart.js|charts of the report"
  "libgtest-dev|tests"
  "libbenchmark-dev|benchmarks"
  "clang-format|a test that holds the formatting"
  "python3|scripts and tests"
)
. /etc/os-release
# The web tests drive the report in a real browser. Ubuntu has Chromium as a snap only: it is left to the user there.
if ((web)); then
  packages+=("python3-selenium|web tests")
  if [[ ${ID:-} == ubuntu ]]; then
    command -v chromedriver >/dev/null || echo "setup: the web tests need chromium and chromedriver: 'snap install chromium' provides both" >&2
  else
    packages+=("chromium|web tests" "chromium-driver|web tests")
  fi
fi
# The run-time of libFuzzer and the sanitizers carries the version of the distribution's clang in its name.
case ${VERSION_CODENAME:-} in trixie) clang=19 ;; noble) clang=18 ;; *) clang=14 ;; esac
if ((tools)); then
  packages+=("clang|fuzz and tidy presets" "clang-tidy|tidy preset" "pngquant|small pictures in the documents"
             "libclang-rt-$clang-dev|libFuzzer and sanitizer run-time")
fi

if ((list)); then printf '%s\n' "${packages[@]}"; exit 0; fi

# One question for all: dpkg reads its whole database for each.
present=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${packages[@]%%|*}" 2>/dev/null || true)
installed() { grep -qxF "installed $1" <<<"$present"; }
# The Mesa of Debian 12 has no ray tracing; 25 does.
mesa_major() { dpkg-query -W -f='${Version}' mesa-vulkan-drivers 2>/dev/null | sed 's/^[0-9]*://; s/[.].*//'; }

missing=()
for entry in "${packages[@]}"; do
  name=${entry%%|*}
  if ! installed "$name"; then missing+=("$entry"); fi
done
newer_mesa=0
if [[ ${VERSION_CODENAME:-} == bookworm ]] && installed mesa-vulkan-drivers && (( $(mesa_major) < 24 )); then
  newer_mesa=1
fi
if ((${#missing[@]} == 0 && newer_mesa == 0)); then echo "setup: all packages are present" >&2; exit 0; fi

as_root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null || { echo "setup.sh: packages are missing and neither root nor sudo is available: ${missing[*]%%|*}" >&2; exit 1; }
  as_root=(sudo)
fi
export DEBIAN_FRONTEND=noninteractive
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o Dpkg::Use-Pty=0 -qq "$@"; }

# On Debian 12 two packages come from newer suites of the archive that the system already uses. The pins keep every other
# package on its own suite.
if [[ ${VERSION_CODENAME:-} == bookworm ]]; then
  archive=$(grep -rhoE '(https?|file|mirror\+file):[^ ]+/debian/?( |$)' /etc/apt/sources.list /etc/apt/sources.list.d 2>/dev/null | head -n 1 | tr -d ' ' || true)
  [[ -n $archive ]] || { echo "setup.sh: no Debian archive found in /etc/apt; add one whose address ends in /debian" >&2; exit 1; }
  sources=$(mktemp) pins=$(mktemp)
  printf 'Types: deb\nURIs: %s\nSuites: bookworm-backports trixie\nComponents: main\nSigned-By: /usr/share/keyrings/debian-archive-keyring.gpg\n' "$archive" >"$sources"
  cat >"$pins" <<'PINS'
Package: *
Pin: release n=trixie
Pin-Priority: -1

Package: libvulkan-memory-allocator-dev
Pin: release n=trixie
Pin-Priority: 500

Package: *
Pin: release n=bookworm-backports
Pin-Priority: 100

Package: mesa-vulkan-drivers libdrm*
Pin: release n=bookworm-backports
Pin-Priority: 600
PINS
  if ! cmp -s "$sources" /etc/apt/sources.list.d/gnomon.sources || ! cmp -s "$pins" /etc/apt/preferences.d/gnomon; then
    echo "setup: adding bookworm-backports (Mesa 25) and trixie (Vulkan Memory Allocator) of $archive, pinned to these two" >&2
    "${as_root[@]}" install -m 644 "$sources" /etc/apt/sources.list.d/gnomon.sources
    "${as_root[@]}" install -m 644 "$pins" /etc/apt/preferences.d/gnomon
  fi
  rm -f "$sources" "$pins"
fi

echo "setup: installing" >&2
names=()
for entry in "${missing[@]}"; do printf '  %-32s %s\n' "${entry%%|*}" "${entry##*|}" >&2; names+=("${entry%%|*}"); done
if ((newer_mesa)); then names+=(mesa-vulkan-drivers); echo "  mesa-vulkan-drivers              newer, with ray tracing" >&2; fi
apt update
available=$(apt-cache policy "${names[@]}" | awk '/^[^ ]/ {name = $1; sub(":$", "", name)} /Candidate: [^(]/ {print name}')
unavailable=()
for name in "${names[@]}"; do
  grep -qxF -- "$name" <<<"$available" || unavailable+=("$name")
done
if ((${#unavailable[@]})); then
  echo "setup.sh: not in this system's package sources: ${unavailable[*]} (on Ubuntu enable 'universe')" >&2
  exit 1
fi
apt install -y --no-install-recommends "${names[@]}"
echo "setup: done" >&2
