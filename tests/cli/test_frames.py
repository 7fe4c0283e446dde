"""gnomon render --frames: sequences along paths; lights written on the command line."""
import unittest

from program import QUICK, USAGE, Case

HARD = ["--technique", "single/hard"]


class Frames(Case):
    def frames(self, *arguments, scene="courtyard", name="out.png", expect=0):
        self.run_gnomon("render", scene, "-o", self.folder / name, *QUICK, *HARD, *arguments, expect=expect)
        return sorted(self.folder.iterdir())

    def test_numbered_pictures_that_differ(self):
        paths = self.frames("--frames", "3", "--path", "walk")
        self.assertEqual([path.name for path in paths], ["out_0000.png", "out_0001.png", "out_0002.png"])
        self.assertEqual(len({path.read_bytes() for path in paths}), 3)

    def test_walk_is_the_default_and_begins_at_the_first_camera(self):
        self.frames("--frames", "1")
        self.run_gnomon("render", "courtyard", "-o", self.folder / "still.png", *QUICK, *HARD)
        self.assertEqual((self.folder / "out_0000.png").read_bytes(), (self.folder / "still.png").read_bytes())

    def test_sun_path_with_a_standing_camera(self):
        paths = self.frames("--frames", "3", "--sun-path", "day", "--camera", "detail")
        self.assertEqual(len({path.read_bytes() for path in paths}), 3)

    def sun_file(self, *keys, name="sun.json"):
        path = self.folder.parent / f"{self.folder.name}_{name}"
        self.addCleanup(path.unlink)
        path.write_text('{"name": "a", "sun": [%s]}' % ", ".join(keys), encoding="utf-8")
        return path

    def test_sun_path_of_a_file(self):
        key = '{"time": %d, "azimuth": 200, "elevation": %d, "colour": [1, 1, 1], "intensity": 3}'
        sun = self.sun_file(key % (0, 40), key % (4, 70))
        paths = self.frames("--frames", "2", "--sun-path", sun, "--camera", "detail")
        self.assertEqual(len({path.read_bytes() for path in paths}), 2)
        still = self.folder / "still.png"
        light = "sun:200,70:intensity=3,colour=1/1/1"
        self.run_gnomon("render", "courtyard", "-o", still, *QUICK, *HARD, "--camera", "detail", "--light", light)
        self.assertEqual(paths[1].read_bytes(), still.read_bytes())

    def test_files_of_the_other_kind(self):
        key = '{"time": %d, "azimuth": 200, "elevation": 40, "colour": [1, 1, 1], "intensity": 3}'
        sun = self.sun_file(key % 0, key % 4)
        self.refused("render", "courtyard", "-o", self.folder / "out.png", *QUICK, *HARD, "--frames", "2", "--path", sun,
                     says=[sun.name, "'keys'", "--sun-path"])
        broken = self.sun_file(key % 0, name="broken.json")
        self.refused("render", "courtyard", "-o", self.folder / "out.png", *QUICK, *HARD, "--frames", "2", "--sun-path", broken,
                     says=[broken.name, "two keys"])

    def test_same_bytes_again_over_old_files(self):
        first = [path.read_bytes() for path in self.frames("--frames", "2", "--path", "turn", "--seconds", "1")]
        (self.folder / "out_0001.png").write_bytes(b"old")
        again = [path.read_bytes() for path in self.frames("--frames", "2", "--path", "turn", "--seconds", "1")]
        self.assertEqual(first, again)

    def test_misuse(self):
        def refuse(*arguments, says, scene="courtyard"):
            self.refused("render", scene, "-o", self.folder / "out.png", *QUICK, *HARD, *arguments, says=says)
            self.assertEqual(list(self.folder.iterdir()), [])

        refuse("--frames", "2", "--path", "run", says=["--path run", "walk", "turn", "fly"])
        refuse("--frames", "2", "--sun-path", "night", says=["--sun-path night", "day"])
        refuse("--frames", "0", says=["--frames"])
        refuse("--frames", "cats", says=["--frames"])
        refuse("--path", "walk", says=["--frames"])
        refuse("--seconds", "2", says=["--frames"])
        refuse("--frames", "2", "--seconds", "999", says=["--seconds", "walk"])
        refuse("--frames", "2", "--camera", "detail", says=["--camera"])
        refuse("--frames", "2", "--sun-path", "day", "--set", "light.elevation=20", says=["light.elevation"])
        refuse("--frames", "2", "--path", "walk", scene="chart/sphere", says=["none in this scene"])
        self.refused("render", "courtyard", "-o", self.folder / "out", "--frames", "2", *QUICK, says=[".png"])


class LightText(Case):
    def test_a_sun_by_its_angles(self):
        # A scene without lights: `--light sun` is then the sun of the settings.
        scene = self.folder / "floor.obj"
        scene.write_text("v -2 0 2\nv 2 0 2\nv 2 0 -2\nv -2 0 -2\nf 1 2 3 4\nv -1 1 1\nv 1 1 1\nv 0 1 -1\nf 5 6 7\n", encoding="utf-8")
        pictures = {}
        for name, arguments in {
            "text": ["--light", "sun:200,40"],
            "settings": ["--light", "sun", "--set", "light.azimuth=200", "--set", "light.elevation=40"],
            "other": ["--light", "sun:20,40"],
        }.items():
            path = self.folder / f"{name}.png"
            self.run_gnomon("render", scene, "-o", path, *QUICK, *HARD, *arguments)
            pictures[name] = path.read_bytes()
        self.assertEqual(pictures["text"], pictures["settings"])
        self.assertNotEqual(pictures["text"], pictures["other"])

    def test_misuse_names_what_is_valid(self):
        for text, says in {
            "spot:1,2,3": "spot:x,y,z:tx,ty,tz",
            "point:1,2,3:cats=4": "radius",
            "point:1,2,3:radius=-1": "0 to",
            "moon": "projector:x,y,z",
        }.items():
            with self.subTest(light=text):
                self.refused("render", "courtyard", "-o", self.folder / "x.png", *QUICK, "--light", text, expect=USAGE, says=[text, says])


if __name__ == "__main__":
    unittest.main(verbosity=2)
