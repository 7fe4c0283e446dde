"""Two sides in one window: other settings, the reference, the error over the picture, and the scores."""
import shlex
import unittest

from case import WIDE, WindowCase
from viewer import difference, part

# Whole pixels, so that pictures can be compared; without the panel, which would hide them.
WHOLE = ["--size", "360x240", "--scale", "1"]
GRIP, LABEL = 16, 40  # pixels beside the divider, and above the lower edge, that are not the picture's


def with_technique(command, technique):
    """The same picture by another technique with its default settings."""
    words = shlex.split(command)
    kept = []
    for word in words:
        if kept and kept[-1] == "--set" and word.startswith("single."):
            kept.pop()
        else:
            kept.append(word)
    kept[kept.index("--technique") + 1] = technique
    return shlex.join(kept)


class Compare(WindowCase):
    def assert_sides(self, viewer, first, second):
        """What is left and right of the divider."""
        left, _, right, _ = viewer.widgets()["divider"]
        shown, middle = viewer.picture(), (left + right) // 2
        width, height = shown[:2]
        for name, area, same, other in (("left", (0, 0, middle - GRIP, height - LABEL), first, second),
                                        ("right", (middle + GRIP, 0, width, height - LABEL), second, first)):
            self.assertLess(difference(part(shown, *area), part(same, *area)), 1.0, name)
            self.assertGreater(difference(part(shown, *area), part(other, *area)), 2.0, name)

    def hide_panels(self, viewer):
        """They are folded in a window so small; their titles go, too."""
        viewer.press("F1")

    def test_two_techniques(self):
        viewer = self.open("courtyard", *WHOLE, "--technique", "single/hard", "--set", "single.size=128", "--split", "cascaded/pcf")
        self.hide_panels(viewer)
        viewer.frames(6)
        command = viewer.status()["command"]
        first = self.render(command, self.folder / "first.png")
        second = self.render(with_technique(command, "cascaded/pcf"), self.folder / "second.png")
        self.assert_sides(viewer, first, second)
        viewer.drag(viewer.middle("divider"), (80, 120))
        self.assertLess(viewer.middle("divider")[0], 90)
        self.assert_sides(viewer, first, second)
        self.assertEqual(viewer.status()["command"], command, "dragging the divider turns nothing")
        for side, same in (("second", second), ("first", first), ("second", second)):
            viewer.press("b")
            viewer.until_text("sides", lambda text, side=side: text == f"single/hard | cascaded/pcf, {side}")
            viewer.frames()
            shown = viewer.picture()
            area = (0, 0, shown[0], shown[1] - LABEL)
            self.assertLess(difference(part(shown, *area), part(same, *area)), 1.0, side)
        self.close(viewer)

    def test_reference(self):
        viewer = self.open("chart/slab", *WHOLE, "--technique", "single/hard", "--set", "single.size=32", "--split", "reference")
        self.hide_panels(viewer)
        command = viewer.status()["command"]
        first = self.render(command, self.folder / "first.png")
        second = self.render(with_technique(command, "ray_traced"), self.folder / "second.png")

        def shows_rays():
            shown = viewer.picture()
            area = (180 + GRIP, 0, shown[0], shown[1] - LABEL)
            return difference(part(shown, *area), part(second, *area)) < 1.0
        viewer.wait(shows_rays, "the reference at the right")
        self.assert_sides(viewer, first, second)
        # The error: red where it is too dark, blue where too bright.
        before = viewer.picture()
        viewer.press("x")
        viewer.frames(3)
        self.assertGreater(difference(viewer.picture(), before), 3.0)
        viewer.press("x")
        viewer.frames(3)
        self.assertLess(difference(viewer.picture(), before), 0.5)
        self.close(viewer)

    def test_an_overlay_lies_on_both_sides(self):
        viewer = self.open("courtyard", *WHOLE, "--technique", "single/hard", "--split", "cascaded/hard")
        self.hide_panels(viewer)
        viewer.frames(6)
        plain = viewer.picture()
        viewer.press("v")
        viewer.until_text("overlay", lambda text: text.startswith("layers"))
        viewer.frames(6)
        shown = viewer.picture()
        viewer.press("v")
        viewer.until_text("overlay", lambda text: text == "texel grid")
        viewer.frames(6)
        grid = viewer.picture()
        for area in ((0, 0, 180 - GRIP, 200), (180 + GRIP, 0, 360, 200)):
            self.assertGreater(difference(part(shown, *area), part(plain, *area)), 5.0)
            self.assertGreater(difference(part(grid, *area), part(shown, *area)), 5.0)
        self.close(viewer)

    def test_panel(self):
        """Scores, exchange, and a second side that is chosen there."""
        viewer = self.open("chart/slab", *WIDE, "--technique", "single/hard", "--set", "single.size=32", "--split", "ray_traced")
        viewer.click("scores")
        viewer.until_text("reference", lambda text: text == "1 ray", 120)  # its sun has no size
        viewer.until_text("mae.first", lambda _: True)
        first, second = (float(viewer.until_text(f"mae.{side}", lambda _: True)) for side in ("first", "second"))
        self.assertGreater(first, 0.002)
        self.assertLess(second, 0.5 * first)
        viewer.click("exchange")
        viewer.until_command("--technique ray_traced")
        viewer.until_text("sides", lambda text: text == "ray_traced | single/hard")
        viewer.until_text("mae.first", lambda text: abs(float(text) - second) < 1e-4)
        viewer.until_text("mae.second", lambda text: abs(float(text) - first) < 1e-4)
        viewer.click("exchange")
        viewer.until_command("--technique single/hard", "--set single.size=32")
        viewer.choose("second_side", "none")
        viewer.until(lambda status: "divider" not in status["widgets"], "no divider")
        viewer.choose("second_side", "other settings")
        viewer.click("second_as_first")
        viewer.until_text("sides", lambda text: text == "single/hard | single/hard")
        viewer.choose("second_technique", "single/pcf")
        viewer.until_text("sides", lambda text: text == "single/hard | single/pcf")
        viewer.until_text("mae.second", lambda text: text != viewer.text("mae.first"), 60)
        self.assertIn("--technique single/hard ", viewer.status()["command"])
        viewer.choose("second_technique", "single/hard")
        viewer.until_text("sides", lambda text: text == "single/hard | single/hard")
        # The lights are those of both sides.
        viewer.search("light.elevation")
        viewer.enter("light.elevation", "30")
        viewer.until_command("--set light.elevation=30")
        viewer.until_text("mae.second", lambda text: text == viewer.text("mae.first"), 60)
        self.close(viewer)


if __name__ == "__main__":
    unittest.main(verbosity=2)
