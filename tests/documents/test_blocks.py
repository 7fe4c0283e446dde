"""Every code block of the documents, as a reader would use it: commands are run, JSON is read by the program (documents.py names the
kinds; those of the tutorial: test_tutorial.py). Sizes, frames and rays become few."""
import functools
import json
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

from commands import BUILD, PROGRAM, CommandCase, quick, run_script_root
from documents import ROOT, TUTORIAL, blocks, commands, documents, prose

sys.path.insert(0, str(ROOT / "tests" / "window"))
from display import Display  # noqa: E402

TRIANGLES = "v 0 0 0\nv 4 0 0\nv 0 0 -4\nv 1 1 -1\nv 2 1 -1\nv 1 1 -2\nf 1 2 3\nf 4 5 6\n"
NUMBERS = {"AZIMUTH": "225", "ELEVATION": "30", "X": "-4", "Y": "5", "Z": "6", "TX": "0", "TY": "1", "TZ": "0"}


class Blocks(CommandCase):
    def setUp(self):
        super().setUp()
        scene = self.folder / "path" / "to"
        scene.mkdir(parents=True)
        (scene / "scene.obj").write_text(TRIANGLES, encoding="utf-8")
        gltf = (ROOT / "tests" / "fuzz" / "corpus" / "gltf" / "triangle.gltf").read_bytes()
        (scene / "scene.gltf").write_bytes(gltf)
        gltf += b" " * (-len(gltf) % 4)
        (scene / "scene.glb").write_bytes(struct.pack("<4sIIII", b"glTF", 2, 20 + len(gltf), len(gltf), 0x4E4F534A) + gltf)

    @functools.cached_property
    def display(self):
        display = Display(self.folder)
        self.addCleanup(display.close)
        return display.name

    def of_kind(self, kind):
        found = [block for block in blocks() if block.kind == kind and block.document != TUTORIAL]
        self.assertGreater(len(found), 0, kind)
        return found

    # Commands. One method each; a command that none of them knows fails.

    def environment_of(self, arguments):
        return {**self.environment, "DISPLAY": self.display} if arguments[:1] == ["view"] else self.environment

    def gnomon(self, where, arguments):
        self.run_it(where, [PROGRAM, *quick(arguments)], env=self.environment_of(arguments))

    def run_script(self, where, arguments):
        root = run_script_root(pathlib.Path(tempfile.mkdtemp(dir=self.folder)))
        listed = self.run_it(where, [PROGRAM, "--help"])
        compared = not arguments or not re.search(rf"(?m)^  {re.escape(arguments[0])} ", listed)
        self.run_it(where, [root / "run.sh", *(quick(["compare", *arguments])[1:] if compared else quick(arguments))],
                    env=self.environment_of(arguments))

    def cmake(self, where, arguments):
        presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
        names = [preset["name"] for preset in presets["configurePresets"] if not preset.get("hidden")]
        if arguments[0] == "--preset":
            self.assertIn(arguments[1], names, where)
        else:
            self.assertEqual(arguments[0], "--build", where)
            self.assertIn(arguments[1].removeprefix("build/"), names, where)

    def new_technique(self, where, arguments):
        tree = self.folder / "techniques"
        shutil.copytree(ROOT / "src" / "shadow", tree / "src" / "shadow")
        shutil.copytree(ROOT / "scripts", tree / "scripts")
        self.run_it(where, [tree / "scripts" / "new_technique.sh", *arguments])
        self.assertEqual(len(list(tree.glob(f"src/shadow/**/{arguments[2]}/{arguments[2]}.params"))), 1, where)

    def planted(self, where, arguments):
        """Planting takes hours; what is checked is what would be planted."""
        words = shlex.split(re.sub(r"--touching \S+|--list", "", " ".join(arguments)))
        listed = self.run_it(where, [ROOT / "scripts" / "planted.sh", "--list", *arguments])
        self.assertTrue(listed.strip(), where)
        for word in words:
            self.assertTrue((ROOT / "tests" / "planted" / f"{word}.patch").is_file(), f"{where}: {word}")

    def command(self, where, line):
        words = shlex.split(line)
        while re.fullmatch(r"[A-Z_]+=.*", words[0]):
            words.pop(0)
        program, arguments = words[0], words[1:]
        known = {"gnomon": self.gnomon, "build/release/bin/gnomon": self.gnomon, "./run.sh": self.run_script, "./test.sh": self.run_tests,
                 "cmake": self.cmake, "scripts/new_technique.sh": self.new_technique, "scripts/planted.sh": self.planted}
        if program in known:
            known[program](where, arguments)
        elif program == "ctest":
            self.run_it(where, [program, *(word.replace("build/release", str(BUILD)) for word in arguments)])
        elif program.endswith("_tests"):
            listed = self.run_it(where, [BUILD / "bin" / pathlib.Path(program).name, *arguments, "--gtest_list_tests"])
            self.assertRegex(listed, r"(?m)^  \w", where)
        elif program == "/usr/bin/python3":
            self.run_it(where, words, cwd=ROOT)
        else:
            self.fail(f"{where}: no test knows how to run '{program}'")

    def test_commands(self):
        for block in self.of_kind("sh"):
            for line in commands(block):
                with self.subTest(block=str(block), command=line):
                    self.command(f"{block}: {line}", line)

    def test_options_of_lights(self):
        for block in self.of_kind("text options"):
            for line in block.text.splitlines():
                option, value = line.split()[:2]
                value = re.sub(r"[A-Z]+", lambda word: NUMBERS[word[0]], value)
                with self.subTest(block=str(block), option=value):
                    self.run_it(block, [PROGRAM, "render", "chart/slab", "-o", "x.png", "--size", "48x32", "--technique",
                                        "single/pcf,cube/pcf", option, value])

    # What the program reads.

    def written(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def test_presets_and_suites(self):
        for block in self.of_kind("json preset"):
            self.run_it(block, [PROGRAM, "bench", "--preset", self.written("preset.json", block.text), "--dry-run"])
        for block in self.of_kind("json suite"):
            self.run_it(block, [PROGRAM, "bench", self.written("suite.json", block.text), "--dry-run"])

    def test_path_files(self):
        for block in self.of_kind("json path"):
            path = self.written("path.json", block.text)
            self.run_it(block, [PROGRAM, "render", "chart/slab", "-o", "x.png", "--size", "48x32", "--frames", "2", "--path", path,
                                "--sun-path", path])

    def test_results(self):
        (whole,), (part,) = self.of_kind("json result"), self.of_kind("json part")
        result = json.loads(whole.text)
        for line in [result, {**result, **json.loads("{" + part.text + "}")}]:
            folder = self.written("results/results.jsonl", json.dumps(line) + "\n").parent
            for name in set(re.findall(r'"(images/[^"]+)"', whole.text)):
                picture = folder / name
                picture.parent.mkdir(exist_ok=True)
                shutil.copy(ROOT / "docs" / "images" / "courtyard.png", picture)
            self.run_it(whole, [PROGRAM, "report", folder, "--csv", folder / "results.csv"])
            self.assertIn(line["technique"], (folder / "report.html").read_text(encoding="utf-8"))

    def test_the_table_has_the_columns_that_are_shown(self):
        for block in self.of_kind("text table"):
            printed = self.compare("courtyard", self.folder / "out", "--techniques", "single/hard").stdout
            columns = [re.split(r"  +", text.splitlines()[0].strip()) for text in (block.text, printed)]
            self.assertEqual(columns[0], columns[1])

    def test_options_in_the_text_exist(self):
        listed = self.run_it("help", [PROGRAM, "--help"])
        texts = [listed] + [self.run_it(name, [PROGRAM, name, "--help"]) for name in re.findall(r"(?m)^  ([a-z]+)  ", listed)]
        texts += [path.read_text(encoding="utf-8") for path in [*ROOT.glob("*.sh"), *ROOT.glob("scripts/*")] if path.is_file()]
        # Of ctest and of GoogleTest, and what tests/support adds to it.
        known = set(re.findall(r"--[a-z][a-z-]*", "\n".join(texts))) | {"--gtest_filter", "--file"}
        for name in documents():
            if name != "CHANGELOG.md":
                for number, line in prose(name):
                    for code in re.findall(r"`([^`]+)`", line):
                        for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", code):
                            self.assertIn(option, known, f"{name}:{number}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
