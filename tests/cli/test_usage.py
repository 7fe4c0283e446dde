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

    def test_the_parser_speaks_in_one_line(self):
        out = self.folder / "out"
        cases = [
            ([], "error: a subcommand is missing; valid: list, describe, "),
            (["frobnicate"], "error: unknown subcommand 'frobnicate'; valid: list, describe, "),
            (["--cats", "list"], "error: unknown option '--cats'; valid: "),
            (["compare", "courtyard", "-o", out, "--cats=3"], "error: unknown option '--cats'; valid: "),
            (["compare", "courtyard", "-o", out, "terrain"], "error: compare: 'terrain' is one argument too many"),
            (["compare", "courtyard"], "error: compare: --output is required"),
            (["render", "courtyard", "-o", "x.png", "--show", "cats"], "error: --show cats: valid: error, mask, reference, shaded"),
            (["list", "cats"], "error: what cats: valid: techniques, scenes, presets, suites, metrics, devices"),
            (["compare", "courtyard", "-o", out, "--max-error", "2"], "error: --max-error 2: valid: 0 to 1"),
            (["compare", "courtyard", "-o", out, "--samples", "cats"], "error: --samples cats: valid: a whole number, 0 or more"),
            (["compare", "courtyard", "-o"], "error: --output: its value is missing"),
        ]
        for arguments, text in cases:
            with self.subTest(arguments=arguments):
                message = self.refused(*arguments, says=[text])
                self.assertEqual(len(message.splitlines()), 1, message)
        self.assertFalse(out.exists())

    def test_nothing_is_left_where_nothing_was_measured(self):
        out = self.folder / "out"
        self.refused("compare", "nosuch", "-o", out, says=["nosuch", "courtyard"])
        self.refused("compare", self.folder / "absent.obj", "-o", out, expect=FAILURE, says=["absent.obj"])
        # Nothing faces a sun below the ground; the warning says why.
        self.refused("compare", "chart/slab", "-o", out, "--set", "light.elevation=-20", *QUICK, expect=FAILURE,
                     says=["not above the horizon", "there is no shadow to compare"])
        self.assertFalse(out.exists())

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
