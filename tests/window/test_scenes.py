"""Another scene in the same window: what the user has made and chosen stays; what belongs to a scene is found again there."""
import unittest

from case import WIDE, WindowCase
from viewer import difference, part


class Scenes(WindowCase):
    def open_scene(self, viewer, name):
        viewer.fill("scene_path", name)
        viewer.press("Return")
        viewer.until(lambda status: f"render {name} " in status["command"] and not status["loading"], name, 60)
        viewer.frames()

    def test_work_survives(self):
        viewer = self.open("chart/slab", *WIDE, "--technique", "single/hard", "--set", "single.size=256", "--split", "ray_traced",
                           "--overlay", "layers", "--map", "0")
        viewer.until(lambda status: "map_window" in status["widgets"], "the map")
        # All that the command line said is changed: none of it may come again.
        viewer.press("m")
        viewer.press("v")
        viewer.until_text("overlay", lambda text: text == "texel grid")
        viewer.press("b")
        viewer.until_text("sides", lambda text: text == "single/hard | ray_traced, second")
        viewer.hold("w", frames=6)
        viewer.press("Control_L", "1")
        saved = viewer.status()["camera"]
        viewer.until_command(f"--camera {saved}")
        viewer.section("Pictures, clips, reports")
        viewer.click("add_to_comparison")
        viewer.until_text("comparison", lambda text: text == "1 rows")

        self.open_scene(viewer, "chart/sphere")
        texts = viewer.status()["texts"]
        self.assertEqual(texts["overlay"], "texel grid")
        self.assertEqual(texts["sides"], "single/hard | ray_traced, second")
        self.assertEqual(texts["comparison"], "1 rows")
        self.assertEqual(texts["report_of"], "1 of 1 in chart/sphere")
        self.assertNotIn("map_window", viewer.widgets())
        # A camera is of its scene.
        viewer.press("1")
        viewer.frames(3)
        self.assertNotIn("--camera", viewer.status()["command"])
        viewer.press("b")
        viewer.until_text("sides", lambda text: text == "single/hard | ray_traced, first")

        self.open_scene(viewer, "chart/slab")
        viewer.until_text("sides", lambda text: text == "single/hard | ray_traced, first")
        self.assertNotIn(saved, viewer.status()["command"])
        viewer.press("1")
        viewer.until_command(f"--camera {saved}")
        self.assertEqual(viewer.text("comparison"), "1 rows")
        self.close(viewer)

    def test_who_casts_is_clicked(self):
        """The list below the scene takes an object's shadow away, and gives it back."""
        viewer = self.open("chart/slab", *WIDE, "--technique", "single/hard", "--set", "single.size=256")
        whole = viewer.picture()
        viewer.click("casting")
        viewer.until(lambda status: "cast:slab" in status["widgets"], "the list")
        viewer.click("cast:slab")
        viewer.until_command("--cast slab=off")
        viewer.frames(3)
        without = viewer.picture()
        # The middle of the window is the scene.
        area = (400, 150, 760, 500)
        self.assertGreater(difference(part(whole, *area), part(without, *area)), 4)
        viewer.click("cast_reset")
        viewer.until(lambda status: "--cast" not in status["command"], "no rule")
        viewer.frames(3)
        self.assertLess(difference(part(whole, *area), part(viewer.picture(), *area)), 0.5)
        self.close(viewer)

    def test_lights_that_the_chosen_technique_does_not_serve(self):
        """Neither another scene nor a preset fails because of them."""
        viewer = self.open("chart/slab", *WIDE, "--technique", "cascaded/hard", "--set", "cascaded.size=128", "--split", "cascaded/vsm")
        self.open_scene(viewer, "lamps")
        viewer.until_command("--technique cascaded/hard,cube/pcf,single/pcf")
        viewer.until_text("sides", lambda text: text == "cube/pcf, single/pcf, cascaded/hard | cube/pcf, single/pcf, cascaded/vsm")
        viewer.section("Presets, undo")
        viewer.choose("builtin_preset", "thesis-cascaded-vsm-blurred")
        viewer.until_command("--technique cascaded/vsm,cube/pcf,single/pcf")
        self.assertEqual(viewer.status()["message"], "")
        self.close(viewer)


if __name__ == "__main__":
    unittest.main(verbosity=2)
