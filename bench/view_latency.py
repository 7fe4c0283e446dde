#!/usr/bin/python3
"""How long the viewer takes from a key to another picture in its window, for each technique, under Xvfb.

usage: GNOMON=build/release/bin/gnomon bench/view_latency.py [-n KEYS] [-s SCENE] [--by camera|PARAMETER=VALUE] [TECHNIQUE...]

A window of 1280 x 720 shows the scene with default settings, and is given time to choose the picture's size. Then the camera's keys are pressed
and held for half a second; or a parameter is changed once (light.elevation=35, frame.exposure=1.5), and Ctrl+Z and Ctrl+Y go there and back.
The clock runs until a strip in the middle of the window differs:
  rest     from a key, pressed at some moment while the picture is complete, to the first other picture
  moving   between two pictures while the key is held; input waits for two of them at most (of a parameter, there are none)
  early    as rest, but pressed soon after the last key, when the viewer may be drawing the complete picture (no goal; where that
           picture comes first, it is taken for the answer)
Milliseconds, median and longest. Not a test: times belong to the machine. Goal: rest below 100 ms, moving below 50 ms (median).
"""
import argparse
import itertools
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "window"))
from desktop import Desktop  # noqa: E402
from display import Display  # noqa: E402
from viewer import PROGRAM, Viewer  # noqa: E402
from Xlib import X  # noqa: E402

SETTLED_S = 4  # without another size of the picture
LONGEST_S = 60
HELD_S = 0.5
POLL_S = 0.004
GOAL_MS = 100
# There and back, so that all frames show about the same. The last one of each is held.
CAMERA_KEYS = [["w"], ["s"]]
UNDO_KEYS = [["Control_L", "z"], ["Control_L", "y"]]


def techniques():
    listed = subprocess.run([PROGRAM, "list", "techniques"], capture_output=True, text=True, check=True).stdout
    return [line.split()[0] for line in listed.splitlines()]


def strip(viewer):
    """Pixels in the middle of the window, beside the panels."""
    return viewer.window.get_image(420, 380, 440, 12, X.ZPixmap, 0xFFFFFFFF).data


def settle(viewer):
    """Waits until the picture keeps its size."""
    end = time.monotonic() + LONGEST_S
    size, since = None, time.monotonic()
    while time.monotonic() < min(end, since + SETTLED_S):
        time.sleep(0.1)
        now = viewer.status()["picture_size"]
        if now != size:
            size, since = now, time.monotonic()


def until_other(viewer, before):
    """Milliseconds until the strip differs, and what it is then."""
    start = time.monotonic()
    while (now := strip(viewer)) == before:
        if time.monotonic() > start + 20:
            raise AssertionError("the key changes nothing")
        time.sleep(POLL_S)
    return 1000 * (time.monotonic() - start), now


def press(viewer, keys, moving):
    """Milliseconds to the first picture; those between the next ones go to `moving`, unless the keys change one thing once."""
    *modifiers, key = keys
    for modifier in modifiers:
        viewer.desktop.key(modifier, True)
    before = strip(viewer)
    viewer.desktop.key(key, True)
    first, picture = until_other(viewer, before)
    end = time.monotonic() + (0 if modifiers else HELD_S)
    while time.monotonic() < end:
        ms, picture = until_other(viewer, picture)
        moving.append(ms)
    if modifiers:
        time.sleep(0.3)  # what was seen may be the complete picture of before: the keys stay until they have been read
    for held in (key, *modifiers):
        viewer.desktop.key(held, False)
    return first


def columns_of(times):
    return f"{statistics.median(times):8.0f}{max(times):6.0f}" if times else f"{'-':>8}{'-':>6}"


def measure(display, folder, scene, technique, count, by):
    viewer = Viewer(display, Desktop(display.name), folder, scene, "--size", "1280x720", "--technique", technique,
                    environment={"GNOMON_VALIDATE": "0"})
    try:
        viewer.open()
        settle(viewer)
        keys = CAMERA_KEYS
        if by != "camera":
            keys = UNDO_KEYS
            name, value = by.split("=")
            viewer.search(name)
            viewer.enter(name, value)
        moving, rest, early = [], [], []
        keys = itertools.cycle(keys)  # there and back
        press(viewer, next(keys), [])  # smaller maps are made
        press(viewer, next(keys), [])
        settle(viewer)
        for _ in range(count):
            time.sleep(0.1)
            viewer.until(lambda status: status["full_maps"], "the complete picture")
            time.sleep(random.uniform(0.1, 0.3))
            rest.append(press(viewer, next(keys), moving))
        for _ in range(count):
            time.sleep(random.uniform(0.15, 0.6))
            early.append(press(viewer, next(keys), []))
        size = viewer.status()["picture_size"]
        columns = "".join(columns_of(times) for times in (rest, moving, early))
        met = max(rest) < GOAL_MS and (not moving or statistics.median(moving) < GOAL_MS / 2)
        print(f"{technique:34} {size[0]:4} x {size[1]:<4}{columns}{'' if met else '  over the goal'}", flush=True)
        return met
    finally:
        viewer.kill()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-n", type=int, default=10, help="keys for each technique")
    parser.add_argument("-s", "--scene", default="courtyard")
    parser.add_argument("--by", default="camera", metavar="camera|PARAMETER=VALUE", help="what changes the picture")
    parser.add_argument("techniques", nargs="*", help="default: all")
    options = parser.parse_args()
    print(f"{'technique':34} {'moving':11}{'rest':>14}{'moving':>14}{'early':>14}")
    with tempfile.TemporaryDirectory() as folder:
        display = Display(folder, "1400x900x24")
        try:
            met = [measure(display, folder, options.scene, name, options.n, options.by) for name in options.techniques or techniques()]
        finally:
            display.close()
    print(f"{sum(met)} of {len(met)} reach the goal")
    return 0 if all(met) else 1


if __name__ == "__main__":
    sys.exit(main())
