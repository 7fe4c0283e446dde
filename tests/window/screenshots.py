"""The pictures of docs/viewer.md, from the real program. usage: screenshots.py FOLDER [NAME...] (scripts/viewer_screenshots.sh calls it)"""
import os
import pathlib
import subprocess
import sys
import tempfile

from desktop import Desktop
from display import Display
from viewer import MIDDLE, Viewer

WINDOW = ["--size", "800x500"]
# With room for the tools at the right.
WIDE = ["--size", "1060x600"]


def window(viewer):
    """The whole: a scene, the panel and the tools on it."""
    viewer.point(480, 560)


def techniques(viewer):
    viewer.click("technique")
    viewer.entries("technique")
    viewer.point(*viewer.middle("technique:single/msm"))


def parameters(viewer):
    viewer.search("pcf")
    viewer.choose("pcf.kernel", "vogel")
    viewer.slide("pcf.radius", 0.95)
    viewer.point(*viewer.middle("pcf.taps"))


def compare(viewer):
    """Two techniques, the error of both, and their scores."""
    viewer.search("size")
    viewer.click("scores")
    viewer.until_text("reference", lambda text: text.endswith("rays") and " of " not in text, 300)
    viewer.until_text("mae.second", lambda _: True)
    viewer.drag(viewer.middle("divider"), (500, 400))
    viewer.point(480, 560)


def explain(viewer):
    """A tint for each cascade, and why a pixel is dark."""
    viewer.search("size")
    viewer.click_at(477, 420, MIDDLE)
    viewer.until_text("reason", lambda text: "not yet" not in text, 120)
    viewer.point(480, 60)


def lights(viewer):
    """A lamp that was added, with its handles."""
    viewer.search("size")
    viewer.section("Lights")
    viewer.click("add_light:point")
    x, y = viewer.middle("arrow_y")
    viewer.drag((x, y), (x, y + 40))
    viewer.point(420, 560)


def measure(viewer):
    viewer.search("size")
    viewer.section("Measure")
    viewer.click("separate_passes")
    viewer.point(480, 560)
    viewer.frames(40)


# Name of the picture -> what is done before it is taken, and how the viewer is started.
PICTURES = {
    "window": (window, ["courtyard", "--technique", "cascaded/pcf", "--scale", "1", *WIDE]),
    "techniques": (techniques, ["courtyard", "--technique", "single/pcf", *WINDOW]),
    "parameters": (parameters, ["courtyard", "--camera", "detail", "--technique", "single/pcf", *WINDOW]),
    "compare": (compare, ["courtyard", "--technique", "single/hard", "--split", "cascaded/pcss", "--error", "--scale", "0.5", *WIDE]),
    "explain": (explain, ["courtyard", "--technique", "cascaded/hard", "--overlay", "layers", "--scale", "0.5", *WIDE]),
    "lights": (lights, ["courtyard", "--technique", "single/pcf,cube/pcf", "--scale", "0.75", *WIDE]),
    "measure": (measure, ["courtyard", "--technique", "single/vsm", "--scale", "0.35", *WIDE]),
}


def take(display, desktop, name, output):
    prepare, arguments = PICTURES[name]
    with tempfile.TemporaryDirectory() as folder:
        viewer = Viewer(display, desktop, folder, *arguments)
        try:
            viewer.open()
            prepare(viewer)
            viewer.frames(3)
            path = pathlib.Path(folder) / f"{name}.png"
            desktop.save_picture(path, viewer.window)
            # So many colours are enough for a document, and a quarter of the size.
            subprocess.run(["pngquant", "--force", "--speed", "1", "--output", str(output / f"{name}.png"), "96", str(path)], check=True)
            if viewer.close():
                raise AssertionError(viewer.stderr())
        finally:
            viewer.kill()
    print(f"{output / name}.png {os.path.getsize(output / f'{name}.png') // 1024} KiB", flush=True)


def main():
    output, names = pathlib.Path(sys.argv[1]), sys.argv[2:] or list(PICTURES)
    unknown = sorted(set(names) - set(PICTURES))
    if unknown:
        sys.exit(f"no picture '{unknown[0]}'; valid: {', '.join(PICTURES)}")
    output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        display = Display(folder)
        try:
            desktop = Desktop(display.name)
            for name in names:
                take(display, desktop, name, output)
            desktop.disconnect()
        finally:
            display.close()


if __name__ == "__main__":
    main()
