"""gnomon bench and presets: runs side by side, rows, resuming, errors; presets read, overridden, written."""
import json
import unittest

from program import QUICK, QUICK_TIMING, Case

SUITE = {
    "description": "two maps and the kernels", "source": "test",
    "defaults": {"scene": "chart/slab", "size": [64, 48], "set": {"single.size": 64}},
    "runs": [
        {"name": "hard", "technique": "single/hard", "counters": True,
         "plot": {"title": "p", "series": "s", "x": 64, "x_label": "texels", "of": "frame", "published": 3}},
        {"name": "pcf", "technique": "single/pcf", "set": {"pcf.size": 5}},
        {"name": "again", "technique": "single/hard"},
        {"name": "copy", "kernel": "copy", "texels": 64},
        {"name": "read", "kernel": "surface_read"},
        {"name": "alone", "technique": "single/hard"},
    ],
    "rows": [
        {"name": "pcf over hard", "of": "technique", "numerator": "pcf", "denominator": "hard", "published": [1, 2], "goal": 1000},
        {"name": "depth over copy", "of": "ms:depth", "numerator": "hard", "denominator": "copy", "denominator_of": "ms:kernel/copy"},
        {"name": "resolve over read", "of": "resolve", "numerator": "hard", "denominator": "read", "goal": 0},
        {"name": "copy in ms", "of": "build", "run": "copy", "published": 1.5},
        {"name": "same", "masks": ["hard", "again"]},
        {"name": "not the same", "masks": ["hard", "pcf"]},
    ],
}


def read_runs(folder):
    """The lines of a folder's results.jsonl, by run."""
    lines = [json.loads(line) for line in (folder / "results.jsonl").read_text(encoding="utf-8").splitlines()]
    return {line["bench"]["run"]: line for line in lines}


class PlanCase(Case):
    def write(self, name, content):
        path = self.folder / name
        path.write_text(json.dumps(content), encoding="utf-8")
        return path


class Bench(PlanCase):
    def bench(self, *arguments, **more):
        return self.run_gnomon("bench", *arguments, *QUICK_TIMING, "-o", self.folder / "out", **more)

    def test_a_suite(self):
        done = self.bench(self.write("mine.json", SUITE))
        runs = read_runs(self.folder / "out")
        self.assertEqual(list(runs), [run["name"] for run in SUITE["runs"]])
        for line in runs.values():
            self.assertEqual(line["status"], "ok")
            self.assertEqual(line["timing"]["frames"], 3)
            self.assertGreaterEqual(line["gpu_ms"]["total"], 0)
            self.assertNotIn("visibility", line)
            self.assertIn("--only", line["command"])
        self.assertEqual(runs["hard"]["bench"]["side_by_side"], ["hard", "pcf", "again", "copy", "read"])
        self.assertEqual(runs["alone"]["bench"]["side_by_side"], ["alone"])
        rows = {row["name"]: row for line in runs.values() for row in line["bench"]["rows"]}
        self.assertEqual(sorted(rows), sorted(row["name"] for row in SUITE["rows"]))
        ratio = rows["pcf over hard"]
        self.assertEqual(ratio["numerator"], runs["pcf"]["gpu_ms"]["total"])
        self.assertEqual(ratio["denominator"], runs["hard"]["gpu_ms"]["total"])
        self.assertEqual(ratio["published"], [1, 2])
        # Pictures this small may take no longer than an empty submission: a ratio over nothing is none.
        if ratio["denominator"] > 0:
            self.assertAlmostEqual(ratio["value"], ratio["numerator"] / ratio["denominator"])
            self.assertTrue(ratio["met"])
        self.assertEqual(rows["copy in ms"]["value"], runs["copy"]["gpu_ms"]["build"])
        self.assertTrue(rows["same"]["met"])
        self.assertFalse(rows["not the same"]["met"])
        for text in ["pcf over hard", "1.00..2.00", "single/depth", "equal", "differ"]:
            self.assertIn(text, done.stdout)
        page = (self.folder / "out" / "report.html").read_text(encoding="utf-8")
        self.assertIn("pcf over hard", page)
        self.run_gnomon("report", self.folder / "out")

    def test_only_and_resume(self):
        suite = self.write("mine.json", SUITE)
        self.bench(suite, "--only", "pcf over hard")
        first = read_runs(self.folder / "out")
        self.assertEqual(list(first), ["hard", "pcf"])
        done = self.bench(suite, "--only", "pcf over hard", "--resume")
        self.assertIn("kept", done.stderr)
        self.assertEqual(read_runs(self.folder / "out"), first)
        done = self.bench(suite, "--only", "pcf over hard", "--resume", "--set", "single.size=128")
        self.assertNotIn("kept", done.stderr)
        self.assertEqual(read_runs(self.folder / "out")["pcf"]["settings"]["single"]["size"], 128)
        # Another block beside the kept one; a line that is none is no obstacle.
        with (self.folder / "out" / "results.jsonl").open("a", encoding="utf-8") as file:
            file.write('{"cut off')
        done = self.bench(suite, "--only", "pcf over hard", "--only", "alone", "--resume", "--set", "single.size=128")
        self.assertEqual(done.stderr.count("kept"), 1)
        self.assertEqual(list(read_runs(self.folder / "out")), ["hard", "pcf", "alone"])

    def test_quick_makes_everything_small(self):
        self.run_gnomon("bench", "thesis", "--quick", "--only", "VSM: blur in the conversion over none", "-o", self.folder / "out")
        for line in read_runs(self.folder / "out").values():
            self.assertEqual(line["size"], [100, 75])
            self.assertEqual(line["settings"]["single"]["size"], 256)
            self.assertLess(line["scene"]["triangles"], 400000)
            self.assertTrue(line["bench"]["quick"])

    def test_a_scene_and_presets(self):
        self.bench("chart/slab", "--techniques", "single/hard,single/pcf", "--size", "64x48", "--set", "single.size=64")
        runs = read_runs(self.folder / "out")
        self.assertEqual(list(runs), ["single/hard", "single/pcf"])
        self.assertEqual(runs["single/pcf"]["bench"]["rows"][0]["name"], "single/pcf over single/hard")
        self.bench("chart/slab", "--preset", "thesis-single-hard", "--preset", "thesis-single-vsm", "--scale", "0.1")
        runs = read_runs(self.folder / "out")
        self.assertEqual(list(runs), ["thesis-single-hard", "thesis-single-vsm"])
        self.assertEqual(runs["thesis-single-vsm"]["size"], [80, 60])

    def test_every_built_in_suite_can_be_run(self):
        for suite in json.loads(self.run_gnomon("list", "suites", "--json").stdout):
            with self.subTest(suite=suite["name"]):
                self.assertIn("side by side", self.run_gnomon("bench", suite["name"], "--dry-run").stdout)

    def test_errors(self):
        self.refused("bench", says=["suite or scene"])
        self.refused("bench", "cats", "-o", self.folder / "out", says=["'cats'", "thesis", "courtyard"])
        self.refused("bench", self.folder / "absent.json", says=["absent.json"])
        self.refused("bench", "thesis", says=["--output"])
        self.refused("bench", "thesis", "-o", self.folder / "out", "--only", "cats", says=["cats", "valid rows"])
        self.refused("bench", "thesis", "-o", self.folder / "out", "--preset", "thesis-single-hard", says=["--preset"])
        self.refused("bench", "courtyard", "-o", self.folder / "out", "--techniques", "single/hard", "--set", "pcf.size=5", says=["pcf.size"])
        broken = dict(SUITE, runs=SUITE["runs"] + [{"name": "x", "technique": "single/cats"}])
        self.refused("bench", self.write("x.json", broken), "-o", self.folder / "out", says=["x.json", "runs[6]", "single/cats"])
        broken = dict(SUITE, runs=SUITE["runs"] + [{"name": "x", "technique": "single/hard", "set": {"single.cats": 1}}])
        self.refused("bench", self.write("x.json", broken), "-o", self.folder / "out", says=["runs[6]", "single.cats", "size"])
        self.assertFalse((self.folder / "out").exists())


class Presets(PlanCase):
    def lines(self, *arguments):
        self.run_gnomon("compare", *arguments, *QUICK_TIMING, "--set", "reference.samples=4", "-o", self.folder / "out")
        return [json.loads(line) for line in (self.folder / "out" / "results.jsonl").read_text(encoding="utf-8").splitlines()]

    def test_a_preset_of_ones_own_and_what_overrides_it(self):
        mine = self.write("mine.json", {"scene": "chart/slab", "techniques": ["single/hard", "single/pcf"], "size": [64, 48],
                                        "camera": "frame", "set": {"single.size": 128, "pcf.size": 5, "scene.gap": 0.5}})
        lines = self.lines("--preset", mine)
        self.assertEqual([line["technique"] for line in lines], ["single/hard", "single/pcf"])
        self.assertEqual(lines[1]["size"], [64, 48])
        self.assertEqual(lines[1]["settings"]["pcf"]["size"], 5)
        self.assertEqual(lines[1]["settings"]["scene"]["gap"], 0.5)
        more = self.write("more.json", {"set": {"single.size": 64}})
        lines = self.lines("chart/sphere", "--preset", mine, "--preset", more, "--techniques", "single/hard", "--size", "32x24")
        self.assertEqual([line["technique"] for line in lines], ["single/hard"])
        self.assertEqual(lines[0]["scene"]["name"], "chart/sphere")
        self.assertEqual(lines[0]["size"], [32, 24])
        self.assertEqual(lines[0]["settings"]["single"]["size"], 64)
        lines = self.lines("--preset", mine, "--set", "single.size=256")
        self.assertEqual(lines[0]["settings"]["single"]["size"], 256)

    def test_what_is_written_gives_the_same_run(self):
        written = self.folder / "written.json"
        first = self.lines("chart/slab", "--techniques", "single/pcf", "--size", "64x48", "--set", "pcf.size=5", "--set", "light.elevation=40",
                           "--set", "scene.gap=0.4", "--write-preset", written)
        again = self.lines("--preset", written)
        self.assertEqual(again[0]["settings"], first[0]["settings"])
        self.assertEqual(again[0]["visibility"], first[0]["visibility"])
        second = self.folder / "second.json"
        self.lines("--preset", written, "--write-preset", second)
        self.assertEqual(second.read_text(encoding="utf-8"), written.read_text(encoding="utf-8"))

    def test_render_with_a_built_in_preset(self):
        picture = self.folder / "x.png"
        self.run_gnomon("render", "--preset", "thesis-single-vsm-blurred", *QUICK, "--set", "scene.detail=0.05", "-o", picture)
        self.assertTrue(picture.is_file())

    def test_every_built_in_preset_is_valid(self):
        for preset in json.loads(self.run_gnomon("list", "presets", "--json").stdout):
            with self.subTest(preset=preset["name"]):
                page = json.loads(self.run_gnomon("describe", preset["name"]).stdout)
                self.assertIn("techniques", page)
                self.run_gnomon("bench", "--preset", preset["name"], "--dry-run")

    def test_errors(self):
        picture = self.folder / "x.png"
        self.refused("render", "-o", picture, says=["scene is required"])
        self.refused("render", "courtyard", "--preset", "cats", "-o", picture, says=["'cats'", "thesis-single-hard"])
        for content, says in [({"tecnique": "x"}, ["bad.json", "tecnique", "techniques"]),
                              ({"technique": "single/cats"}, ["bad.json", "single/cats", "single/pcf"]),
                              ({"scene": "courtyrd"}, ["bad.json", "courtyrd", "courtyard"]),
                              ({"set": {"pcf.cats": 3}}, ["bad.json", "pcf.cats", "size"]),
                              ({"set": {"cats.size": 3}}, ["bad.json", "cats", "pcf"]),
                              ({"set": {"pcf.size": 99}}, ["bad.json", "pcf.size", "1 to 15"])]:
            with self.subTest(content=content):
                self.refused("render", "courtyard", "--preset", self.write("bad.json", content), "-o", picture, says=says)
        both = self.write("both.json", {"techniques": ["single/hard", "single/pcf"]})
        self.refused("render", "courtyard", "--preset", both, "-o", picture, says=["2 techniques", "--technique"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
