"""Running what a document shows: the program with few pixels, frames and rays, and what stands around it."""
import os
import pathlib
import subprocess
import sys

from documents import ROOT

sys.path.insert(0, str(ROOT / "tests" / "cli"))
from program import PROGRAM, QUICK, QUICK_TIMING, Case, run_script_root  # noqa: E402,F401

BUILD = pathlib.Path(PROGRAM).parents[1]


def without(arguments, option):
    """The arguments but for an option and its value."""
    if option not in arguments:
        return arguments
    at = arguments.index(option)
    return arguments[:at] + arguments[at + 2:]


def quick(arguments):
    """The same for the program, but small."""
    arguments = without(arguments, "--size")
    if arguments[0] == "compare":
        return arguments + QUICK + QUICK_TIMING
    if arguments[0] == "render":
        return without(arguments, "--frames") + ["--size", "48x32"] + (["--frames", "2"] if "--frames" in arguments else [])
    if arguments[0] == "view":
        # A pixel that is picked lies within the picture.
        return arguments + ["--size", "480x360", "--frames", "1", "--no-panels"]
    if arguments[0] in ("list", "describe", "doctor"):
        return arguments
    raise AssertionError(f"no test knows how to make 'gnomon {arguments[0]}' quick")


class CommandCase(Case):
    def setUp(self):
        super().setUp()
        self.environment = {**os.environ, "GNOMON": PROGRAM, "XDG_STATE_HOME": str(self.folder), "PYTHONDONTWRITEBYTECODE": "1"}

    def run_it(self, where, command, **options):
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=600, check=False,
                              **{"cwd": self.folder, "env": self.environment, **options})
        self.assertEqual(done.returncode, 0, f"{where}\n{command}\nstdout: {done.stdout[-2000:]}\nstderr: {done.stderr[-4000:]}")
        return done.stdout

    def run_tests(self, where, arguments):
        usage = self.run_it(where, [ROOT / "test.sh", "--help"])
        for option in [word for word in arguments if word.startswith("--")]:
            self.assertIn(option, usage, where)
        if "--label" in arguments:
            label = arguments[arguments.index("--label") + 1]
            self.assertIn(label, self.run_it(where, ["ctest", "--test-dir", BUILD, "--print-labels"]).split(), where)
        if "-R" in arguments:
            self.run_it(where, ["ctest", "--test-dir", BUILD, "--no-tests=error", "-N", *arguments])
