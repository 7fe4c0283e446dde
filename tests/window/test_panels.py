"""Every kind of widget, used with the mouse and the keyboard: what it changes is in the command line of the picture."""
import re
import unittest

from case import SMALL, WindowCase

# A scene of few triangles: its frames are short.
SCENE = "chart/slab"
PCF = [*SMALL, "--technique", "single/pcf", "--set", "single.size=256"]


class Panels(WindowCase):
    def value(self, viewer, key):
        """What the command line says about a parameter, or None."""
        found = re.search(rf"--set {re.escape(key)}=(\S+)", viewer.status()["command"])
        return found and found[1]

    def changed(self, viewer, key, before):
        viewer.until(lambda _: self.value(viewer, key) != before, f"another {key}")
        return self.value(viewer, key)

    def test_float(self):
        viewer = self.open(SCENE, *PCF, "--set", "pcf.kernel=vogel")
        viewer.search("pcf.radius")
        viewer.slide("pcf.radius", 0.9)
        self.assertGreater(float(self.changed(viewer, "pcf.radius", None)), 5)
        viewer.enter("pcf.radius", "2.5")
        viewer.until_command("--set pcf.radius=2.5")
        viewer.click("pcf.radius:reset")
        viewer.until(lambda _: float(self.value(viewer, "pcf.radius") or 1.5) == 1.5, "the default")
        self.close(viewer)

    def test_int(self):
        viewer = self.open(SCENE, *PCF)
        viewer.search("pcf.taps")
        viewer.slide("pcf.taps", 0.05)
        self.assertLess(int(self.changed(viewer, "pcf.taps", None)), 16)
        viewer.enter("pcf.taps", "40")
        viewer.until_command("--set pcf.taps=40")
        self.close(viewer)

    def test_bool_and_reset(self):
        viewer = self.open(SCENE, *PCF)
        viewer.search("pcf.bilinear")
        viewer.click("pcf.bilinear")
        viewer.until_command("--set pcf.bilinear=false")
        viewer.click("pcf.bilinear:reset")
        viewer.until_command(without=["pcf.bilinear=false"])
        self.close(viewer)

    def test_choice(self):
        viewer = self.open(SCENE, *PCF)
        viewer.search("pcf.kernel")
        viewer.choose("pcf.kernel", "poisson")
        viewer.until_command("--set pcf.kernel=poisson")
        self.close(viewer)

    def test_what_is_built_again_waits_for_the_release(self):
        viewer = self.open(SCENE, *PCF)
        viewer.search("single.size")
        left, top, right, bottom = viewer.rectangle("single.size")
        viewer.point((left + right) / 2, (top + bottom) / 2)
        self.desktop.button(1, True)
        viewer.frames(4)
        viewer.point(left + 0.2 * (right - left), (top + bottom) / 2)
        viewer.frames(4)
        self.assertEqual(self.value(viewer, "single.size"), "256", "while it is dragged")
        self.desktop.button(1, False)
        self.assertNotEqual(self.changed(viewer, "single.size", "256"), "256")
        viewer.enter("single.size", "128")
        viewer.until_command("--set single.size=128")
        self.close(viewer)

    def test_a_value_out_of_range_is_refused_with_the_reason(self):
        viewer = self.open(SCENE, *PCF)
        viewer.search("single.size")
        viewer.enter("single.size", "5")
        said = viewer.until(lambda status: status["message"], "a message")["message"]
        for text in ("single.size", "16"):
            self.assertIn(text, said)
        self.assertEqual(self.value(viewer, "single.size"), "256")
        viewer.enter("single.size", "64")
        viewer.until(lambda status: not status["message"], "no message")
        self.assertEqual(self.value(viewer, "single.size"), "64")
        self.close(viewer)

    def test_light_and_frame(self):
        viewer = self.open(SCENE, *PCF)
        for key, value in (("light.elevation", "25"), ("light.azimuth", "-40"), ("frame.exposure", "0.5")):
            viewer.search(key)
            viewer.enter(key, value)
            viewer.until_command(f"--set {key}={value}")
        viewer.search("frame.normal_maps")
        viewer.click("frame.normal_maps")
        viewer.until_command("--set frame.normal_maps=false")
        self.close(viewer)

    def test_search(self):
        viewer = self.open(SCENE, *PCF)
        viewer.search("bilinear")
        keys = [name for name in viewer.widgets() if "." in name]
        self.assertEqual([key for key in keys if not key.startswith("pcf.")], [])
        self.assertIn("pcf.bilinear", keys)
        viewer.search("no such thing")
        self.assertEqual([name for name in viewer.widgets() if "." in name], [])
        viewer.until_text("search", lambda text: text == "no parameter contains 'no such thing'")
        viewer.search("")
        viewer.until(lambda status: "search" not in status["texts"], "no such text")
        viewer.rectangle("pcf.bilinear")
        viewer.rectangle("single.size")
        self.close(viewer)

    def test_escape_closes_a_list(self):
        viewer = self.open(SCENE, *PCF)
        viewer.search("pcf.kernel")
        begin = viewer.status()
        for name in ("scene", "technique", "pcf.kernel"):
            viewer.click(name)
            viewer.entries(name)
            viewer.press("Escape")
            viewer.until(lambda status, name=name: not any(other.startswith(name + ":") for other in status["widgets"]), f"no list of '{name}'")
        viewer.press("Escape")  # nothing is open: nothing happens
        status = viewer.status()
        self.assertEqual([status[key] for key in ("command", "camera", "message")], [begin[key] for key in ("command", "camera", "message")])
        viewer.hold("w")  # and keys walk
        self.assertNotEqual(viewer.status()["camera"], begin["camera"])
        self.close(viewer)

    def test_technique(self):
        viewer = self.open(SCENE, *PCF)
        for technique, key in (("cascaded/hard", "cascaded.size"), ("single/vsm", "vsm.blur"), ("single/pcf", "pcf.size")):
            viewer.choose("technique", technique)
            viewer.until_command(f"--technique {technique}", seconds=120)
            viewer.rectangle(key)
        # What was set for the first is in force again.
        viewer.until_command("--set single.size=256", without=["vsm.", "cascaded."])
        self.close(viewer)

    def test_each_light_has_its_technique(self):
        viewer = self.open("lamps", *SMALL, "--light", "all", "--technique", "single/hard,cube/hard")
        lights = self.light_names(viewer)
        self.assertGreater(len(lights), 1)
        viewer.choose("light", lights[-1])
        viewer.search("exposure")
        viewer.enter("frame.exposure", "2")
        viewer.until_command("--set frame.exposure=2")
        self.close(viewer)

    def test_without_a_sun_nothing_places_one(self):
        viewer = self.open("lamps", *SMALL, "--technique", "single/hard,cube/hard", "--set", "single.size=128", "--set", "cube.size=128")
        viewer.search("light.")
        self.assertEqual([name for name in viewer.widgets() if name.startswith("light.")], ["light.intensity"])
        viewer.enter("light.intensity", "500")
        viewer.until_command("--set light.intensity=500")
        viewer.click("light.intensity:reset")
        viewer.until_command(without=["light.intensity"])
        viewer.search("light.azimuth")
        viewer.until_text("search", lambda text: "no parameter" in text)
        self.assertEqual(viewer.status()["message"], "")
        self.close(viewer)

    def light_names(self, viewer):
        viewer.click("light")
        names = viewer.entries("light")
        viewer.press("Escape")
        return names


if __name__ == "__main__":
    unittest.main(verbosity=2)
