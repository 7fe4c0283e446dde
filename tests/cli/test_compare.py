"""gnomon compare and report: what docs/results_format.md promises."""
import base64
import csv
import json
import pathlib
import re
import shlex
import shutil
import signal
import struct
import subprocess
import time
import unittest

from program import DEVICE, FAILURE, OK, PROGRAM, QUICK, THRESHOLD, Case, read_lines

FORMAT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "results_format.md"

# Keys of a line whose status is ok, by path.
PROMISED = """
gnomon.version gnomon.commit gnomon.build command scene.name scene.source scene.hash scene.triangles scene.objects
camera.name camera.eye camera.forward camera.vertical_fov_deg lights size samples
device.name device.type device.driver device.driver_version technique settings status reason
visibility.hard artefacts image.rmse image.psnr
timing.mode timing.frames timing.warm_up timing.clock timing.frame_ms timing.sum_of_passes_ms passes
gpu_ms.build gpu_ms.resolve gpu_ms.total memory_bytes
reference.hard.kind reference.hard.samples reference.hard.confidence
images.shaded images.mask images.error.hard images.reference.hard images.reference_shaded
""".split()
ERROR_KEYS = """mae rmse bias false_shadow.area false_shadow.severity false_light.area false_light.severity receivers""".split()
PASS_KEYS = "name stage median_ms p95_ms mad_ms draws dispatches triangles".split()


def at(value, path):
    for key in path.split("."):
        value = value[key]
    return value


def pictures(images):
    """Every path in the tree of a line's images."""
    if isinstance(images, str):
        return [images]
    return [path for child in images.values() for path in pictures(child)]


def key_paths(value, path=""):
    """Every path of keys in a tree; elements of lists under one name."""
    if isinstance(value, dict):
        return set().union(*(key_paths(child, f"{path}.{key}") for key, child in value.items())) | {path}
    if isinstance(value, list):
        return set().union(*(key_paths(child, path + "[]") for child in value))
    return {path}


def contents(folder):
    """Every file below a folder: its bytes by its path."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


class Compare(Case):
    def test_lines_hold_what_the_format_promises(self):
        out = self.folder / "out"
        done = self.compare("courtyard", out)
        lines = read_lines(out)
        listed = [row["name"] for row in json.loads(self.run_gnomon("list", "--json").stdout)]
        self.assertEqual(sorted(lines), sorted(listed))
        for name, line in lines.items():
            with self.subTest(technique=name):
                if line["status"] == "unavailable":
                    self.assertNotEqual(line["reason"], "")
                    self.assertNotIn("visibility", line)
                else:
                    self.check_line(out, line)
        self.assertEqual(len(done.stdout.splitlines()), 1 + len(lines))  # a heading and a row each: nothing else on stdout
        self.assertIn("report.html", done.stderr)
        page = (out / "report.html").read_text(encoding="utf-8")
        self.assertNotRegex(page, r'(src|href)="https?:')  # opens offline
        # The report and a table again, from the results alone.
        (out / "report.html").unlink()
        self.assertEqual(self.run_gnomon("report", out, "--csv", self.folder / "x.csv").stdout, "")
        self.assertEqual((out / "report.html").read_text(encoding="utf-8"), page)
        with open(self.folder / "x.csv", encoding="utf-8", newline="") as file:
            self.assertEqual([row["technique"] for row in csv.DictReader(file)], list(lines))

    def check_line(self, out, line):
        for path in PROMISED:
            at(line, path)
        self.assertEqual((line["status"], line["reason"]), ("ok", ""))
        self.assertRegex(line["scene"]["hash"], "^[0-9a-f]{16}$")
        self.assertEqual((line["size"], line["samples"]), ([96, 64], 1))
        for kind, error in line["visibility"].items():
            self.assertIn(kind, ["hard", "area", "pixel"])
            for path in ERROR_KEYS:
                self.assertIsInstance(at(error, path), (int, float), path)
            self.assertLessEqual(error["mae"], error["rmse"] + 1e-9)
            self.assertLessEqual(abs(error["bias"]), error["mae"] + 1e-9)
            self.assertGreater(error["receivers"], 0)
        for id_ in ["light", "camera", "scene", "reference", "measure"]:
            self.assertIn(id_, line["settings"])
        self.assertEqual(line["settings"]["reference"]["samples"], 8)
        for one in line["passes"]:
            self.assertEqual([key for key in PASS_KEYS if key not in one], [])
            self.assertIn(one["stage"], ["surface", "build", "resolve", "shade", "other"])
        for stage in ["build", "resolve"]:
            total = sum(one["median_ms"] for one in line["passes"] if one["stage"] == stage)
            self.assertAlmostEqual(line["gpu_ms"][stage], total, places=6)
        self.assertAlmostEqual(line["gpu_ms"]["total"], line["gpu_ms"]["build"] + line["gpu_ms"]["resolve"], places=6)
        self.assertGreater(line["memory_bytes"], 0)
        for path in pictures(line["images"]):
            self.assertTrue((out / path).is_file(), path)

    def test_same_command_same_numbers(self):
        first, second = self.folder / "a", self.folder / "b"
        for out in [first, second]:
            self.compare("courtyard", out)
        a, b = read_lines(first), read_lines(second)
        for name in a:
            for key in ["visibility", "image", "reference", "settings", "scene", "memory_bytes"]:
                self.assertEqual(a[name].get(key), b[name].get(key), f"{name}: {key}")

    def test_the_command_of_a_row_repeats_it(self):
        out = self.folder / "out"
        self.compare("courtyard", out, "--techniques", "single/pcf,ray_traced", "--set", "pcf.size=5", "--camera", "0,6,9:0,1,0",
                     "--set", "light.elevation=40")
        for name, line in read_lines(out).items():
            words = shlex.split(line["command"])
            self.assertEqual(words[:2], ["gnomon", "compare"])
            again = self.folder / "again"
            again.mkdir(exist_ok=True)
            self.run_gnomon(*words[1:], cwd=again)
            repeated = read_lines(again / "out")
            self.assertEqual(list(repeated), [name])
            for key in ["visibility", "image", "settings", "camera", "lights", "size", "command"]:
                self.assertEqual(repeated[name][key], line[key], f"{name}: {key}")

    def test_the_example_of_the_document_has_the_keys_of_a_line(self):
        example = json.loads(FORMAT.read_text(encoding="utf-8").split("```json result\n")[1].split("```")[0])
        out = self.folder / "out"
        self.compare("courtyard", out, "--techniques", example["technique"])
        shown, real = key_paths(example), key_paths(read_lines(out)[example["technique"]])
        self.assertEqual(shown - real, set())
        # All of them; only settings may be newer than the document.
        self.assertEqual({path for path in real - shown if not path.startswith(".settings.")}, set())

    def test_gate(self):
        self.compare("courtyard", self.folder / "a", "--techniques", "single/hard", "--max-error", "1")
        done = self.compare("courtyard", self.folder / "b", "--techniques", "single/hard", "--max-error", "0", expect=THRESHOLD)
        self.assertIn("single/hard", done.stderr)
        self.assertEqual(list(read_lines(self.folder / "b")), ["single/hard"])  # the results are there all the same

    def test_gate_wants_every_named_technique_measured(self):
        scene = self.folder / "lamp.gltf"
        lamp = two_suns()
        lamp["extensions"]["KHR_lights_punctual"]["lights"] = [{"type": "point", "name": "lamp"}]
        lamp["scenes"] = [{"nodes": [0, 1]}]
        lamp["nodes"] = [{"mesh": 0}, {"translation": [0, 3, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}}]
        scene.write_text(json.dumps(lamp), encoding="utf-8")
        gate = ["--light", "lamp", "--max-error", "1"]
        lines = read_lines(self.compare_in("all", scene, "--light", "lamp"))
        unable = [name for name, line in lines.items() if line["status"] == "unavailable"]
        if not unable:
            self.skipTest("every technique knows point lights")
        done = self.compare(scene, self.folder / "named", "--techniques", unable[0], *gate, expect=DEVICE)
        self.assertIn(unable[0], done.stderr)
        self.assertIn(lines[unable[0]]["reason"], done.stderr)
        done = self.compare(scene, self.folder / "named with all", "--techniques", "all," + unable[0], *gate, expect=DEVICE)
        self.assertIn(unable[0], done.stderr)
        able = len(unable) < len(lines)  # of all, those that cannot run here do not count; but one must
        self.compare(scene, self.folder / "all of them", *gate, expect=OK if able else DEVICE)

    def compare_in(self, name, scene, *arguments):
        self.compare(scene, self.folder / name, *arguments)
        return self.folder / name

    def test_repeated_names_are_measured_once(self):
        out = self.folder / "out"
        done = self.compare("chart/slab", out, "--techniques", "single/pcf,single/hard,single/pcf")
        lines = [json.loads(text) for text in (out / "results.jsonl").read_text(encoding="utf-8").splitlines()]
        self.assertEqual([line["technique"] for line in lines], ["single/pcf", "single/hard"])
        self.assertRegex(done.stderr, "warning: .*single/pcf more than once")

    def start(self, out, *arguments):
        """A run that takes seconds for each technique."""
        command = [PROGRAM, "compare", "courtyard", "-o", str(out), *QUICK, "--techniques", "single/hard,single/pcf", *arguments]
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def wait_for(self, condition, process):
        stop = time.monotonic() + 120
        while not condition() and process.poll() is None and time.monotonic() < stop:
            time.sleep(0.005)
        self.assertIsNone(process.poll(), "the run ended before it was to be interrupted")

    def test_an_interrupted_run_leaves_the_old_result_and_can_be_resumed(self):
        out, slow = self.folder / "out", ["--set", "measure.frames=100000", "--set", "measure.max_seconds=3"]
        self.compare("courtyard", out, "--techniques", "ray_traced")
        before = contents(out)
        lines = out / "gnomon.unfinished" / "results.jsonl"
        for number in [signal.SIGINT, signal.SIGTERM]:
            shutil.rmtree(lines.parent, ignore_errors=True)
            process = self.start(out, *slow)
            self.wait_for(lines.exists, process)
            process.send_signal(number)
            stdout, stderr = process.communicate(timeout=120)
            self.assertEqual(process.returncode, 130, stderr)
            self.assertEqual(stdout, "")
            self.assertIn("interrupted: 1 of 2 results are kept", stderr.splitlines()[-1])
            self.assertIn("--resume", stderr.splitlines()[-1])
            self.assertEqual({name: data for name, data in contents(out).items() if "unfinished" not in name}, before)
        kept = read_lines(lines.parent)["single/hard"]
        # The report is of the old result, and says so; the unfinished one can be looked at by itself.
        self.assertIn("gnomon.unfinished", self.run_gnomon("report", out).stderr)
        self.run_gnomon("report", lines.parent, "-o", self.folder / "page.html")
        # Only the rest is measured.
        process = self.start(out, *slow, "--resume")
        _, stderr = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 0, stderr)
        after = read_lines(out)
        self.assertEqual(list(after), ["single/hard", "single/pcf"])
        self.assertEqual(after["single/hard"], kept)
        self.assertFalse(lines.parent.exists())
        self.check_pictures(out, after)

    def test_resume_keeps_nothing_that_is_no_longer_true(self):
        out = self.folder / "out"
        process = self.start(out, "--set", "measure.frames=100000", "--set", "measure.max_seconds=3")
        self.wait_for((out / "gnomon.unfinished" / "results.jsonl").exists, process)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=120)
        done = self.compare("courtyard", out, "--resume", "--techniques", "single/hard", "--set", "light.elevation=50")
        self.assertNotIn("kept", done.stderr)
        self.assertEqual(read_lines(out)["single/hard"]["settings"]["light"]["elevation"], 50)
        self.check_pictures(out, read_lines(out))

    def test_a_killed_run_leaves_whole_lines(self):
        out = self.folder / "out"
        unfinished = out / "gnomon.unfinished"
        for delay in [0.0, 0.3]:
            with self.subTest(delay=delay):
                process = self.start(out, "--set", "measure.frames=100000", "--set", "measure.max_seconds=2")
                # Long enough to have begun; with a delay also past the first line.
                self.wait_for((unfinished / "results.jsonl").exists if delay else unfinished.exists, process)
                time.sleep(delay)
                process.send_signal(signal.SIGKILL)
                process.communicate()
                self.assertFalse((out / "results.jsonl").exists())
                self.assertFalse((out / "report.html").exists())
                done = self.run_gnomon("report", out, expect=FAILURE)
                self.assertIn("unfinished run", done.stderr)
                if delay:
                    self.run_gnomon("report", unfinished, "-o", self.folder / "page.html")
        done = self.compare("courtyard", out, "--techniques", "single/pcf")
        self.assertIn("unfinished run is dropped", done.stderr)
        self.assertEqual(sorted(path.name for path in out.iterdir()), ["images", "report.html", "results.jsonl"])

    def test_a_replacement_that_was_cut_off_is_completed(self):
        out, other = self.folder / "out", self.folder / "other"
        self.compare("courtyard", out, "--techniques", "single/hard")
        self.compare("chart/slab", other, "--techniques", "single/pcf")
        other.rename(out / "gnomon.replacing")
        self.run_gnomon("report", out)
        self.assertEqual(list(read_lines(out)), ["single/pcf"])
        self.assertFalse((out / "gnomon.replacing").exists())
        self.check_pictures(out, read_lines(out))

    def test_a_finished_run_replaces_the_former_result_and_nothing_else(self):
        out = self.folder / "out"
        self.compare("courtyard", out, "--techniques", "single/hard,single/pcf")
        (out / "notes.txt").write_text("mine", encoding="utf-8")
        (out / "images" / "holiday.png").write_text("mine", encoding="utf-8")
        self.compare("chart/slab", out, "--techniques", "single/pcf")
        lines = read_lines(out)
        self.assertEqual(list(lines), ["single/pcf"])
        self.check_pictures(out, lines, others=["images/holiday.png"])
        self.assertEqual((out / "notes.txt").read_text(encoding="utf-8"), "mine")
        self.assertIn("slab", (out / "report.html").read_text(encoding="utf-8"))

    def check_pictures(self, out, lines, others=()):
        """The folder holds the pictures that its lines name, and no other."""
        named = {path for line in lines.values() for path in pictures(line["images"])}
        there = {path.relative_to(out).as_posix() for path in (out / "images").iterdir()}
        self.assertEqual(there, named | set(others))

    def test_two_runs_into_one_folder_do_not_mix(self):
        out = self.folder / "out"
        process = self.start(out, "--set", "measure.frames=100000", "--set", "measure.max_seconds=2")
        self.wait_for((out / "gnomon.unfinished").exists, process)
        done = self.compare("courtyard", out, "--techniques", "single/pcf", expect=FAILURE)
        self.assertIn("another run", done.stderr)
        _, stderr = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 0, stderr)
        self.assertEqual(list(read_lines(out)), ["single/hard", "single/pcf"])

    def test_several_lights_are_measured_apart(self):
        scene = self.folder / "two lights.gltf"
        scene.write_text(json.dumps(two_suns()), encoding="utf-8")
        out = self.folder / "out"
        self.compare(scene, out, "--light", "all", "--techniques", "single/hard")
        lines = [json.loads(text) for text in (out / "results.jsonl").read_text(encoding="utf-8").splitlines()]
        self.assertEqual([line["lights"][0]["name"] for line in lines], ["morning", "evening"])
        self.assertEqual([len(line["lights"]) for line in lines], [1, 1])
        self.assertEqual(len(set(line["images"]["mask"] for line in lines)), 2)
        for line in lines:
            self.assertTrue(re.search(r"--light \S+", line["command"]), line["command"])


def two_suns():
    """A floor with a smaller square above it, two directional lights."""
    corners = [(-4, 0, -4), (4, 0, -4), (4, 0, 4), (-4, 0, 4), (-1, 1, -1), (1, 1, -1), (1, 1, 1), (-1, 1, 1)]
    data = b"".join(struct.pack("<3f", *corner) for corner in corners)
    data += struct.pack("<12H", 0, 2, 1, 0, 3, 2, 4, 6, 5, 4, 7, 6)
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "name": "morning"},
                                                          {"type": "directional", "name": "evening"}]}},
        "nodes": [{"mesh": 0},
                  {"rotation": [-0.6, 0.0, 0.0, 0.8], "extensions": {"KHR_lights_punctual": {"light": 0}}},
                  {"rotation": [-0.8, 0.0, 0.0, 0.6], "extensions": {"KHR_lights_punctual": {"light": 1}}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"uri": uri, "byteLength": len(data)}],
        "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 24}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [-4, 0, -4], "max": [4, 1, 4]},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
    }


if __name__ == "__main__":
    unittest.main(verbosity=2)
