"""What render may say of a scene: who casts, which axis points up, which scene, animation and moment of a file."""
import base64
import json
import struct
import unittest

from program import QUICK, USAGE, Case


class SceneFile:
    """glTF: a floor, "ground", and a triangle, "sail", above it; two animations and a second scene move or leave out the sail."""

    def __init__(self):
        self.data = b""
        self.root = {
            "asset": {"version": "2.0"}, "bufferViews": [], "accessors": [], "scene": 0,
            "scenes": [{"name": "both", "nodes": [0, 1]}, {"name": "bare", "nodes": [0]}],
            "nodes": [{"name": "ground", "mesh": 0}, {"name": "sail", "mesh": 1}],
            "materials": [{"name": "soil"}, {"name": "cloth", "doubleSided": True}],
        }
        floor = self.accessor("VEC3", [(-4, 0, -4), (-4, 0, 4), (4, 0, 4), (-4, 0, -4), (4, 0, 4), (4, 0, -4)])
        sail = self.accessor("VEC3", [(-1, 1, -1), (-1, 1, 1), (1, 1, 1)])
        self.root["meshes"] = [{"primitives": [{"attributes": {"POSITION": p}, "material": i}]} for i, p in enumerate([floor, sail])]
        times = self.accessor("SCALAR", [(0,), (2,)])
        self.root["animations"] = [self.animation("drift", times, (2, 0, 0)), self.animation("rise", times, (0, 2, 0))]

    def accessor(self, kind, rows):
        at = len(self.data)
        self.data += b"".join(struct.pack(f"<{len(row)}f", *row) for row in rows)
        self.root["bufferViews"].append({"buffer": 0, "byteOffset": at, "byteLength": len(self.data) - at})
        self.root["accessors"].append({"bufferView": len(self.root["bufferViews"]) - 1, "componentType": 5126, "count": len(rows),
                                       "type": kind})
        return len(self.root["accessors"]) - 1

    def animation(self, name, times, to):
        moved = self.accessor("VEC3", [(0, 0, 0), to])
        return {"name": name, "samplers": [{"input": times, "output": moved}],
                "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}]}

    def text(self):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        return json.dumps({**self.root, "buffers": [{"byteLength": len(self.data), "uri": uri}]})


class SceneOptions(Case):
    def setUp(self):
        super().setUp()
        self.scene = self.folder / "scene.gltf"
        self.scene.write_text(SceneFile().text(), encoding="utf-8")

    def mask(self, *arguments, scene=None, technique="single/hard", show="mask"):
        """The bytes of the picture, and what was said."""
        path = self.folder / "x.png"
        done = self.run_gnomon("render", scene or self.scene, "-o", path, *QUICK, "--camera", "0.5,6,3:0,0,0", "--light", "sun:20,60",
                               "--show", show, "--technique", technique, *arguments)
        return path.read_bytes(), done.stderr

    def test_cast(self):
        whole, _ = self.mask()
        self.assertNotEqual(self.mask("--cast", "sail=off")[0], whole)
        self.assertEqual(self.mask("--cast", "sail=off")[0], self.mask("--cast", "cloth=off")[0])
        self.assertEqual(self.mask("--cast", "*=off", "--cast", "*=on")[0], whole)
        self.assertEqual(self.mask("--cast", "cl*=off", "--cast", "cloth=on")[0], whole)
        self.refused("render", self.scene, "-o", self.folder / "x.png", *QUICK, "--cast", "mast=off", expect=USAGE, says=["mast", "sail"])
        self.refused("render", self.scene, "-o", self.folder / "x.png", *QUICK, "--cast", "sail", expect=USAGE, says=["sail", "=off"])

    def test_without_casters_all_is_lit(self):
        for technique in ["single/hard", "cascaded/pcf", "ray_traced"]:
            with self.subTest(technique=technique):
                lit, said = self.mask("--cast", "*=off", technique=technique)
                self.assertEqual(said.count("nothing casts a shadow"), 1, said)
                self.assertIn("--cast", said)
                self.assertEqual(lit, self.mask("--cast", "*=off", show="reference")[0])
        for kind in ["embree", "pipeline"]:
            self.mask("--cast", "*=off", "--set", f"reference.kind={kind}", show="error")

    def test_up(self):
        flat = self.folder / "flat.obj"  # z up: a floor, and a triangle above it
        flat.write_text("v -4 -4 0\nv 4 -4 0\nv 4 4 0\nv -4 4 0\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nf 1 2 3 4\nf 5 6 7\n", encoding="utf-8")
        turned = self.folder / "turned.obj"
        turned.write_text("v -4 0 4\nv 4 0 4\nv 4 0 -4\nv -4 0 -4\nv -1 1 1\nv 1 1 1\nv 1 1 -1\nf 1 2 3 4\nf 5 6 7\n", encoding="utf-8")
        self.assertEqual(self.mask("--up", "z", scene=flat)[0], self.mask(scene=turned)[0])
        self.assertNotEqual(self.mask("--up", "-z", scene=flat)[0], self.mask(scene=turned)[0])
        self.refused("render", flat, "-o", self.folder / "x.png", *QUICK, "--up", "w", expect=USAGE, says=["'w'", "y, z, x"])

    def test_animation_and_time(self):
        rest, _ = self.mask()
        drift, _ = self.mask("--time", "2")
        rise, _ = self.mask("--animation", "rise", "--time", "2")
        self.assertEqual(len({rest, drift, rise, self.mask("--time", "1")[0]}), 4)
        self.assertEqual(self.mask("--animation", "drift", "--time", "2")[0], drift)
        self.assertEqual(self.mask("--animation", "1", "--time", "2")[0], rise)
        self.assertEqual(self.mask("--animation", "rise")[0], rest)
        self.refused("render", self.scene, "-o", self.folder / "x.png", *QUICK, "--animation", "fly", expect=USAGE, says=["drift", "rise"])
        self.refused("render", self.scene, "-o", self.folder / "x.png", *QUICK, "--time", "noon", expect=USAGE, says=["noon"])

    def test_gltf_scene(self):
        both, said = self.mask()
        self.assertIn("--gltf-scene", said)
        bare, _ = self.mask("--gltf-scene", "bare")
        self.assertNotEqual(bare, both)
        self.assertEqual(self.mask("--gltf-scene", "1")[0], bare)
        self.assertEqual(self.mask("--gltf-scene", "both")[0], both)
        self.refused("render", self.scene, "-o", self.folder / "x.png", *QUICK, "--gltf-scene", "sea", expect=USAGE, says=["both", "bare"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
