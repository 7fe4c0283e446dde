"""Overlays, picked pixels, the map and the light's views; and keys that type while a field has them."""
import unittest

from case import WIDE, WindowCase
from viewer import MIDDLE, difference, part

BETWEEN = (380, 10, 570, 400)  # of the window: no panel is there


class Explain(WindowCase):
    def setUp(self):
        super().setUp()
        self.viewer = self.open("courtyard", *WIDE, "--technique", "cascaded/pcf", "--set", "cascaded.size=256")
        # The first frames have the window's size.
        self.viewer.until(lambda status: status["picture_size"] == [275, 160], "the picture's size")
        self.viewer.point(480, 600)  # no tooltip of where the pointer was left

    def seen(self):
        self.viewer.frames(3)
        return part(self.viewer.picture(), *BETWEEN)

    def test_overlays(self):
        viewer, plain = self.viewer, self.seen()
        viewer.press("v")
        viewer.until_text("overlay", lambda text: text.startswith("layers"))
        layers = self.seen()
        self.assertGreater(difference(layers, plain), 5.0)
        viewer.press("v")
        viewer.until_text("overlay", lambda text: text == "texel grid")
        self.assertGreater(difference(self.seen(), layers), 5.0)
        viewer.section("Explain") if "overlay" not in viewer.widgets() else None
        for title in ("pixels per texel", "casters and receivers", "overdraw", "no overlay"):
            viewer.choose("overlay", title)
            viewer.until_text("overlay", lambda text, title=title: text == title)
            covered = title != "no overlay"
            viewer.wait(lambda covered=covered: (difference(self.seen(), plain) > 2.0) == covered, f"the picture with {title}")
        viewer.press("l")
        viewer.until_text("lines", lambda text: text == "on")
        self.assertGreater(difference(self.seen(), plain), 1.0)
        viewer.click("lines")
        viewer.until_text("lines", lambda text: text == "off")
        viewer.press("F1")  # keys work without the panels, too
        viewer.press("v")
        viewer.until_text("overlay", lambda text: text.startswith("layers"))
        # The picture that is told is without any of this.
        self.assertNotIn("overlay", viewer.status()["command"])
        self.close(viewer)

    def test_pick(self):
        viewer = self.viewer
        viewer.click_at(480, 420, MIDDLE)
        picked = viewer.until_text("picked", lambda _: True)
        x, y = (int(number) for number in picked.split(", "))
        self.assertEqual((x, y), (480 // 4, 420 // 4))
        self.assertGreater(len(viewer.until_text("reason", lambda text: "not yet" not in text)), 10)
        self.assertIn("pick_window", viewer.widgets())
        before = viewer.status()["camera"]
        viewer.press("p")
        viewer.until_text("pick_mode", lambda text: text == "on")
        viewer.click_at(420, 300)
        viewer.until_text("picked", lambda text: text == f"{420 // 4}, {300 // 4}")
        viewer.until_text("pick_mode", lambda text: text == "off")
        viewer.click_at(480, 420)
        self.assertEqual(viewer.text("picked"), f"{420 // 4}, {300 // 4}", "a click alone picks nothing")
        self.assertEqual(viewer.status()["camera"], before)
        # The sky has a reason, too; and another technique another title, not an end.
        viewer.click_at(480, 12, MIDDLE)
        viewer.until_text("reason", lambda text: len(text) > 3)
        viewer.choose("technique", "ray_traced")
        viewer.until_command("--technique ray_traced")
        viewer.click_at(480, 420, MIDDLE)
        viewer.until_text("reason", lambda text: len(text) > 3)
        self.close(viewer)

    def test_both_sides_are_explained(self):
        viewer = self.viewer
        viewer.section("Compare")
        viewer.choose("second_side", "other settings")
        viewer.click("second_as_first")
        viewer.choose("technique", "cascaded/vsm")
        viewer.until_command("--technique cascaded/vsm", seconds=120)

        def picked(side, technique):
            viewer.until_text("picked_side", lambda text: text == side)
            viewer.until_text("picked_technique", lambda text: text == technique)
            return viewer.until_text("reason", lambda text: "not yet" not in text)
        viewer.click_at(480, 420, MIDDLE)
        picked("first", "cascaded/vsm")
        viewer.click_at(620, 420, MIDDLE)
        reason = picked("second", "cascaded/pcf")
        viewer.press("b")
        self.assertEqual(picked("second", "cascaded/pcf"), reason, "the second side alone")
        viewer.press("b")
        picked("only", "cascaded/vsm")
        viewer.click("exchange")
        self.assertEqual(picked("only", "cascaded/pcf"), reason, "the same settings as the first side")
        viewer.choose("second_side", "reference")
        viewer.click("split")
        picked("reference", "cascaded/pcf")
        self.close(viewer)

    def taken(self, key="F12"):
        """What is said of a picture that is taken now."""
        before = self.viewer.stdout().count("\n")
        self.viewer.press("F12") if key == "F12" else self.viewer.click(key)
        self.viewer.wait(lambda: self.viewer.stdout().count("\n") == before + 1, "the picture")
        name = self.viewer.stdout().splitlines()[-1]
        said = self.viewer.until_text("notice", lambda text: name in text)
        self.assertEqual(self.viewer.status()["message"], "")
        self.assertIn("notice", self.viewer.widgets())
        self.assertNotIn("message", self.viewer.widgets())
        return said.splitlines()[-1]

    def test_a_picture_says_what_it_holds(self):
        viewer = self.viewer
        self.assertEqual(self.taken(), "gnomon_0000.png is written")
        viewer.until(lambda status: "notice" not in status["texts"], "no notice: it goes by itself", 20)
        viewer.press("v")
        viewer.until_text("overlay", lambda text: text.startswith("layers"))
        self.assertRegex(self.taken(), r"^gnomon_0001.png is written; it also shows the overlay 'layers.*not draw$")
        viewer.section("Compare")
        viewer.click("error")
        viewer.until_text("reference", lambda text: " of " not in text and "ray" in text, 120)
        viewer.frames(3)
        self.assertRegex(self.taken(), r"it also shows the error, and in grey below it the overlay 'layers.*not draw$")
        viewer.choose("second_side", "reference")
        viewer.until_text("sides", lambda text: "waits" not in text)
        self.assertRegex(self.taken(), r"^gnomon_0003.png is written, of the first side alone; it also shows the error")
        viewer.click("error")
        viewer.choose("second_side", "none")
        viewer.section("Compare")
        viewer.section("Pictures, clips, reports")
        self.assertEqual(self.taken("picture_exr"), "gnomon_0000.exr is written", "nothing lies over linear values")
        self.close(viewer)

    def test_map(self):
        viewer = self.viewer
        viewer.press("m")
        viewer.until(lambda status: "map_window" in status["widgets"], "the map")
        viewer.frames(3)
        viewer.point(*viewer.middle("map_picture"))
        self.assertRegex(viewer.until_text("texel", lambda _: True), r"^texel \d+, \d+: (no caster|0\.\d+)")
        viewer.choose("technique", "cascaded/vsm")
        viewer.until_command("--technique cascaded/vsm", seconds=120)
        viewer.frames(3)
        viewer.choose("technique", "ray_traced")  # has none
        viewer.until_command("--technique ray_traced")
        viewer.until(lambda status: "map_window" not in status["widgets"], "no map")
        viewer.press("m")
        viewer.frames(3)
        self.close(viewer)

    def test_keys_type_in_a_field(self):
        viewer = self.viewer
        before = viewer.status()
        viewer.search("vxbolmp123")
        viewer.frames(4)
        status = viewer.status()
        self.assertEqual(status["camera"], before["camera"])
        self.assertEqual(status["command"], before["command"])
        texts = status["texts"]
        self.assertEqual([texts[name] for name in ("overlay", "lines", "pick_mode", "orbit")], ["no overlay", "off", "off", "off"])
        self.assertNotIn("map_window", status["widgets"])
        self.assertNotIn("reference", texts)
        viewer.press("Control_L", "z")  # the field's own
        self.assertEqual(viewer.status()["command"], before["command"])
        viewer.press("Escape")
        viewer.press("o")
        viewer.until_text("orbit", lambda text: text == "on")
        self.close(viewer)


class SeveralLights(WindowCase):
    def test_it_is_said_which_light_is_meant(self):
        small = ["--set", "cube.size=128", "--set", "single.size=128"]
        viewer = self.open("lamps", *WIDE, "--light", "all", "--technique", "single/hard,cube/hard", *small, "--split", "ray_traced", "--error")
        lights = self.names(viewer, "light")
        self.assertGreater(len(lights), 1)
        for name in (lights[1], lights[0]):
            viewer.choose("light", name)
            viewer.until_text("scored_light", lambda text, name=name: text == name)
        viewer.click_at(480, 420, MIDDLE)
        viewer.until_text("picked_light", lambda text: text == lights[0])
        viewer.section("Compare")
        viewer.section("Explain")
        viewer.choose("explained_light", lights[1])
        viewer.until_text("picked_light", lambda text: text == lights[1])
        self.close(viewer)

    def names(self, viewer, widget):
        viewer.click(widget)
        names = viewer.entries(widget)
        viewer.press("Escape")
        return names


if __name__ == "__main__":
    unittest.main(verbosity=2)
