"""What `gnomon view` is told to explain: refused before any window opens, and in words."""
import unittest

from program import Case


class Explain(Case):
    def view(self, *arguments, says):
        return self.refused("view", "courtyard", *arguments, says=says)

    def test_overlays(self):
        self.view("--overlay", "cats", says=["--overlay cats", "lines, layers, texels, footprint, flags, overdraw"])
        self.view("--overlay", "layers,cats", says=["--overlay cats"])
        self.view("--overlay", "layers,texels", says=["'layers' and 'texels'", "one of them"])

    def test_picks(self):
        for pixel in ["12", "12,", "a,b", "-1,3", "1,2,3"]:
            with self.subTest(pixel=pixel):
                self.view(f"--pick={pixel}", says=[f"--pick {pixel}", "120,80"])

    def test_maps(self):
        self.view("--map", "first", says=["--map first", "the number of a layer"])


if __name__ == "__main__":
    unittest.main()
