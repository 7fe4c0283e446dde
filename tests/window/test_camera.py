"""Walking and looking: keys and mouse move the camera the right way, and only where they are meant for it."""
import unittest

from case import WindowCase, camera


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class Camera(WindowCase):
    def setUp(self):
        super().setUp()
        # A short frame, so that a step is short: the camera must not fly through the ground.
        picture = ["--size", "640x400", "--scale", "0.2"]
        self.viewer = self.open("courtyard", *picture, "--technique", "single/hard", "--set", "single.size=256")

    def walk(self, *keys):
        """(eye, forward) before, and the way that the eye went."""
        eye, target = camera(self.viewer.status())
        self.viewer.hold(*keys)
        after, target_after = camera(self.viewer.status())
        for was, now in zip(minus(target, eye), minus(target_after, after)):
            self.assertAlmostEqual(was, now, places=3)  # walking does not turn
        return minus(target, eye), minus(after, eye)

    def test_keys(self):
        for key, sign in (("w", 1), ("s", -1)):
            forward, way = self.walk(key)
            self.assertGreater(sign * dot(forward, way), 0, key)
            longest = dot(forward, forward) * dot(way, way)
            self.assertAlmostEqual(dot(forward, way) ** 2, longest, delta=1e-3 * longest)
        for key, sign in (("d", 1), ("a", -1)):
            forward, way = self.walk(key)
            right = [-forward[2], 0, forward[0]]
            self.assertGreater(sign * dot(right, way), 0, key)
            self.assertAlmostEqual(way[1], 0, places=4)
        for key, sign in (("space", 1), ("Shift_L", -1), ("e", 1), ("q", -1)):
            _, way = self.walk(key)
            self.assertGreater(sign * way[1], 0, key)
            self.assertAlmostEqual(way[0], 0, places=4)
        self.close(self.viewer)

    def test_a_short_press_counts(self):
        eye, _ = camera(self.viewer.status())
        self.desktop.key("w", True)
        self.desktop.key("w", False)
        self.viewer.until(lambda status: camera(status)[0] != eye, "a step")
        self.close(self.viewer)

    def test_the_picture_follows_and_can_be_repeated(self):
        before = self.viewer.status()["command"]
        self.viewer.hold("w", frames=8)
        self.viewer.look(60, -20)
        status = self.viewer.status()
        self.assertNotEqual(status["command"], before)
        self.assertIn(f"--camera {status['camera']}", status["command"])
        self.close(self.viewer)

    def test_right_mouse_button(self):
        eye, target = camera(self.viewer.status())
        forward = minus(target, eye)
        self.viewer.look(80, 0)
        eye, target = camera(self.viewer.status())
        turned = minus(target, eye)
        self.assertGreater(dot([-forward[2], 0, forward[0]], turned), 0.1, "to the right")
        self.assertAlmostEqual(turned[1], forward[1], places=3)
        self.viewer.look(0, -80)
        eye, target = camera(self.viewer.status())
        self.assertGreater(minus(target, eye)[1], turned[1] + 0.1, "up")
        self.close(self.viewer)

    def test_the_left_button_and_the_panel_do_not_turn_it(self):
        before = self.viewer.status()["camera"]
        self.viewer.drag((500, 200), (560, 240))
        panel = self.viewer.widgets()["panel"]
        middle = ((panel[0] + panel[2]) / 2, (panel[1] + panel[3]) / 2)
        self.viewer.drag(middle, (middle[0] + 40, middle[1] + 20), button=3)
        self.assertEqual(self.viewer.status()["camera"], before)
        self.close(self.viewer)

    def test_the_wheel_changes_the_speed(self):
        self.viewer.point(600, 200)
        # Over the same number of frames a walk is as long as the frames took: far fewer steps of the wheel would do.
        self.viewer.wheel(8)
        _, fast = self.walk("d")
        self.viewer.wheel(-16)
        _, slow = self.walk("a")
        self.assertGreater(dot(fast, fast), 4 * dot(slow, slow))
        self.close(self.viewer)

    def test_typing_does_not_walk(self):
        before = self.viewer.status()["camera"]
        self.viewer.search("wasd")
        self.assertEqual(self.viewer.status()["camera"], before)
        self.close(self.viewer)


if __name__ == "__main__":
    unittest.main(verbosity=2)
