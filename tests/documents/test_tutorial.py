"""The tutorial, followed to the letter: its files become a technique in a copy of the tree, and its commands are run.

The copy is configured as the program's build was, but only what is new in it is compiled: the technique's C++ and kernels, and the tables
that the build writes. They are linked before the libraries of the program's build, so that their tables are found first; so are the
conformance tests, of which those of the technique are run. A build of all that: tests/conformance/new_technique_test.sh (slow).
usage: test_tutorial.py, or test_tutorial.py --write TREE: only puts the technique into TREE"""
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import unittest

from commands import BUILD, CommandCase, quick
from documents import ROOT, TUTORIAL, blocks, commands, tracked

NAME = "my_filter"
# What of the build's configuration decides whether objects can be linked to its libraries.
CONFIGURATION = re.compile(r"(CMAKE_BUILD_TYPE|CMAKE_CXX_COMPILER|CMAKE_CXX_FLAGS(?:_[A-Z]+)?|GNOMON_(?:SANITIZE|VIEWER|PORTABLE)):\w+=(.*)")


def write_file(tree, block):
    (tree / "src" / "shadow" / "map" / "filter" / NAME / block.name).write_text(block.text, encoding="utf-8")


class Tutorial(CommandCase):
    def setUp(self):
        super().setUp()
        self.tree, self.build = self.folder / "tree", self.folder / "build"
        for name in tracked("CMakeLists.txt", "cmake", "presets", "scripts", "src"):
            (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, self.tree / name)

    def ninja(self, build, *arguments):
        return self.run_it("ninja", ["ninja", "-C", build, *arguments])

    def shell(self, command, folder):
        self.run_it("build", ["sh", "-c", command], cwd=folder)

    def make_alone(self, target):
        """A target of the copy without those that it depends on."""
        (self.build / target).parent.mkdir(parents=True, exist_ok=True)
        self.shell(self.ninja(self.build, "-t", "commands", target).splitlines()[-1], self.build)

    def make(self):
        cache = (BUILD / "CMakeCache.txt").read_text(encoding="utf-8")
        options = [f"-D{name}={value}" for name, value in CONFIGURATION.findall(cache)]
        self.run_it("configure", ["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja", "-DGNOMON_TESTS=OFF", *options])
        targets = set(re.findall(r"(?m)^([^/:][^:\n]*): ", self.ninja(self.build, "-t", "targets", "all")))
        kernels = sorted(name for name in targets if name.endswith(".spv") and NAME in name)
        self.assertIn(f"shaders/resolve/single/{NAME}.comp.spv", kernels)
        objects = sorted(name for name in targets if re.search(rf"/({NAME}|registry|shader_table)\.cpp\.o$", name))
        self.assertEqual(len(objects), 3, objects)
        for target in [*kernels, *objects]:
            self.make_alone(target)
        # The words of all other shaders are those of the program.
        for path in (BUILD / "shaders").rglob("*.spv"):
            copy = self.build / path.relative_to(BUILD)
            if not copy.exists():
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(path, copy)
        words = next(name for name in targets if name.endswith("/spirv.S.o"))
        self.make_alone(words)
        self.first = " ".join(shlex.quote(str(self.build / name)) for name in [*objects, words])

    def linked(self, name):
        """A program of the build, with the new technique."""
        program = self.folder / name
        if not program.exists():
            output = f" -o bin/{name} "
            link = next(line for line in self.ninja(BUILD, "-t", "commands", f"bin/{name}").splitlines() if output in line)
            self.shell(link.replace(output, f" -o {shlex.quote(str(program))} {self.first} "), BUILD)
        return program

    def command(self, where, words):
        if words[0] == "scripts/new_technique.sh":
            self.run_it(where, [self.tree / words[0], *words[1:]])
        elif words[:2] == ["cmake", "--build"]:
            self.make()
        elif words[0] == "build/release/bin/gnomon":
            self.run_it(where, [self.linked("gnomon"), *quick(words[1:])])
        elif words == ["./test.sh", "--label", "conformance"]:
            passed = self.run_it(where, [self.linked("gnomon_conformance_tests"), f"--gtest_filter=*{NAME}*"])
            self.assertRegex(passed, rf"OK.*EveryTechnique.*single_{NAME}")
            self.assertRegex(passed, rf"OK.*EveryParameter.*{NAME}_softness")
        else:
            self.fail(f"{where}: no test knows how to run '{words[0]}'")

    def mask(self, technique, *arguments):
        """A picture's bytes."""
        picture = self.folder / "mask.png"
        self.run_it(technique, [self.linked("gnomon"), "render", "chart/fence", "-o", picture, "--size", "96x72", "--show", "mask", "--technique",
                                technique, "--set", "single.size=64", *arguments])
        return picture.read_bytes()

    def test_the_tutorial_works(self):
        for block in blocks(TUTORIAL):
            if block.kind == "sh":
                for line in commands(block):
                    self.command(f"{block}: {line}", shlex.split(line))
            elif block.kind.endswith(" file"):
                write_file(self.tree, block)
            else:
                self.assertTrue(block.kind.endswith(" quote"), f"{block}: nothing tests it")  # test_documents.py looks it up
        hard = self.mask("single/hard")
        self.assertTrue(self.mask(f"single/{NAME}", "--set", f"{NAME}.softness=0") == hard, "a step without softness is a comparison")
        self.assertTrue(self.mask(f"single/{NAME}", "--set", f"{NAME}.softness=16") != hard, "softness changes nothing")


def write(tree):
    for block in blocks(TUTORIAL):
        for line in commands(block) if block.kind == "sh" else []:
            if NAME in line and line.startswith("scripts/"):
                subprocess.run([f"{tree}/{line.split()[0]}", *line.split()[1:]], check=True)
        if block.kind.endswith(" file"):
            write_file(tree, block)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--write"]:
        write(pathlib.Path(sys.argv[2]))
    else:
        unittest.main(verbosity=2)
