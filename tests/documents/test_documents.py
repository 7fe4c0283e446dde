"""What documents and comments name exists: files, links, quoted code, rooms; and every code block says how it is tested."""
import collections
import fnmatch
import pathlib
import re
import unittest

from documents import FIGURES, KINDS, ROOT, blocks, documents, lines_of, prose, tracked

FILES = tracked()
FOLDERS = {str(parent) for name in FILES for parent in pathlib.PurePosixPath(name).parents} - {"."}
LAYERS = {folder.split("/")[1] for folder in FOLDERS if folder.startswith("src/")}
TOP = {folder for folder in FOLDERS if "/" not in folder}
# "src/gpu/use.h", or below src/ "gpu/use.h"; not a part of a longer path, nor a place that a reader is to fill in.
PATH = re.compile(rf"(?<![\w/.<>$@{{}}:-])((?:{'|'.join(map(re.escape, sorted(TOP | LAYERS)))})/[\w./<>*{{}},-]*)")
# Names that stand for a file of the user's.
EXAMPLES = {"presets/mine.json", "src/shadow/map/filter/pcf_copy", "src/shadow/map/filter/my_filter"}
BINARY = {".png", ".glb"}
GENERATED = {"docs/results.md"}


def exists(path):
    """A file or folder, of the root or below src/; or files of one name that differ in what follows the dot."""
    for name in (path, f"src/{path}"):
        if name in FOLDERS or name in FILES or fnmatch.filter(FILES, f"{name}.*") or ("*" in name and fnmatch.filter(FILES, name)):
            return True
    return False


def anchors(document):
    """What a link may point at within a document, as the pages of a forge make them."""
    for _, line in prose(document):
        if line.startswith("#"):
            yield re.sub(r"[^\w\- ]", "", line.lstrip("#").strip().lower()).replace(" ", "-")
        yield from re.findall(r'<a name="([^"]+)">', line)


class Documents(unittest.TestCase):
    def test_files_that_are_named_exist(self):
        lost = []
        for name in FILES:
            if pathlib.PurePosixPath(name).suffix in BINARY or name in GENERATED or name.startswith("tests/fuzz/corpus"):
                continue
            for number, line in enumerate(lines_of(name), 1):
                for path in PATH.findall(line):
                    path = path.rstrip(".,:;/")
                    if re.search(r"[<>{}]|\.{3}", path) or path in EXAMPLES or exists(path):
                        continue
                    lost.append(f"{name}:{number}: there is no {path}")
        self.assertEqual(lost, [])

    def test_links_lead_somewhere(self):
        for name in documents():
            for number, line in prose(name):
                for target in re.findall(r"\]\(([^)\s]+)\)", line):
                    if re.match(r"[a-z]+:", target):
                        continue
                    path, _, anchor = target.partition("#")
                    file = (ROOT / name).parent / path if path else ROOT / name
                    self.assertTrue(file.exists(), f"{name}:{number}: there is no {target}")
                    if anchor:
                        linked = file.resolve().relative_to(ROOT)
                        self.assertIn(anchor, set(anchors(linked)), f"{name}:{number}: no heading makes #{anchor}")

    def test_every_block_says_how_it_is_tested(self):
        figures = collections.Counter()
        for block in blocks():
            self.assertIn(block.kind, KINDS, f"{block.document}:{block.line}: '{block.kind}' (tests/documents/documents.py says which are tested)")
            figures[block.document] += block.kind == "text figure"
        self.assertEqual({name: count for name, count in figures.items() if count}, FIGURES)
        for name in documents():
            before = ""
            for number, line in prose(name):
                self.assertFalse(before == "" and re.match(r"    \S", line), f"{name}:{number}: an indented block; use a fence that says what it is")
                before = line

    def test_quotes_stand_in_the_file(self):
        for block in blocks():
            if block.kind.endswith(" quote"):
                quoted, text = ([line.strip() for line in lines] for lines in (block.text.splitlines(), lines_of(block.name)))
                places = range(len(text) - len(quoted) + 1)
                self.assertTrue(any(text[i:i + len(quoted)] == quoted for i in places), f"{block}: not a part of {block.name}")

    def test_trees_are_as_they_are_drawn(self):
        drawn = {}
        for block in blocks():
            if block.kind == "text tree":
                for line in block.text.splitlines():
                    path, _, purpose = line.partition(" ")
                    self.assertTrue(purpose.strip(), f"{block}: {path} owns nothing")
                    drawn.setdefault(block.document, []).append(path.rstrip("/"))
        for document, paths in drawn.items():
            for path in paths:
                self.assertTrue(fnmatch.filter(FOLDERS, re.sub("<.*?>", "*", path)), f"{document}: there is no {path}")
        rooms = [re.compile(re.sub("<.*?>", "[^/]+", path)) for path in drawn["docs/architecture.md"]]
        for folder in sorted(FOLDERS):
            if folder.startswith("src/"):
                self.assertTrue(any(room.fullmatch(folder) for room in rooms), f"docs/architecture.md does not draw {folder}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
