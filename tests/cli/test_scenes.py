"""Scenes from files, whole and damaged: a picture or a message, never a signal."""
import base64
import csv
import json
import struct
import subprocess
import unittest

from program import FAILURE, OK, PROGRAM, QUICK, SHARED_SCENES, Case

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def gltf_triangle(material):
    """A triangle whose texture's file is not there."""
    data = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    return {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
        "materials": [material], "textures": [{"source": 0}], "images": [{"uri": "lost.png"}],
        "buffers": [{"uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode(), "byteLength": 36}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
    }


class Scenes(Case):
    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def render(self, path, *arguments, **keywords):
        return self.run_gnomon("render", path, "-o", self.folder / "x.png", *QUICK, *arguments, **keywords)

    def test_obj_in_a_folder_with_a_blank(self):
        self.render(self.write("a triangle.OBJ", TRIANGLE))
        self.assertTrue((self.folder / "x.png").is_file())

    def test_missing_file_and_folder(self):
        for name in ["absent.obj", "absent.gltf", "absent.glb"]:
            self.refused("render", self.folder / name, "-o", self.folder / "x.png", *QUICK, expect=FAILURE, says=[name])
        (self.folder / "folder.obj").mkdir()
        self.refused("render", self.folder / "folder.obj", "-o", self.folder / "x.png", *QUICK, expect=FAILURE, says=["folder.obj"])

    def test_lost_cutouts_are_said(self):
        self.write("leaf.mtl", "newmtl leaf\nmap_Kd lost.png\nmap_d lost too.png\n")
        done = self.render(self.write("leaf.obj", "mtllib leaf.mtl\nusemtl leaf\n" + TRIANGLE))
        self.assertRegex(done.stderr, "missing textures: .*lost.png; .*cut-outs in them are lost.*solid sheet")
        self.assertRegex(done.stderr, "alpha-tested materials without their texture: leaf; .*cast as solid sheets")
        material = {"name": "leaf", "alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
        done = self.render(self.write("leaf.gltf", json.dumps(gltf_triangle(material))))
        self.assertRegex(done.stderr, "alpha-tested materials without their texture: leaf; .*cast as solid sheets")
        material["alphaMode"] = "OPAQUE"
        self.assertNotIn("solid", self.render(self.write("sheet.gltf", json.dumps(gltf_triangle(material)))).stderr)

    def test_damaged_files_are_refused_with_their_path(self):
        cases = {
            "index.obj": TRIANGLE + "f 1 2 9\n",
            "zero.obj": TRIANGLE + "f 0 1 2\n",
            "empty.gltf": "",
            "text.gltf": "hello",
            "half.gltf": '{"asset": {"version": "2.0"}, "scenes": [',
            "version.gltf": '{"asset": {"version": "1.0"}}',
            "deep.gltf": "[" * 100000,
            "magic.glb": b"gltF" + bytes(20),
            "short.glb": b"glTF\x02\x00\x00\x00\xff\xff\xff\x7f",
            "buffer.gltf": '{"asset": {"version": "2.0"}, "buffers": [{"byteLength": 99999999999, "uri": "absent.bin"}]}',
        }
        for name, content in cases.items():
            with self.subTest(file=name):
                path = self.write(name, content)
                done = self.render(path, expect=FAILURE)
                self.assertIn(name, done.stderr)
                self.assertEqual(done.stdout, "")

    @unittest.skipUnless((SHARED_SCENES / "malformed" / "INDEX.tsv").is_file(), "no collection of odd files beside the repository")
    def test_collection_of_odd_files(self):
        folder = SHARED_SCENES / "malformed"
        allowed = {"reject": [FAILURE], "accept": [OK, FAILURE], "either": [OK, FAILURE]}
        with open(folder / "INDEX.tsv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE))
        self.assertGreater(len(rows), 10)
        for row in rows:
            with self.subTest(file=row["file"]):
                command = [PROGRAM, "render", str(folder / row["file"]), "-o", str(self.folder / "x.png"), *QUICK]
                done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
                self.assertIn(done.returncode, allowed[row["expected"]], done.stderr)
                if done.returncode == FAILURE:
                    self.assertIn(row["file"].rsplit("/", 1)[-1], done.stderr)
                    if row["expected"] == "accept":  # loads, but there is nothing to draw
                        self.assertRegex(done.stderr, "no triangles|nothing|empty")


if __name__ == "__main__":
    unittest.main(verbosity=2)
