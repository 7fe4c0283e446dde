"""The documents and their code blocks. A block is a fence whose info string says what holds it: LANGUAGE [KIND [NAME]].

    sh              commands, run for real with small sizes (test_blocks.py; of the tutorial: test_tutorial.py)
    json KIND       a preset, suite, path file or result, read by the program; part: keys that a result may have besides
    LANGUAGE file   a file of the tutorial's technique: compiled, linked, rendered
    LANGUAGE quote  lines that stand in the file NAME of the tree, which the build compiles
    text tree       paths that exist, each with what it holds; of src/ all folders
    text table      the head of the table that compare prints
    text options    options in which words in capitals stand for numbers
    text figure     nothing but an illustration; FIGURES counts them
"""
import dataclasses
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
TUTORIAL = "docs/adding_a_technique.md"
KINDS = {"sh", "json preset", "json suite", "json path", "json result", "json part", "c file", "glsl file", "cpp file", "glsl quote",
         "cpp quote", "diff quote", "text tree", "text table", "text options", "text figure"}
FIGURES = {"docs/architecture.md": 1}


@dataclasses.dataclass
class Block:
    document: str
    line: int
    kind: str
    name: str
    text: str

    def __str__(self):
        return f"{self.document}:{self.line} ({self.kind})"


def tracked(*patterns):
    """Files of the tree that git knows or would take in."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", *patterns]
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    return sorted({name for name in listed if (ROOT / name).is_file()})


def documents():
    return tracked("*.md")


def lines_of(document):
    return (ROOT / document).read_text(encoding="utf-8").splitlines()


def blocks(document=None):
    found = []
    for name in [document] if document else documents():
        opened = None
        for number, line in enumerate(lines_of(name), 1):
            if not line.startswith("```"):
                if opened:
                    opened.text += line + "\n"
            elif opened:
                found.append(opened)
                opened = None
            else:
                words = line[3:].split()
                opened = Block(name, number, " ".join(words[:2]), " ".join(words[2:]), "")
        if opened:
            raise AssertionError(f"{opened}: the fence is not closed")
    return found


def prose(document):
    """(number, line) outside of the fences."""
    fenced = False
    for number, line in enumerate(lines_of(document), 1):
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced:
            yield number, line


def commands(block):
    """The command lines of a block, comments taken off, each part of a && by itself."""
    for line in block.text.splitlines():
        for part in re.sub(r"\s+#.*", "", line).split("&&"):
            if part.strip():
                yield part.strip()
