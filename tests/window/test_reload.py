"""A shader that is edited while the window shows it, in a copy of the source tree."""
import os
import pathlib
import shutil
import time
import unittest

from case import QUICK, WindowCase
from viewer import difference

ROOT = pathlib.Path(__file__).resolve().parents[2]
FILTER = "shadow/map/filter/hard/hard.glsl"


class Reload(WindowCase):
    def test_edit_mistake_and_mend(self):
        tree = self.folder / "tree"
        shutil.copytree(ROOT / "src", tree / "src")
        file = tree / "src" / FILTER
        text = file.read_text(encoding="utf-8")
        begin = "float lit(uint map_image, MapSample at, FilterParams params) {"
        self.assertIn(begin, text)
        viewer = self.open("courtyard", *QUICK, environment={"GNOMON_SOURCE_TREE": str(tree)})
        viewer.press("F1")
        viewer.frames(4)
        plain = viewer.picture()

        self.write(file, text.replace(begin, begin + "\n  if (at.layer < 1000000) return 0.0;"))
        start = time.monotonic()
        viewer.wait(lambda: difference(viewer.picture(), plain) > 4.0, "a darker picture", 60)
        print(f"from the edit to the picture: {time.monotonic() - start:.2f} s", flush=True)
        viewer.frames()
        self.assertEqual(viewer.status()["message"], "")
        dark = viewer.picture()

        self.write(file, text.replace(begin, begin + "\n  this is no GLSL;"))
        said = viewer.until(lambda status: status["message"], "the compiler's message", 60)["message"]
        line = text[:text.index(begin)].count("\n") + 2
        self.assertIn(f"{FILTER}:{line}: error", said)
        height = viewer.picture()[1]
        self.assertLess(difference(self.above(viewer.picture(), height // 3), self.above(dark, height // 3)), 0.5, "the old picture stays")

        self.write(file, text)
        viewer.until(lambda status: not status["message"], "no message", 60)
        viewer.wait(lambda: difference(viewer.picture(), plain) < 0.5, "the picture of the beginning", 60)
        self.close(viewer)

    def above(self, picture, rows):
        return picture[0], rows, picture[2][:3 * picture[0] * rows]

    def write(self, file, text):
        """As editors do it: by another file that takes its name."""
        other = file.with_suffix(".new")
        other.write_text(text, encoding="utf-8")
        os.replace(other, file)


if __name__ == "__main__":
    unittest.main(verbosity=2)
