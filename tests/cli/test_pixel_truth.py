"""The truth of pixels against a picture of four times the size, averaged here: 16 points a pixel are the very same points."""
import struct
import unittest
import zlib

from program import Case

WIDTH, HEIGHT = 72, 54
# One surface fills the picture: a floor, under plates that the camera looks beneath.
SCENE = """
v -30 0 -30
v 30 0 -30
v 30 0 30
v -30 0 30
f 4 3 2 1
""" + "".join(f"""
v {x} 6 {z}
v {x + 1.7} 6 {z + 0.4}
v {x + 1.1} 6 {z + 1.9}
f -1 -2 -3
""" for x in range(-9, 9, 3) for z in range(-9, 9, 3))


def read_png(path):
    """Rows of RGBA, 8 bits, as gnomon writes them."""
    data = path.read_bytes()
    at, packed, size = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
            channels = {2: 3, 6: 4}[body[9]]
        packed += body if kind == b"IDAT" else b""
        at += 12 + length
    raw, rows, last = zlib.decompress(packed), [], [0] * (size[0] * channels)
    for y in range(size[1]):
        start = y * (size[0] * channels + 1)
        kind, row = raw[start], list(raw[start + 1:start + 1 + size[0] * channels])
        for i in range(len(row)):
            left, up = row[i - channels] if i >= channels else 0, last[i]
            corner = last[i - channels] if i >= channels else 0
            if kind == 1:
                row[i] += left
            elif kind == 2:
                row[i] += up
            elif kind == 3:
                row[i] += (left + up) // 2
            elif kind == 4:
                guess = left + up - corner
                row[i] += min((left, up, corner), key=lambda value: abs(guess - value))
            row[i] &= 255
        rows.append([row[i:i + 3] for i in range(0, len(row), channels)])
        last = row
    return rows


class PixelTruth(Case):
    def reference(self, against, width, height, *arguments):
        scene = self.folder / "plates.obj"
        scene.write_text(SCENE, encoding="utf-8")
        picture = self.folder / f"{against}.png"
        self.run_gnomon("render", scene, "-o", picture, "--size", f"{width}x{height}", "--camera", "1,5,4:0.3,0,0", "--show", "reference",
                        "--against", against, "--set", "light.angular_diameter=0", *arguments)
        rows = read_png(picture)
        self.assertEqual((len(rows[0]), len(rows)), (width, height))
        return rows

    def test_is_the_mean_of_a_larger_picture(self):
        large = self.reference("hard", 4 * WIDTH, 4 * HEIGHT)
        pixel = self.reference("pixel", WIDTH, HEIGHT)
        worst = total = partial = 0
        for y in range(HEIGHT):
            for x in range(WIDTH):
                block = [large[4 * y + j][4 * x + i] for j in range(4) for i in range(4)]
                for red, green, blue in block:
                    self.assertTrue(red == green == blue, "every point of this picture receives light")
                mean = sum(colour[0] for colour in block) / 16 / 255
                # Sixteenths, which 8 bits tell apart.
                found = round(pixel[y][x][0] / 255 * 16) / 16
                worst, total = max(worst, abs(found - mean)), total + abs(found - mean)
                partial += 0 < mean < 1
        self.assertGreater(partial, 200, "edges cross the picture")
        self.assertLess(worst, 0.002)
        self.assertLess(total / (WIDTH * HEIGHT), 0.0005)

    def test_points_that_form_no_square_are_refused(self):
        self.refused("render", "courtyard", "-o", self.folder / "x.png", "--show", "reference", "--size", "32x24", "--set",
                     "reference.pixel_samples=15", says=["valid: 9 or 16"])


if __name__ == "__main__":
    unittest.main()
