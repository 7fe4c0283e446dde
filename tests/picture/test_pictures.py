"""Pictures of built-in scenes against stored ones. usage: test_pictures.py [--update] PROGRAM OUTPUT [SCENE]

What may differ, and why. A pixel counts as different when a channel is off by more than 8 of 255: filtering of textures and
rounding of colours differ by less between devices. On the device and driver that made the stored pictures (expected/made_by.txt)
at most 0.1 % of the pixels may differ: a compiler may contract a product, and a single sample on an edge then falls on the other side.
Elsewhere at most 3 %: edges of triangles, of leaves and of shadows are sampled once per pixel, each device has its own rule for
positions between grid points, and a pixel on such an edge flips altogether. A wrong bias, a lost caster or a shifted map changes
far more. A failing test leaves NAME.actual.png, NAME.expected.png and NAME.difference.png in OUTPUT."""
import pathlib
import subprocess
import sys

import png

EXPECTED = pathlib.Path(__file__).resolve().parent / "expected"
TOLERANCE = 8
SHARE_SAME_DEVICE, SHARE = 0.001, 0.03

SCENES = {
    "courtyard": ["courtyard"],
    "courtyard_detail": ["courtyard", "--camera", "detail"],
    "terrain": ["terrain", "--set", "scene.detail=0.02"],
    "chart_fence": ["chart/fence"],
    "chart_slab": ["chart/slab"],
    "chart_sphere": ["chart/sphere"],
}
TECHNIQUES = ["single/hard", "single/pcf"]
SHOWN = ["shaded", "mask"]


def device(program):
    """Name and driver of the device in use."""
    text = subprocess.run([program, "doctor"], capture_output=True, text=True, check=True).stdout
    return "".join(line + "\n" for line in text.splitlines() if line.startswith(("device ", "driver ")))


def render(program, path, view, technique, show):
    command = [program, "render", *view, "--technique", technique, "--show", show, "--size", "160x120", "-o", str(path),
               "--set", "reference.area=off"]
    print(" ".join(command), flush=True)
    subprocess.run(command, check=True)


def difference(actual, expected):
    """(share of pixels beyond the tolerance, largest difference of a channel, picture of the differences)."""
    channels = bytes(abs(a - b) for a, b in zip(actual, expected))
    pixels = [max(channels[i:i + 3]) for i in range(0, len(channels), 3)]
    count = sum(value > TOLERANCE for value in pixels)
    return count / len(pixels), max(pixels), bytes(min(255, 4 * value) for value in channels)


def check(name, actual_path, share_allowed):
    """Empty, or what is wrong."""
    expected_path = EXPECTED / actual_path.name
    if not expected_path.is_file():
        return f"{name}: nothing stored; scripts/update_pictures.sh makes it"
    width, height, actual = png.read(actual_path)
    expected_width, expected_height, expected = png.read(expected_path)
    if (width, height) != (expected_width, expected_height):
        return f"{name}: {width}x{height}, stored {expected_width}x{expected_height}"
    share, largest, picture = difference(actual, expected)
    verdict = f"{name}: {100 * share:.2f} % of the pixels differ by more than {TOLERANCE} (allowed {100 * share_allowed:.2f} %), at most {largest}"
    print(verdict, flush=True)
    if share <= share_allowed:
        return ""
    folder = actual_path.parent
    actual_path.replace(folder / f"{name}.actual.png")
    png.write(folder / f"{name}.expected.png", width, height, expected)
    png.write(folder / f"{name}.difference.png", width, height, picture)
    return verdict + f"; see {folder}/{name}.*.png"


def main():
    arguments = sys.argv[1:]
    update = arguments[:1] == ["--update"]
    program, output, *names = arguments[update:]
    output = EXPECTED if update else pathlib.Path(output)
    output.mkdir(parents=True, exist_ok=True)
    made_by = EXPECTED / "made_by.txt"
    here = device(program)
    if update:
        made_by.write_text(here, encoding="utf-8")
    share_allowed = SHARE_SAME_DEVICE if made_by.is_file() and made_by.read_text(encoding="utf-8") == here else SHARE
    wrong = []
    for scene in names or SCENES:
        for technique in TECHNIQUES:
            for show in SHOWN:
                name = f"{scene}.{technique.replace('/', '-')}.{show}"
                path = output / f"{name}.png"
                render(program, path, SCENES[scene], technique, show)
                if update:
                    continue
                wrong.append(check(name, path, share_allowed))
    wrong = [text for text in wrong if text]
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
