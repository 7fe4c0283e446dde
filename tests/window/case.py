"""What the window tests share: a display for the file, a folder for each test, and what is kept of one that failed."""
import functools
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import unittest

from display import Display
from desktop import Desktop, png
from viewer import PROGRAM, Viewer

OK, FAILURE, USAGE, DEVICE = range(4)
INTERRUPTED = 130
OUTPUT = pathlib.Path(os.environ.get("GNOMON_WINDOW_OUTPUT", "build/window_tests")).resolve()

# A small window and a smaller picture: a device without a GPU draws it in a few hundredths of a second.
SMALL = ["--size", "640x400", "--scale", "0.4"]
QUICK = [*SMALL, "--technique", "single/hard", "--set", "single.size=512"]


# With room for the tools at the right, and a picture between them and the panel.
WIDE = ["--size", "1100x640", "--scale", "0.25"]


class WindowCase(unittest.TestCase):
    """Each test has a folder below OUTPUT, which stays when it fails: what the viewer wrote, and the screen at that moment."""

    def __init__(self, name="runTest"):
        super().__init__(name)
        setattr(self, name, functools.partial(self._keeping_screen, getattr(self, name)))

    @classmethod
    def setUpClass(cls):
        folder = OUTPUT / cls.__name__
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        cls.display = Display(folder)
        cls.addClassCleanup(cls.display.close)
        cls.desktop = Desktop(cls.display.name)
        cls.addClassCleanup(cls.desktop.disconnect)

    def setUp(self):
        self.folder = OUTPUT / type(self).__name__ / self._testMethodName
        self.folder.mkdir()
        self.failed = False
        self.addCleanup(lambda: self.failed or shutil.rmtree(self.folder))

    def _keeping_screen(self, test):
        try:
            test()
        except unittest.SkipTest:
            raise
        except BaseException:
            self.failed = True
            self.desktop.save_picture(self.folder / "screen.png")
            print(f"kept: {self.folder}", file=sys.stderr)
            raise

    def start(self, *arguments, **options):
        """A viewer whose window is not waited for."""
        viewer = Viewer(self.display, self.desktop, self.folder, *arguments, **options)
        self.addCleanup(viewer.kill)
        return viewer

    def open(self, scene="courtyard", *arguments, **options):
        return self.start(scene, *(arguments or QUICK), **options).open()

    def close(self, viewer):
        """Every test ends so: what validation has to say, it says with another exit code."""
        self.assertEqual(viewer.close(), OK, viewer.stderr())

    def render(self, command, path, *more):
        """Runs the `gnomon render ...` that the viewer tells, with an output of our own. Returns the picture."""
        words = shlex.split(command)
        if "-o" in words:
            at = words.index("-o")
            del words[at:at + 2]
        self.assertEqual(words[:2], ["gnomon", "render"])
        words[0] = PROGRAM
        done = subprocess.run([*words, *more, "-o", str(path)], capture_output=True, text=True, timeout=120, cwd=self.folder, check=False)
        self.assertEqual(done.returncode, OK, f"{command}\n{done.stderr}")
        return png.read(path)


def camera(status):
    """(eye, target) of a status: two lists of three numbers."""
    return [[float(number) for number in point.split(",")] for point in status["camera"].split(":")]
