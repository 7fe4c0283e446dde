"""How the window comes, and how it goes: by itself, by a key, by its frame, by a signal, and not at all."""
import unittest

from case import DEVICE, INTERRUPTED, OK, QUICK, SMALL, USAGE, WindowCase


class Start(WindowCase):
    def test_close_button(self):
        viewer = self.open()
        status = viewer.status()
        self.assertEqual(status["window_size"], [640, 400])
        self.assertEqual(status["picture_size"], [256, 160])
        self.assertEqual(status["message"], "")
        self.assertIn("gnomon render courtyard", status["command"])
        self.close(viewer)
        self.assertEqual(viewer.stdout(), "")

    def test_control_q(self):
        viewer = self.open()
        viewer.desktop.key("Control_L", True)
        viewer.frames()
        viewer.desktop.key("q", True)
        self.assertEqual(viewer.wait_for_end(), OK, viewer.stderr())
        for key in ("q", "Control_L"):
            viewer.desktop.key(key, False)

    def test_interrupt(self):
        viewer = self.open()
        self.assertEqual(viewer.interrupt(), INTERRUPTED, viewer.stderr())

    def test_so_many_frames_and_a_picture_of_the_last(self):
        viewer = self.start("courtyard", *QUICK, "--frames", "3", "--screenshot", "last.png")
        self.assertEqual(viewer.wait_for_end(120), OK, viewer.stderr())
        self.assertEqual(viewer.status()["frame"], 3)
        self.assertTrue((self.folder / "last.png").is_file())

    def test_no_display(self):
        for name in ("", ":999"):
            with self.subTest(display=name):
                viewer = self.start("courtyard", *QUICK, environment={"DISPLAY": name})
                self.assertEqual(viewer.wait_for_end(), DEVICE)
                for text in ("gnomon render", "gnomon compare"):
                    self.assertIn(text, viewer.stderr())
                self.assertEqual(viewer.stdout(), "")

    def test_misuse(self):
        for arguments, says in {
            ("no_such_scene",): ["no_such_scene", "courtyard"],
            ("courtyard", "--technique", "single/cats"): ["cats"],
            ("courtyard", "--scale", "9"): ["--scale"],
            ("courtyard", "--screenshot", "a.bmp"): [".png"],
            ("courtyard", *QUICK, "--map", "99"): ["--map 99", "single/hard", "valid", "0"],
            ("courtyard", *SMALL, "--technique", "ray_traced", "--map", "0"): ["--map 0", "ray_traced"],
        }.items():
            with self.subTest(arguments=arguments):
                viewer = self.start(*arguments)
                self.assertEqual(viewer.wait_for_end(), USAGE, viewer.stderr())
                for text in says:
                    self.assertIn(text, viewer.stderr())

    def test_a_second_side_that_suits_no_light(self):
        viewer = self.start("courtyard", *QUICK, "--split", "cube/pcf")
        self.assertEqual(viewer.wait_for_end(), DEVICE, viewer.stderr())
        for text in ("cube/pcf", "sun"):
            self.assertIn(text, viewer.stderr())


if __name__ == "__main__":
    unittest.main(verbosity=2)
