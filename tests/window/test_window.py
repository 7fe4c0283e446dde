"""The window itself: other sizes, minimised, vsync, pictures of it, and the command line that repeats them."""
import time
import unittest

from case import QUICK, WindowCase, png
from viewer import difference

WHOLE = ["--size", "640x400", "--scale", "1", "--technique", "single/hard", "--set", "single.size=512"]


class Window(WindowCase):
    def test_it_shows_what_render_draws(self):
        viewer = self.open("courtyard", *WHOLE)
        viewer.hold("w")
        viewer.press("F1")  # without the panel
        viewer.until(lambda status: not status["widgets"], "no panel")
        viewer.frames()
        shown, drawn = viewer.picture(), self.render(viewer.status()["command"], self.folder / "drawn.png")
        png.write(self.folder / "shown.png", *shown)
        self.assertLess(difference(shown, drawn), 1.0)
        viewer.press("F1")
        viewer.until(lambda status: status["widgets"], "the panel")
        viewer.frames()
        self.assertGreater(difference(viewer.picture(), drawn), 5.0, "the panel")
        self.close(viewer)

    def test_screenshot_and_its_command(self):
        viewer = self.open("courtyard", *QUICK)
        viewer.hold("d")
        viewer.press("F12")
        viewer.wait(lambda: viewer.stdout().endswith("\n"), "the name of the picture")
        self.assertEqual(viewer.stdout(), "gnomon_0000.png\n")
        line = viewer.wait(lambda: next((line for line in viewer.stderr().splitlines() if "gnomon render" in line), None), "the command")
        self.assertTrue(line.endswith("-o gnomon_0000.png"), line)
        taken, drawn = png.read(self.folder / "gnomon_0000.png"), self.render(line[line.index("gnomon render"):], self.folder / "drawn.png")
        self.assertEqual(taken[:2], (256, 160))
        self.assertLess(difference(taken, drawn), 1.0)
        viewer.click("screenshot")  # does not overwrite
        viewer.wait(lambda: viewer.stdout().endswith("gnomon_0001.png\n"), "the second name")
        self.close(viewer)

    def test_more_pixels_to_an_inch(self):
        """Text, widgets and handles grow with the desktop's setting; the picture keeps the window's pixels."""
        def layout(dpi):
            self.desktop.set_dpi(dpi)
            viewer = self.open("courtyard", "--size", "1200x760", "--scale", "0.2", "--technique", "single/hard", "--set", "single.size=256")
            viewer.click("vsync")  # where it is drawn it can be clicked
            viewer.until(lambda status: not status["vsync"], "vsync off")
            status, panel = viewer.status(), viewer.widgets()["panel"]
            self.close(viewer)
            left, top, right, bottom = status["widgets"]["screenshot"]
            return status["picture_size"], right - left, bottom - top, panel[2] - panel[0]
        self.addCleanup(self.desktop.set_dpi, None)
        usual, double = layout(96), layout(192)
        self.assertEqual(usual[0], double[0])
        for one, two in zip(usual[1:], double[1:]):
            self.assertAlmostEqual(two / one, 2.0, delta=0.1)

    def test_a_folder_that_cannot_be_written(self):
        gone = self.folder / "gone"
        gone.mkdir()
        viewer = self.open("courtyard", *QUICK, runs_in=gone)
        gone.rmdir()
        viewer.press("F12")
        self.assertIn("gnomon_0000.png", viewer.until(lambda status: status["message"], "a message")["message"])
        self.assertEqual(viewer.stdout(), "")
        self.close(viewer)

    def test_copied_command(self):
        viewer = self.open("courtyard", *QUICK)
        viewer.hold("w")
        viewer.click("copy_command")
        self.assertEqual(self.desktop.clipboard(), viewer.status()["command"])
        self.close(viewer)

    def test_vsync(self):
        viewer = self.open("courtyard", *QUICK)
        for on in (False, True):
            viewer.click("vsync")
            viewer.until(lambda status, on=on: status["vsync"] == on, f"vsync {on}")
            viewer.frames(4)
        self.close(viewer)

    def test_resize(self):
        viewer = self.open("courtyard", *QUICK)
        # Faster than it can draw, as a dragged frame does it; then it settles.
        for step in range(12):
            self.desktop.resize(viewer.window, 640 - 30 * step, 400 + 15 * step)
        for width, height in ((800, 500), (150, 120), (900, 300)):
            self.desktop.resize(viewer.window, width, height)
            viewer.until(lambda status, size=[width, height]: status["window_size"] == size, "the window's size")
            picture = [round(0.4 * width), round(0.4 * height)]
            viewer.until(lambda status, size=picture: status["picture_size"] == size, f"a picture of {picture}")
            viewer.frames()
            self.assertEqual(viewer.picture()[:2], (width, height))
        self.assertEqual(viewer.status()["message"], "")
        self.close(viewer)

    def test_panels_follow_the_window(self):
        viewer = self.open("courtyard", *QUICK)
        for width, height, shown in ((1100, 640, {"panel", "tools"}), (640, 400, {"panel"}), (400, 300, set()), (1200, 700, {"panel", "tools"})):
            self.desktop.resize(viewer.window, width, height)
            viewer.until(lambda status, size=[width, height]: status["window_size"] == size, "the window's size")
            status = viewer.until(lambda status, shown=shown: {"panel", "tools"} & set(status["widgets"]) == shown, f"{shown} unfolded")
            for name in shown:
                left, top, right, bottom = status["widgets"][name]
                self.assertTrue(0 <= left < right <= width and 0 <= top < bottom <= height, name)
        # Also those that were hidden meanwhile.
        viewer.press("F1")
        self.desktop.resize(viewer.window, 400, 300)
        viewer.until(lambda status: status["window_size"] == [400, 300], "the window's size")
        viewer.press("F1")
        viewer.frames()
        self.assertFalse({"panel", "tools"} & set(viewer.widgets()))
        self.close(viewer)

    def test_picture_size_apart_from_the_window(self):
        viewer = self.open("courtyard", *QUICK)
        viewer.enter("scale", "0.25")
        viewer.until(lambda status: status["picture_size"] == [160, 100], "the smaller picture")
        viewer.until_command("--size 160x100")
        self.close(viewer)

    def test_minimise_and_restore(self):
        viewer = self.open("courtyard", *QUICK)
        self.desktop.minimise(viewer.window)
        viewer.wait(lambda: self.stands_still(viewer), "no more frames")
        self.desktop.activate(viewer.window)
        viewer.frames(4)
        self.desktop.minimise(viewer.window)
        viewer.wait(lambda: self.stands_still(viewer), "no more frames")
        self.close(viewer)

    def stands_still(self, viewer):
        before = viewer.status()["frame"]
        time.sleep(0.5)  # many times what a frame takes
        return viewer.status()["frame"] == before


if __name__ == "__main__":
    unittest.main(verbosity=2)
