"""Files dragged from elsewhere onto the window."""
import base64
import contextlib
import json
import os
import struct
import threading
import unittest

from case import QUICK, WindowCase, png
from drop import DragSource
from viewer import difference


def boxes_obj():
    """A floor, and a box over it."""
    lines = ["o floor", "v -4 0 -4", "v 4 0 -4", "v 4 0 4", "v -4 0 4", "f 4 3 2 1", "o box"]
    lines += [f"v {x} {y} {z}" for z in (-1, 1) for y in (1, 2) for x in (-1, 1)]
    for face in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
        lines.append("f " + " ".join(str(5 + corner) for corner in face))
    return "\n".join(lines) + "\n"


def tile_data():
    return struct.pack("<12f", -1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1) + struct.pack("<6H", 0, 1, 2, 0, 2, 3)


def tile_gltf(buffer):
    """Two triangles."""
    return {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, 0, -1], "max": [1, 0, 1]},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "buffers": [buffer],
    }


def tile_glb():
    """The same as binary glTF."""
    data = tile_data()
    text = json.dumps(tile_gltf({"byteLength": len(data)})).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def lit_gltf(light_name):
    """The tile, under a point light of that name."""
    address = "data:application/octet-stream;base64," + base64.b64encode(tile_data()).decode()
    gltf = tile_gltf({"byteLength": len(tile_data()), "uri": address})
    gltf["extensionsUsed"] = ["KHR_lights_punctual"]
    gltf["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point", "name": light_name, "intensity": 50}]}}
    gltf["nodes"].append({"translation": [0, 2, 0], "name": light_name, "extensions": {"KHR_lights_punctual": {"light": 0}}})
    gltf["scenes"] = [{"nodes": [0, 1]}]
    return json.dumps(gltf)


class Drop(WindowCase):
    def setUp(self):
        super().setUp()
        self.source = DragSource(self.desktop)
        self.addCleanup(self.source.close)

    def drop(self, viewer, *paths):
        self.assertTrue(self.source.drop(viewer.window, paths, 500, 200))

    def test_files_and_the_list_of_the_recent_ones(self):
        obj, glb = self.folder / "two boxes.obj", self.folder / "tile.glb"  # a blank: the address of a file writes it as %20
        obj.write_text(boxes_obj(), encoding="utf-8")
        glb.write_bytes(tile_glb())
        viewer = self.open("chart/slab", *QUICK)
        for path in (obj, glb):
            self.drop(viewer, path)
            viewer.until(lambda status, name=path.name: name in status["command"], f"a command that names {path.name}")
            self.assertEqual(self.desktop.title(viewer.window), f"gnomon: {path}")
            status = viewer.status()
            self.assertEqual((status["message"], status["loading"]), ("", False))
            self.assertIn("--technique single/hard", status["command"], "what was set stays")
            self.assertIn("--set single.size=512", status["command"])
        drawn = self.render(viewer.status()["command"], self.folder / "drawn.png")
        self.assertGreater(len(set(zip(*[iter(drawn[2])] * 3))), 1, "the tile, not the sky alone")
        viewer.click("scene")
        listed = viewer.entries("scene")
        self.assertIn(str(glb), listed)
        viewer.press("Escape")
        # The list is kept: another run has it, and opens a file from it.
        self.close(viewer)
        viewer = self.open("chart/slab", *QUICK)
        viewer.choose("scene", str(obj))
        viewer.until(lambda status: obj.name in status["command"], "the file from the list")
        viewer.choose("scene", "chart/sphere")
        viewer.until(lambda status: "render chart/sphere" in status["command"], "a built-in scene")
        self.close(viewer)

    def test_several_files_at_once(self):
        first, second = self.good_one(), self.folder / "tile.glb"
        second.write_bytes(tile_glb())
        viewer = self.open("chart/slab", *QUICK)
        self.drop(viewer, first, second)
        viewer.until_text("notice", lambda text: text == "one scene at a time: good.obj is opened, not tile.glb")
        viewer.until(lambda status: first.name in status["command"], "the first of them")
        self.assertIn("not tile.glb", viewer.until_text("notice", lambda _: True), "still there in the new scene")
        self.close(viewer)

    def test_the_shown_file_is_read_again(self):
        path = self.folder / "house.obj"
        path.write_text(boxes_obj(), encoding="utf-8")
        viewer = self.open(path.name, *QUICK)  # the list and drops have the whole path
        viewer.hold("d")
        viewer.search("light.elevation")
        viewer.enter("light.elevation", "25")
        kept = viewer.until_command("--set light.elevation=25")["command"]
        before = self.render(kept, self.folder / "before.png")
        path.write_text(boxes_obj().split("o box")[0], encoding="utf-8")  # the floor alone
        self.drop(viewer, path)
        viewer.until_text("notice", lambda text: "house.obj is read again" in text)
        viewer.frames(3)
        self.assertEqual(viewer.status()["command"], kept)
        viewer.press("F12")
        viewer.wait(lambda: viewer.stdout().endswith("\n"), "the picture")
        self.assertGreater(difference(png.read(self.folder / "gnomon_0000.png"), before), 0.5, "the changed file")
        viewer.search("light.elevation")
        viewer.click("light.elevation:reset")
        viewer.until_command(without=["light.elevation"])
        # What does not fit any more.
        path.write_text("v nonsense\n", encoding="utf-8")
        viewer.choose("scene", str(path))
        said = viewer.until(lambda status: status["message"], "a message")["message"]
        self.assertRegex(said, r"^not read again: house.obj:1")
        self.assertIn("render house.obj", viewer.status()["command"])
        self.close(viewer)

    def test_what_is_kept_must_fit(self):
        path = self.folder / "lit.gltf"
        path.write_text(lit_gltf("lamp"), encoding="utf-8")
        viewer = self.open(path, *QUICK, "--light", "lamp", "--technique", "cube/hard", "--set", "cube.size=128")
        path.write_text(lit_gltf("torch"), encoding="utf-8")
        self.drop(viewer, path)
        said = viewer.until(lambda status: status["message"], "a message")["message"]
        for text in ("not read again", "--light lamp", "torch"):
            self.assertIn(text, said)
        self.assertIn("--light lamp", viewer.status()["command"])
        self.close(viewer)

    def test_pasted_paths(self):
        path = self.folder / "two boxes.obj"
        path.write_text(boxes_obj(), encoding="utf-8")
        viewer = self.open("chart/slab", *QUICK)
        for text in (f"'{path}' ", path.as_uri()):
            viewer.fill("scene_path", text)
            viewer.press("Return")
            viewer.until(lambda status: path.name in status["command"], "the file")
            self.assertEqual(self.desktop.title(viewer.window), f"gnomon: {path}")
            viewer.choose("scene", "chart/slab")
            viewer.until(lambda status: "render chart/slab" in status["command"], "the first scene")
        self.close(viewer)

    def test_progress(self):
        """What takes a while is told, and the former scene answers meanwhile."""
        viewer = self.open("chart/slab", *QUICK)
        viewer.fill("scene_path", "town")
        viewer.press("Return")
        status = viewer.until(lambda status: status["loading"], "a scene that is being opened")
        self.assertIn("render chart/slab", status["command"])
        eye = status["camera"]
        viewer.desktop.key("w", True)
        moved = viewer.until(lambda status: status["camera"] != eye, "a step")
        viewer.desktop.key("w", False)
        self.assertIn("render chart/slab", moved["command"])
        viewer.until(lambda status: "render town" in status["command"], "the town", 120)
        self.close(viewer)

    def test_end_while_a_file_is_read(self):
        """Nobody waits for the rest of a file whose scene is not wanted any more."""
        endless = self.folder / "endless.obj"
        os.mkfifo(endless)
        viewer = self.open("chart/slab", *QUICK)
        viewer.fill("scene_path", str(endless))
        viewer.press("Return")
        ended = threading.Event()
        pipe = os.open(endless, os.O_RDWR | os.O_NONBLOCK)  # needs nobody who reads
        self.addCleanup(os.close, pipe)

        def feed():
            while not ended.wait(0.01):
                with contextlib.suppress(BlockingIOError):
                    os.write(pipe, b"v 0 0 0\n" * 500)
        writer = threading.Thread(target=feed)
        writer.start()
        try:
            viewer.until(lambda status: status["loading"], "a scene that is being opened")
            self.close(viewer)
        finally:
            viewer.kill()
            ended.set()
            writer.join()

    def test_what_cannot_be_opened(self):
        path = self.folder / "broken file.obj"
        path.write_text("v 0 0 0\nf 1 2 3\nv nonsense\n", encoding="utf-8")
        strange = self.folder / "notes.txt"
        strange.write_text("no scene", encoding="utf-8")
        viewer = self.open("chart/slab", *QUICK)
        self.drop(viewer, path)
        said = viewer.until(lambda status: status["message"], "a message")["message"]
        self.assertIn("broken file.obj:3", said, "the file, and the line")
        self.assertEqual(said.count("broken file.obj"), 1, said)
        self.drop(viewer, strange)
        viewer.until(lambda status: "notes.txt" in status["message"], "what is wrong with the other file")
        self.assertIn("gnomon render chart/slab", viewer.status()["command"])
        viewer.hold("w")
        self.drop(viewer, self.good_one())
        viewer.until(lambda status: "good.obj" in status["command"] and not status["message"], "the good one")
        self.close(viewer)

    def test_warnings_are_told(self):
        path = self.folder / "plain.obj"
        path.write_text("mtllib gone.mtl\n" + boxes_obj(), encoding="utf-8")
        viewer = self.open("chart/slab", *QUICK)
        self.drop(viewer, path)
        said = viewer.until_text("notice", lambda _: True, 60)
        for text in ("plain.obj", "1 warning", "gone.mtl"):
            self.assertIn(text, said)
        self.assertEqual(viewer.status()["message"], "")
        self.close(viewer)

    def good_one(self):
        path = self.folder / "good.obj"
        path.write_text(boxes_obj(), encoding="utf-8")
        return path


if __name__ == "__main__":
    unittest.main(verbosity=2)
