"""The pictures of docs/viewer.md, from the real program. usage: screenshots.py FOLDER [NAME...] (scripts/viewer_screenshots.sh calls it)"""
import os
import pathlib
import subprocess
import sys
import tempfile

from desktop import Desktop
from display import Display
from viewer import Viewer

WINDOW = ["--size", "800x500"]


def window(viewer):
    """The whole: a scene, and the panel on it."""
    viewer.point(600, 300)


def techniques(viewer):
    viewer.click("technique")
    viewer.entries("technique")
    viewer.point(*viewer.middle("technique:single/msm"))


def parameters(viewer):
    viewer.search("pcf")
    viewer.choose("pcf.kernel", "vogel")
    viewer.slide("pcf.radius", 0.95)
    viewer.point(*viewer.middle("pcf.taps"))


def cost(viewer):
    viewer.search("exposure")  # all parameters would take the room
    viewer.click("separate_passes")
    viewer.point(600, 300)
    viewer.frames(12)


# Name of the picture -> what is done before it is taken, and how the viewer is started.
PICTURES = {
    "window": (window, ["courtyard", "--technique", "cascaded/pcf"]),
    "techniques": (techniques, ["courtyard", "--technique", "single/pcf"]),
    "parameters": (parameters, ["courtyard", "--camera", "detail", "--technique", "single/pcf"]),
    "cost": (cost, ["courtyard", "--technique", "single/vsm"]),
}


def take(display, desktop, name, output):
    prepare, arguments = PICTURES[name]
    with tempfile.TemporaryDirectory() as folder:
        viewer = Viewer(display, desktop, folder, *arguments, *WINDOW)
        try:
            viewer.open()
            prepare(viewer)
            viewer.frames(3)
            path = pathlib.Path(folder) / f"{name}.png"
            desktop.save_picture(path, viewer.window)
            # 256 colours are enough for a document, and a third of the size.
            subprocess.run(["pngquant", "--force", "--speed", "1", "--output", str(output / f"{name}.png"), str(path)], check=True)
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
