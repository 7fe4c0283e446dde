"""Runs gnomon as a user does. The path of the program comes from the environment variable GNOMON."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

PROGRAM = os.path.abspath(os.environ.get("GNOMON", "build/release/bin/gnomon"))
ROOT = pathlib.Path(__file__).resolve().parents[2]
SHARED_SCENES = ROOT.parent / "shared" / "scenes"

OK, FAILURE, USAGE, DEVICE, THRESHOLD = range(5)

# Small pictures, few frames, few rays: the numbers are not looked at, only their path.
QUICK = ["--size", "96x64", "--set", "reference.samples=8", "--set", "reference.pixel_samples=4"]
QUICK_TIMING = ["--set", "measure.frames=3", "--set", "measure.warm_up=0"]


class Case(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="gnomon test ")  # with a blank, as users have them
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_gnomon(self, *arguments, expect=OK, cwd=None):
        """The finished process; fails the test when the exit code is another one than `expect`."""
        command = [PROGRAM, *map(str, arguments)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=300, cwd=cwd, check=False)
        self.assertEqual(done.returncode, expect, f"{command}\nstdout: {done.stdout}\nstderr: {done.stderr[-4000:]}")
        return done

    def refused(self, *arguments, expect=USAGE, says=()):
        """The message of a run that must fail: it holds every text of `says`, and stdout stays empty."""
        done = self.run_gnomon(*arguments, expect=expect)
        self.assertEqual(done.stdout, "")
        for text in says:
            self.assertIn(text, done.stderr)
        return done.stderr

    def compare(self, scene, output, *arguments, expect=OK):
        return self.run_gnomon("compare", scene, "-o", output, *QUICK, *QUICK_TIMING, *arguments, expect=expect)


def run_script_root(root):
    """A root with run.sh that neither installs nor builds, and this program."""
    (root / "scripts").mkdir(parents=True)
    (root / "build" / "release" / "bin").mkdir(parents=True)
    shutil.copy(ROOT / "run.sh", root)
    (root / "scripts" / "stage.sh").write_text("prepare() { :; }\nstage() { :; }\n", encoding="utf-8")
    (root / "build" / "release" / "bin" / "gnomon").symlink_to(PROGRAM)
    return root


def read_lines(folder):
    """The lines of a folder's results.jsonl, by technique."""
    text = (pathlib.Path(folder) / "results.jsonl").read_text(encoding="utf-8")
    lines = [json.loads(line) for line in text.splitlines()]
    return {line["technique"]: line for line in lines}
