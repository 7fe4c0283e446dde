"""run.sh, without its installing and building: where results go, and what it refuses."""
import subprocess
import unittest

from program import OK, QUICK, QUICK_TIMING, USAGE, Case, run_script_root

TRIANGLES = "v 0 0 0\nv 4 0 0\nv 0 0 -4\nv 1 1 -1\nv 2 1 -1\nv 1 1 -2\nf 1 2 3\nf 4 5 6\n"


class RunScript(Case):
    def setUp(self):
        super().setUp()
        self.root = run_script_root(self.folder / "gnomon")

    def run_script(self, *arguments, expect=OK):
        done = subprocess.run([self.root / "run.sh", *map(str, arguments)], capture_output=True, text=True, timeout=300, cwd=self.folder, check=False)
        self.assertEqual(done.returncode, expect, f"{arguments}\nstdout: {done.stdout}\nstderr: {done.stderr[-4000:]}")
        return done

    def results(self):
        out = self.root / "out"
        return sorted(path.name for path in out.iterdir()) if out.exists() else []

    def test_subcommands_are_those_of_the_program(self):
        self.assertIn("courtyard", self.run_script("list", "scenes").stdout)
        self.assertIn("gnomon", self.run_script("--version").stdout)

    def test_unknown_word(self):
        done = self.run_script("nosuch", expect=USAGE)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for text in ["'nosuch'", "list, describe", "compare", "courtyard", ".gltf"]:
            self.assertIn(text, done.stderr)
        self.assertEqual(self.results(), [])

    def test_a_folder_for_each_scene(self):
        files = [self.folder / "a.obj", self.folder / "b" / "a.obj"]
        for path in files:
            path.parent.mkdir(exist_ok=True)
            path.write_text(TRIANGLES, encoding="utf-8")
        for scene in ["a.obj", "b/a.obj", "chart/slab"]:
            done = self.run_script(scene, "--techniques", "single/hard", *QUICK, *QUICK_TIMING)
            self.assertIn("report.html", done.stdout)
        self.assertEqual(self.results(), sorted(["b-a.obj", "chart-slab", self.folder.name + "-a.obj"]))


if __name__ == "__main__":
    unittest.main(verbosity=2)
