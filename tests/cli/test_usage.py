"""Misuse: the exit code, and a message that names the key or file and what would be valid."""
import os
import unittest

from program import DEVICE, FAILURE, QUICK, USAGE, Case


class Usage(Case):
    def render(self, *arguments, scene="courtyard", expect=USAGE, says=()):
        return self.refused("render", scene, "-o", self.folder / "x.png", *arguments, expect=expect, says=says)

    def test_subcommand_and_options(self):
        self.refused(says=["subcommand"])
        self.refused("frobnicate", says=["compare"])
        self.refused("list", "cats", says=["cats", "techniques"])
        self.refused("describe", says=["technique"])
        self.refused("compare", "courtyard", says=["--output"])
        self.refused("compare", "courtyard", "-o", self.folder, "--bogus", says=["--bogus"])
        self.refused("render", "courtyard", "-o", self.folder / "x.png", "--show", "cats", says=["cats", "mask"])
        self.refused("compare", "courtyard", "-o", self.folder, "--max-error", "2", says=["--max-error", "1"])

    def test_unknown_names_come_with_the_valid_ones(self):
        self.refused("describe", "single/cats", says=["single/cats", "single/pcf"])
        self.render("--technique", "single/cats", says=["single/cats", "single/pcf"])
        self.refused("compare", "courtyard", "-o", self.folder / "out", "--techniques", "single/pcf,cats", says=["cats", "single/pcf"])
        self.render(scene="courtyrd", says=["courtyrd", "courtyard", "terrain", ".gltf"])
        self.render("--camera", "9", says=["--camera 9", "detail"])
        self.render("--light", "moon", says=["--light moon", "sun"])

    def test_sizes(self):
        for size in ["x", "96", "96x", "x64", "0x64", "96x0", "-1x64", "96x64x3", "96 x 64", "9.5x64", "99999x64", "catsxdogs"]:
            with self.subTest(size=size):
                self.render("--size=" + size, says=["--size", "WIDTHxHEIGHT", "16384"])

    def test_samples(self):
        self.render("--samples", "0", *QUICK, expect=DEVICE, says=["0 samples", "offers 1"])
        self.render("--samples", "3", *QUICK, expect=DEVICE, says=["3 samples", "offers 1"])
        self.render("--samples", "cats", says=["cats"])

    def test_settings(self):
        cases = [
            ("pcf", ["pcf", "id.key=value"]),
            ("=3", ["id.key=value"]),
            ("pcf.size", ["pcf.size", "id.key=value"]),
            ("cats.size=3", ["cats", "pcf", "single", "light"]),
            ("pcf.cats=3", ["pcf.cats", "size"]),
            ("pcf.size=cats", ["pcf.size", "cats", "1 to 15"]),
            ("pcf.size=", ["pcf.size", "1 to 15"]),
            ("pcf.size=16", ["pcf.size", "16", "1 to 15"]),
            ("pcf.size=3.5", ["pcf.size", "3.5", "whole"]),
            ("pcf.bilinear=maybe", ["pcf.bilinear", "maybe"]),
            ("light.elevation=nan", ["light.elevation", "nan"]),
            ("light.elevation=91", ["light.elevation", "-90 to 90"]),
            ("reference.kind=cats", ["reference.kind", "embree", "pipeline"]),
            ("scene.cats=1", ["scene.cats", "courtyard"]),
            ("scene.detail=cats", ["scene.detail", "cats"]),
        ]
        for assignment, says in cases:
            with self.subTest(assignment=assignment):
                self.render("--set", assignment, says=says)
        self.render("--set", "scene.detail=5", scene="terrain", says=["scene.detail", "0.001 to 4"])

    def test_a_setting_that_does_nothing_is_refused(self):
        self.render("--technique", "single/hard", "--set", "pcf.size=5", says=["pcf.size"])
        out = self.folder / "out"
        self.refused("compare", "courtyard", "-o", out, "--techniques", "ray_traced", "--set", "pcf.size=5", says=["pcf.size"])
        self.assertFalse(out.exists())

    def test_devices(self):
        self.refused("--device", "no such device", "doctor", expect=DEVICE, says=["no such device", "0:"])
        self.refused("--device", "99", "doctor", expect=DEVICE, says=["99", "0:"])

    def test_output_places(self):
        self.refused("render", "courtyard", "-o", self.folder / "x.bmp", *QUICK, says=["x.bmp", ".png"])
        absent = self.folder / "absent" / "x.png"
        self.refused("render", "chart/slab", "-o", absent, *QUICK, expect=FAILURE, says=[str(absent)])
        a_file = self.folder / "a_file"
        a_file.write_text("kept", encoding="utf-8")
        self.refused("compare", "chart/slab", "-o", a_file, *QUICK, expect=FAILURE, says=[str(a_file)])
        self.assertEqual(a_file.read_text(encoding="utf-8"), "kept")
        self.refused("compare", "chart/slab", "-o", "/proc/gnomon", *QUICK, expect=FAILURE, says=["/proc/gnomon"])

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_read_only_folder(self):
        closed = self.folder / "closed"
        closed.mkdir(mode=0o500)
        self.refused("compare", "chart/slab", "-o", closed, *QUICK, expect=FAILURE, says=[str(closed)])

    def test_report_without_results(self):
        self.refused("report", self.folder / "absent", expect=FAILURE, says=["absent", "results.jsonl"])
        (self.folder / "results.jsonl").write_text('{"technique": ', encoding="utf-8")
        self.refused("report", self.folder, expect=FAILURE, says=["results.jsonl"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
