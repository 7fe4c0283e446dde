"""gnomon render: one picture."""
import struct
import unittest

from program import QUICK, USAGE, Case


def png_size(path):
    with open(path, "rb") as file:
        head = file.read(24)
    assert head[:8] == b"\x89PNG\r\n\x1a\n", path
    return struct.unpack(">II", head[16:24])


class Render(Case):
    def test_every_kind_of_picture(self):
        for show in ["shaded", "mask", "error", "reference"]:
            with self.subTest(show=show):
                path = self.folder / f"{show}.png"
                done = self.run_gnomon("render", "courtyard", "-o", path, "--show", show, *QUICK)
                self.assertEqual(done.stdout, "")
                self.assertEqual(png_size(path), (96, 64))

    def test_exr(self):
        for show in ["shaded", "mask", "reference"]:
            path = self.folder / f"{show}.exr"
            self.run_gnomon("render", "chart/sphere", "-o", path, "--show", show, *QUICK)
            self.assertEqual(path.read_bytes()[:4], b"\x76\x2f\x31\x01")
        self.refused("render", "chart/sphere", "-o", self.folder / "e.exr", "--show", "error", *QUICK, expect=USAGE, says=[".png"])

    def test_views(self):
        pictures = set()
        for number, view in enumerate([[], ["--camera", "detail"], ["--camera", "frame"], ["--camera", "0,5,9:0,1,0"],
                                       ["--set", "light.elevation=60"], ["--set", "camera.vertical_fov=90"],
                                       ["--light", "sun", "--set", "light.azimuth=0"]]):
            path = self.folder / f"{number}.png"
            self.run_gnomon("render", "courtyard", "-o", path, *QUICK, *view)
            pictures.add(path.read_bytes())
        self.assertEqual(len(pictures), 7)

    def test_same_command_same_bytes(self):
        for name in ["a.png", "b.png"]:
            self.run_gnomon("render", "courtyard", "-o", self.folder / name, *QUICK)
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_multisampling(self):
        self.run_gnomon("render", "courtyard", "-o", self.folder / "x.png", "--samples", "4", *QUICK)
        self.assertEqual(png_size(self.folder / "x.png"), (96, 64))

    def test_validation_flag(self):
        self.run_gnomon("--validate", "render", "courtyard", "-o", self.folder / "x.png", *QUICK)


if __name__ == "__main__":
    unittest.main(verbosity=2)
