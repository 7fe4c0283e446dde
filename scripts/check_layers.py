#!/usr/bin/env python3
"""Reads the #include lines of src/ and fails where a layer includes one below it, or where a layer that must run without a
GPU reaches one that does not (docs/architecture.md). Usage: check_layers.py [SRC]"""
import pathlib
import re
import sys

LAYERS = ["base", "gpu", "scene", "frame", "shadow", "reference", "measure", "lab", "report", "app"]
NO_GPU = ["base", "scene", "measure", "report", "reference/cpu", "lab/plan"]
SUFFIXES = {".h", ".cpp", ".inl", ".glsl", ".comp", ".vert", ".frag", ".geom", ".mesh", ".task", ".rgen", ".rmiss", ".rchit", ".rahit"}
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')


def includes(path):
    """(line number, quoted by "" rather than <>, name) of each include of a file."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match[1] == '"', match[2]


def resolve(src, path, name):
    """The included file relative to src, or None where it is not one of ours (generated files count by their folder)."""
    beside = path.parent / name
    if beside.is_file() and beside.resolve().is_relative_to(src):
        return beside.resolve().relative_to(src).as_posix()
    return name if name.split("/")[0] in LAYERS else None


def read_graph(src):
    """file -> [(line, included file or <system header>)]"""
    graph = {}
    for path in sorted(src.rglob("*")):
        if path.suffix not in SUFFIXES:
            continue
        edges = graph[path.relative_to(src).as_posix()] = []
        for number, quoted, name in includes(path):
            target = resolve(src, path, name) if quoted else None
            edges.append((number, target if target else f"<{name}>"))
    return graph


def gpu_route(graph, start):
    """The shortest chain of includes from a file to the GPU, or None."""
    routes, seen = [[start]], {start}
    for route in routes:
        for _, target in graph.get(route[-1], []):
            if target.startswith("gpu/") or target.startswith("<vulkan/"):
                return route + [target]
            if target not in seen:
                seen.add(target)
                routes.append(route + [target])
    return None


def violations(graph):
    for path, edges in graph.items():
        layer = path.split("/")[0]
        if layer not in LAYERS:
            yield f"src/{path}: '{layer}' is no layer; valid: {', '.join(LAYERS)}"
            continue
        for number, target in edges:
            below = target.split("/")[0]
            if below in LAYERS and LAYERS.index(below) > LAYERS.index(layer):
                yield f"src/{path}:{number}: {layer} includes {target}, but {below} is a layer below it"
        if any(path.startswith(f"{folder}/") for folder in NO_GPU):
            route = gpu_route(graph, path)
            if route:
                yield f"src/{path}: must run without a GPU, but includes {' -> '.join(route[1:])}"


def main():
    default = pathlib.Path(__file__).resolve().parent.parent / "src"
    src = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else default).resolve()
    graph = read_graph(src)
    if not graph:
        sys.exit(f"{src}: no source files")
    found = list(violations(graph))
    print("\n".join(found), file=sys.stderr)
    if found:
        sys.exit(f"{len(found)} include(s) against the order of the layers")
    print(f"{len(graph)} files keep the order of the layers")


if __name__ == "__main__":
    main()
