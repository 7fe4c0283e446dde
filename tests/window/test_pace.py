"""A view whose maps take longer than a frame may: smaller ones while it moves, the whole picture when it rests."""
import unittest

from case import WindowCase, png
from viewer import difference, part

# Nothing is fast enough for this target.
SLOW = ["--frame-ms", "5", "--technique", "cascaded/vsm", "--set", "cascaded.size=512"]


class Pace(WindowCase):
    def test_a_fast_view_is_finer_at_rest(self):
        # Its pixels are dear, its map is not.
        viewer = self.open("chart/slab", "--size", "1280x720", "--frame-ms", "10", "--technique", "single/pcss", "--set", "single.size=64")
        fine = viewer.until(self.is_fine, "the picture at rest")["picture_size"]
        viewer.desktop.key("w", True)
        viewer.until(lambda status: status["picture_size"][0] < fine[0], "a picture that is drawn in time")
        viewer.desktop.key("w", False)
        viewer.until(self.is_fine, "the picture at rest")
        # What comes over it is drawn on a picture of that size, and stays, too.
        viewer.press("v")
        viewer.until_text("overlay", lambda text: text.startswith("layers"))
        viewer.frames(4)
        size = viewer.status()["picture_size"]
        self.assertTrue(self.is_fine(viewer.status()))
        before = self.beside_panels(viewer.picture())
        viewer.frames(4)
        self.assertEqual(difference(self.beside_panels(viewer.picture()), before), 0.0)
        viewer.press("v")
        viewer.until_text("overlay", lambda text: text == "texel grid")
        viewer.wait(lambda: difference(self.beside_panels(viewer.picture()), before) > 1.0, "the other overlay")
        viewer.click("adapt_size")
        viewer.frames(4)
        self.assertEqual(viewer.status()["picture_size"], size, "a fixed size begins with that on screen")
        self.close(viewer)

    def test_a_reference_is_of_the_picture_at_rest(self):
        viewer = self.open("chart/slab", "--size", "1280x720", "--frame-ms", "20", "--technique", "single/hard", "--set", "single.size=64",
                           "--split", "reference")
        viewer.section("Compare") if "second_side" not in viewer.widgets() else None
        viewer.click("scores")
        viewer.until_text("reference", lambda text: "ray" in text and " of " not in text, 120)
        self.assertTrue(self.is_fine(viewer.status()))
        first = viewer.until_text("mae.first", lambda _: True)
        viewer.hold("w", frames=4)
        viewer.until_text("reference", lambda text: " of " in text or text.startswith("waits"))
        viewer.until_text("reference", lambda text: "ray" in text and " of " not in text, 120)
        viewer.until_text("mae.first", lambda text: text != first)
        self.assertTrue(self.is_fine(viewer.status()))
        self.close(viewer)

    def test_scores_follow_the_technique_while_the_reference_stays(self):
        viewer = self.open("chart/slab", "--size", "1280x720", "--frame-ms", "20", "--technique", "single/hard", "--set", "single.size=64",
                           "--split", "cascaded/hard")
        viewer.click("scores")
        first = viewer.until_text("mae.first", lambda _: True)
        second = viewer.until_text("mae.second", lambda text: text != first)
        viewer.choose("technique", "single/pcf")
        viewer.until_text("mae.first", lambda text: text != first)
        viewer.choose("technique", "single/hard")
        viewer.until_text("mae.first", lambda text: text == first)
        viewer.click("exchange")
        viewer.until_text("mae.first", lambda text: text == second)
        viewer.until_text("mae.second", lambda text: text == first)
        self.close(viewer)

    def slow_view(self, size="900x500"):
        viewer = self.open("courtyard", "--size", size, *SLOW)
        # Some frames are measured first.
        viewer.until_text("small_maps", lambda text: text == "1/4" or text == "1/8")
        return viewer

    def resting(self, viewer):
        return viewer.until(lambda status: status["full_maps"], "the whole picture", 120)

    def test_smaller_while_it_moves_and_whole_at_rest(self):
        viewer = self.slow_view()
        resting_size = self.resting(viewer)["picture_size"]
        viewer.desktop.key("w", True)
        moving = viewer.until(lambda status: not status["full_maps"], "smaller maps")
        self.assertIn("--set cascaded.size=512", moving["command"], "what is said is what is in force")
        smaller = viewer.until(lambda status: status["picture_size"][0] < resting_size[0], "a smaller picture")
        self.assertFalse(smaller["full_maps"])
        viewer.desktop.key("w", False)
        status = self.resting(viewer)
        self.assertEqual(status["picture_size"], resting_size)
        # At rest the window goes on: panels answer, the picture stays.
        viewer.frames()
        before = self.beside_panels(viewer.picture())
        viewer.frames(5)
        self.assertEqual(difference(self.beside_panels(viewer.picture()), before), 0.0)
        self.close(viewer)

    def test_what_is_taken_is_the_picture_in_force(self):
        viewer = self.slow_view()
        viewer.hold("s", frames=3)
        viewer.press("F12")
        viewer.wait(lambda: (self.folder / "gnomon_0000.png").is_file(), "the picture")
        self.resting(viewer)
        taken = png.read(self.folder / "gnomon_0000.png")
        drawn = self.render(viewer.status()["command"], self.folder / "drawn.png")
        self.assertLess(difference(taken, drawn), 0.5)
        self.close(viewer)

    def test_a_clip_begun_while_it_moves_has_the_size_at_rest(self):
        viewer = self.slow_view("1100x500")  # the tools are open
        width = self.resting(viewer)["picture_size"][0]
        viewer.section("Pictures, clips, reports")
        viewer.desktop.key("w", True)
        viewer.until(lambda status: status["picture_size"][0] < width, "a smaller picture")
        viewer.click("clip")
        viewer.frames(3)
        viewer.click("clip")
        viewer.desktop.key("w", False)
        viewer.until_text("clip", lambda text: text == "stopped, 0 waiting", 60)
        pictures = [png.read(path) for path in sorted(self.folder.glob("*/0*.png"))]
        self.assertGreater(len(pictures), 2)
        self.assertEqual({picture[0] for picture in pictures}, {width})
        self.close(viewer)

    def test_a_parameter_counts_in_the_picture_at_rest(self):
        viewer = self.slow_view()
        self.resting(viewer)
        before = viewer.picture()
        viewer.search("bleeding")
        viewer.slide("vsm.bleeding", 0.95)
        viewer.until(lambda status: "vsm.bleeding" in status["command"], "the parameter")
        self.resting(viewer)
        viewer.search("no parameter")
        self.assertGreater(difference(self.beside_panels(viewer.picture()), self.beside_panels(before)), 0.5)
        # Another technique begins anew.
        viewer.choose("technique", "single/hard")
        viewer.until_command("--technique single/hard", seconds=120)
        viewer.until_text("small_maps", lambda text: text in ("1/4", "1/8"))
        self.close(viewer)

    def test_maps_that_are_looked_at_are_those_in_force(self):
        viewer = self.slow_view()
        viewer.press("m")
        viewer.desktop.key("w", True)
        for _ in range(5):
            viewer.frames(1)
            self.assertTrue(viewer.status()["full_maps"])
        viewer.desktop.key("w", False)
        self.close(viewer)

    def is_fine(self, status):
        return status["picture_size"][0] >= status["window_size"][0] // 2

    def beside_panels(self, picture):
        width, height, _ = picture
        return part(picture, 400, 60, width - 20, height - 10)


if __name__ == "__main__":
    unittest.main()
