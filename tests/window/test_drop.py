"""Files dragged from elsewhere onto the window."""
import unittest

from case import QUICK, WindowCase
from drop import DragSource


class Drop(WindowCase):
    def setUp(self):
        super().setUp()
        self.source = DragSource(self.desktop)
        self.addCleanup(self.source.close)

    def test_a_broken_file(self):
        path = self.folder / "broken file.obj"  # with a blank, which the address of a file writes as %20
        path.write_text("f 1 2 3\nv nonsense\n", encoding="utf-8")
        viewer = self.open("chart/slab", *QUICK)
        self.assertTrue(self.source.drop(viewer.window, [path], 500, 200))
        viewer.frames(4)
        self.assertIn("gnomon render chart/slab", viewer.status()["command"])
        self.close(viewer)


if __name__ == "__main__":
    unittest.main(verbosity=2)
