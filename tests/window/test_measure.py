"""The plot of times, clips, and a report of what was collected."""
import json
import pathlib
import re
import shlex
import subprocess
import unittest

from case import WIDE, WindowCase, png
from viewer import PROGRAM

SLAB = [*WIDE, "--technique", "single/pcf", "--set", "single.size=256"]


class Measure(WindowCase):
    def test_plot(self):
        viewer = self.open("chart/slab", *SLAB)
        viewer.section("Measure")
        numbers = self.plot(viewer)
        viewer.until_text("plot", lambda text: int(text.split()[0]) > numbers[0] + 3)
        viewer.click("pause")
        viewer.until_text("plot", lambda text: text.endswith("paused"))
        held = self.plot(viewer)
        viewer.frames(6)
        self.assertEqual(self.plot(viewer)[0], held[0])
        viewer.click("pause")
        viewer.until_text("plot", lambda text: not text.endswith("paused"))
        viewer.click("separate_passes")
        rows = numbers[1]
        viewer.until_text("plot", lambda text: int(text.split()[2]) > rows + 3)
        viewer.click("separate_passes")
        self.close(viewer)

    def plot(self, viewer):
        """Frames and rows of the table."""
        found = re.match(r"(\d+) frames, (\d+) rows", viewer.until_text("plot", lambda _: True))
        return int(found[1]), int(found[2])

    def test_clip_and_report(self):
        viewer = self.open("chart/slab", *SLAB)
        viewer.section("Pictures, clips, reports")
        viewer.click("clip")
        viewer.hold("d", frames=6)
        viewer.click("clip")
        viewer.until_text("clip", lambda text: text == "stopped, 0 waiting")
        folder = next(path for path in self.folder.iterdir() if path.is_dir() and (path / "0000.png").is_file())
        pictures = sorted(path.name for path in folder.iterdir())
        self.assertGreater(len(pictures), 6)
        self.assertEqual(pictures, [f"{number:04}.png" for number in range(len(pictures))])
        first, last = (png.read(folder / name) for name in (pictures[0], pictures[-1]))
        self.assertEqual(first[:2], (275, 160))
        self.assertNotEqual(first[2], last[2])
        viewer.click("picture_exr")
        viewer.wait((self.folder / "gnomon_0000.exr").is_file, "the linear picture")
        words = shlex.split(viewer.status()["command"])
        subprocess.run([PROGRAM, *words[1:], "-o", "drawn.exr"], cwd=self.folder, check=True, capture_output=True)
        self.assertEqual((self.folder / "gnomon_0000.exr").read_bytes(), (self.folder / "drawn.exr").read_bytes())

        viewer.click("add_to_comparison")
        viewer.until_text("comparison", lambda text: text == "1 rows")
        viewer.click("add_to_comparison")
        viewer.until(lambda status: "has this technique" in status["message"], "that it is there already")
        viewer.search("pcf.size")
        viewer.enter("pcf.size", "9")
        viewer.until_command("--set pcf.size=9")
        viewer.click("add_to_comparison")
        viewer.until_text("comparison", lambda text: text == "2 rows")
        viewer.click("write_report")
        report = viewer.until_text("report", lambda text: text.endswith("report.html"), 240)
        self.assertIn("<html", pathlib.Path(report).read_text(encoding="utf-8"))
        lines = (self.folder / report).parent.joinpath("results.jsonl").read_text(encoding="utf-8").splitlines()
        rows = [json.loads(line) for line in lines]
        self.assertEqual(len(rows), 2)
        for row in rows:
            self.assertIn("single/pcf", json.dumps(row))
        self.assertEqual(["pcf.size=9" in json.dumps(row) or '"size": 9' in json.dumps(row) for row in rows], [False, True])
        self.close(viewer)


if __name__ == "__main__":
    unittest.main(verbosity=2)
