"""What the whole state goes through: undo, presets, lights, saved cameras, paths."""
import json
import math
import subprocess
import unittest

from case import OK, WIDE, WindowCase, camera, png
from viewer import PROGRAM, difference

# A scene of few triangles: its frames are short.
SPHERE = [*WIDE, "--technique", "single/pcf", "--set", "single.size=256"]


def distance(a, b):
    return math.dist(a, b)


class State(WindowCase):
    def undo(self, viewer):
        viewer.press("Control_L", "z")

    def redo(self, viewer):
        viewer.press("Control_L", "y")

    def test_undo(self):
        viewer = self.open("chart/sphere", *SPHERE)
        begin = viewer.status()["command"]
        viewer.search("pcf.taps")
        place = viewer.middle("pcf.taps")
        viewer.desktop.key("Control_L", True)
        viewer.click_at(*place)
        viewer.desktop.key("Control_L", False)
        viewer.frames()
        for digit in "40":  # each in a frame of its own, and yet one step
            viewer.type(digit)
        viewer.press("Return")
        viewer.until_command("--set pcf.taps=40")
        viewer.choose("technique", "single/vsm")
        viewer.until_command("--technique single/vsm", seconds=120)
        viewer.search("")
        viewer.click_at(480, 600)  # the field lets the keys go
        before = viewer.status()["command"]
        viewer.hold("w", frames=8)
        walked = viewer.status()["command"]
        self.assertNotEqual(walked, before)
        self.undo(viewer)
        viewer.until(lambda status: status["command"] == before, "the place before the walk")
        self.undo(viewer)
        viewer.until_command("--technique single/pcf", "--set pcf.taps=40", seconds=120)
        self.undo(viewer)
        viewer.until(lambda status: status["command"] == begin, "the beginning")
        self.undo(viewer)  # there is nothing more
        self.assertEqual(viewer.status()["command"], begin)
        self.redo(viewer)
        viewer.until_command("--set pcf.taps=40")
        self.redo(viewer)
        viewer.until_command("--technique single/vsm", seconds=120)
        viewer.press("Control_L", "Shift_L", "z")
        viewer.until(lambda status: status["command"] == walked, "the walk again")
        # What is done after an undo takes the place of what was undone.
        self.undo(viewer)
        viewer.section("Presets, undo")
        viewer.click("undo")
        viewer.until_command("--technique single/pcf", seconds=120)
        viewer.search("pcf.taps")
        viewer.enter("pcf.taps", "9")
        viewer.until_command("--set pcf.taps=9")
        self.redo(viewer)
        self.assertIn("--set pcf.taps=9", viewer.status()["command"])
        self.close(viewer)

    def test_preset(self):
        viewer = self.open("chart/sphere", *SPHERE)
        viewer.hold("d")
        viewer.search("pcf.taps")
        viewer.enter("pcf.taps", "9")
        viewer.search("light.elevation")
        viewer.enter("light.elevation", "35")
        viewer.until_command("--set light.elevation=35")
        viewer.section("Presets, undo")
        viewer.fill("preset_file", "own.json")
        viewer.click("save_preset")
        viewer.until_text("preset", lambda text: text == "wrote own.json")
        viewer.click("save_preset")
        viewer.until_text("preset", lambda text: "click again" in text)
        viewer.press("F12")
        viewer.wait(lambda: viewer.stdout().endswith("\n"), "the picture")
        taken = png.read(self.folder / "gnomon_0000.png")
        viewer.click("copy_command")
        command = self.desktop.clipboard()
        by_command = self.render(command, self.folder / "command.png")
        by_preset = self.render("gnomon render chart/sphere --preset own.json", self.folder / "preset.png", "--size", "275x160")
        self.assertLess(difference(taken, by_command), 0.5)
        self.assertLess(difference(taken, by_preset), 0.5)
        preset = json.loads((self.folder / "own.json").read_text(encoding="utf-8"))
        self.assertEqual(preset["scene"], "chart/sphere")
        # Back from something else.
        viewer.choose("technique", "cascaded/hard")
        viewer.until_command("--technique cascaded/hard", seconds=120)
        viewer.hold("s", frames=8)
        viewer.click("load_preset")
        viewer.until_command("--technique single/pcf", seconds=120)
        viewer.frames(3)
        viewer.press("F12")
        viewer.wait(lambda: viewer.stdout().count("\n") == 2, "the second picture")
        self.assertLess(difference(png.read(self.folder / "gnomon_0001.png"), taken), 0.5)
        viewer.fill("preset_file", "gone.json")
        viewer.click("load_preset")
        viewer.until(lambda status: "gone.json" in status["message"], "a message")
        self.close(viewer)

    def test_lights(self):
        small = ["--set", "single.size=256", "--set", "cube.size=128"]
        viewer = self.open("chart/sphere", *WIDE, "--technique", "single/pcf,cube/pcf", *small)
        viewer.section("Lights")
        # The sun, by its compass.
        viewer.drag(viewer.middle("sun_handle"), tuple(at + 25 for at in viewer.middle("sun_handle")))
        viewer.until(lambda status: "--light sun:" in status["command"], "a sun that was moved")
        viewer.click("add_light:point")
        text = self.light(viewer, "point")
        x, y = viewer.middle("arrow_y")
        before = viewer.status()["camera"]
        viewer.drag((x, y), (x, y - 60))
        moved = self.light(viewer, "point")
        self.assertNotEqual(moved, text)
        was, now = (place(one) for one in (text, moved))
        self.assertGreater(now[1], was[1] + 0.05)
        self.assertAlmostEqual(now[0], was[0], places=3)
        self.assertAlmostEqual(now[2], was[2], places=3)
        self.assertEqual(viewer.status()["camera"], before)
        # One drag is one step back.
        self.undo(viewer)
        viewer.until(lambda _: self.light(viewer, "point") == text, "the light where it was")
        self.redo(viewer)
        viewer.until(lambda _: self.light(viewer, "point") == moved, "the light where it went")
        # A technique of its own.
        viewer.choose("light", "point")
        viewer.choose("technique", "cube/hard")
        viewer.until_command("--technique cube/hard,single/pcf", seconds=120)
        viewer.frames()
        drawn = self.render(viewer.status()["command"], self.folder / "drawn.png")
        viewer.press("F12")
        viewer.wait(lambda: viewer.stdout().endswith("\n"), "the picture")
        self.assertLess(difference(png.read(self.folder / "gnomon_0000.png"), drawn), 0.5)
        viewer.click("lights:point")
        viewer.click("remove_light")
        viewer.until(lambda status: "--light point" not in status["command"], "no point light")
        self.assertEqual(viewer.status()["message"], "")
        self.close(viewer)

    def test_lights_that_aim(self):
        """A spot and a projector: their place and what they aim at are dragged apart from each other."""
        viewer = self.open("chart/sphere", *WIDE, "--technique", "single/pcf", "--set", "single.size=256")
        viewer.section("Lights")
        for kind in ("spot", "projector"):
            viewer.click(f"add_light:{kind}")
            before = self.light(viewer, kind)
            self.drag_by(viewer, "aim_handle", 40, -20)
            aimed = viewer.wait(lambda: self.light(viewer, kind) != before and self.light(viewer, kind), "another aim")
            self.assertEqual(place(aimed), place(before), "it stands where it stood")
            self.assertNotEqual(aim(aimed), aim(before))
            self.drag_by(viewer, "lamp_handle", -30, 10)
            placed = viewer.wait(lambda: self.light(viewer, kind) != aimed and self.light(viewer, kind), "another place")
            self.assertNotEqual(place(placed), place(aimed))
            drawn = self.render(viewer.status()["command"], self.folder / f"{kind}.png")
            self.assertGreater(len(set(drawn[2])), 16, "it lights something")
            viewer.click("remove_light")
            viewer.until(lambda status: f"--light {kind}:" not in status["command"], f"no {kind}")
        self.assertEqual(viewer.status()["message"], "")
        self.close(viewer)

    def drag_by(self, viewer, handle, x, y):
        start = viewer.middle(handle)
        viewer.drag(start, (start[0] + x, start[1] + y))

    def light(self, viewer, kind):
        """The text of the first light of a kind."""
        status = viewer.until(lambda status: f"--light {kind}:" in status["command"], f"a {kind} light")
        return status["command"].split(f"--light {kind}:", 1)[1].split(" ")[0]

    def test_cameras_and_orbit(self):
        viewer = self.open("courtyard", *WIDE, "--technique", "single/hard", "--set", "single.size=256")
        start = viewer.status()["camera"]
        viewer.press("Control_L", "1")
        viewer.hold("w", frames=6)
        self.assertNotEqual(viewer.status()["camera"], start)
        viewer.press("1")
        viewer.until(lambda status: status["camera"] == start, "the saved camera")
        # Looking at a point turns the view, and does not change its lens.
        before = viewer.picture()
        viewer.double_click(480, 330, lambda status: status["camera"] != start)
        status = viewer.status()
        (eye, _), (eye_before, _) = camera(status), (self.numbers(start))
        self.assertLess(distance(eye, eye_before), 1e-3)
        self.assertIn("--set camera.vertical_fov=", status["command"])
        self.assertGreater(difference(viewer.picture(), before), 1.0)
        viewer.press("o")
        viewer.until_text("orbit", lambda text: text == "on")
        viewer.hold("d", frames=6)
        eye_after, target_after = camera(viewer.status())
        self.assertGreater(distance(eye_after, eye), 0.1)
        # Both rays go through one point, as far from either eye.
        forward, forward_after = unit(eye, camera(status)[1]), unit(eye_after, target_after)
        centre, miss = nearest(eye, forward, eye_after, forward_after)
        self.assertLess(miss, 0.1)  # orbiting begins at the middle of a pixel
        self.assertAlmostEqual(distance(eye, centre), distance(eye_after, centre), delta=0.02 * distance(eye, centre))
        viewer.press("o")
        viewer.until_text("orbit", lambda text: text == "off")
        self.close(viewer)

    def numbers(self, text):
        return camera({"camera": text})

    def test_paths(self):
        viewer = self.open("chart/sphere", *SPHERE)
        viewer.section("Paths")
        begin, _ = camera(viewer.status())
        viewer.click("record")
        viewer.hold("w", frames=8)
        viewer.hold("d", frames=8)
        viewer.click("stop_recording")
        viewer.until_text("camera_path", lambda text: not text.startswith("0.000 of 0.000"))
        end, _ = camera(viewer.status())
        self.assertGreater(distance(begin, end), 0.05)
        viewer.click("loop:camera")
        viewer.click("play:camera")
        back, _ = camera(viewer.until(lambda status: distance(camera(status)[0], end) > 0.02, "the begin of the path"))
        self.assertLess(distance(back, begin), distance(end, begin))
        viewer.until_text("camera_path", lambda text: "plays" not in text)
        self.assertLess(distance(camera(viewer.status())[0], end), 0.02)
        viewer.fill("path_file", "walk.json")
        viewer.click("save_path")
        viewer.wait(lambda: (self.folder / "walk.json").is_file(), "the file")
        words = [PROGRAM, "render", "chart/sphere", "--size", "64x40", "--technique", "single/hard", "--frames", "2"]
        words += ["--path", "walk.json", "-o", "walk.png"]
        done = subprocess.run(words, cwd=self.folder, capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, OK, done.stderr)
        self.assertNotEqual(*(png.read(self.folder / f"walk_000{number}.png")[2] for number in range(2)))
        self.close(viewer)

    def test_sun_paths(self):
        viewer = self.open("chart/sphere", *SPHERE)
        viewer.section("Lights")
        begin = self.light(viewer, "sun") if "--light sun:" in viewer.status()["command"] else None
        viewer.section("Paths")
        viewer.click("record")
        viewer.slide("azimuth", 0.35)
        viewer.slide("azimuth", 0.2)
        moved = self.light(viewer, "sun")
        self.assertNotEqual(moved, begin)
        viewer.click("stop_recording")
        viewer.until_text("paths_done", lambda text: text == "recorded the sun")
        viewer.click("loop:sun")
        viewer.click("play:sun")
        viewer.until(lambda _: self.light(viewer, "sun") != moved, "the begin of the sun's path")
        viewer.until_text("sun_path", lambda text: not text.startswith("0.000") and "plays" not in text)
        viewer.until(lambda _: self.light(viewer, "sun") == moved, "its end")
        viewer.fill("path_file", "sun.json")
        viewer.click("save_path")
        viewer.wait(lambda: (self.folder / "sun.json").is_file(), "the file")
        azimuths = [key["azimuth"] for key in json.loads((self.folder / "sun.json").read_text(encoding="utf-8"))["sun"]]
        self.assertGreater(max(azimuths) - min(azimuths), 10)
        viewer.click("load_path")
        viewer.until_text("paths_done", lambda text: text == "read sun.json: the sun")
        words = [PROGRAM, "render", "chart/sphere", "--size", "64x40", "--technique", "single/hard", "--frames", "2"]
        words += ["--sun-path", "sun.json", "-o", "sun.png"]
        done = subprocess.run(words, cwd=self.folder, capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, OK, done.stderr)
        self.assertNotEqual(*(png.read(self.folder / f"sun_000{number}.png")[2] for number in range(2)))
        viewer.fill("path_file", "none.json")
        viewer.click("load_path")
        viewer.until(lambda status: "none.json" in status["message"], "a message")
        self.close(viewer)


def place(light_text):
    """The first three numbers of a light."""
    return [float(number) for number in light_text.split(":")[0].split(",")[:3]]


def aim(light_text):
    """The second three numbers of a light: what it shines at."""
    return [float(number) for number in light_text.split(":")[1].split(",")[:3]]


def unit(a, b):
    length = math.dist(a, b)
    return [(y - x) / length for x, y in zip(a, b)]


def nearest(a, u, b, v):
    """The point in the middle between two lines where they come nearest, and how far apart they are there."""
    w = [x - y for x, y in zip(a, b)]
    dot = lambda p, q: sum(x * y for x, y in zip(p, q))  # noqa: E731
    uv, uw, vw = dot(u, v), dot(u, w), dot(v, w)
    s, t = (uv * vw - uw) / (1 - uv * uv), (vw - uv * uw) / (1 - uv * uv)
    p, q = [x + s * y for x, y in zip(a, u)], [x + t * y for x, y in zip(b, v)]
    return [(x + y) / 2 for x, y in zip(p, q)], math.dist(p, q)


if __name__ == "__main__":
    unittest.main(verbosity=2)
