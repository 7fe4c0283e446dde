#!/usr/bin/env python3
"""Writes docs/results.md: error, cost and memory of every technique, from the results of `gnomon compare`.

usage: scripts/make_results.py FOLDER... > docs/results.md

Each FOLDER holds a results.jsonl (gnomon compare SCENE --techniques all -o FOLDER). Rows are sorted by error against the light's real
size where it has one; ratios of time are against the cheapest technique with a map.
"""
import json
import pathlib
import sys

NOTES = pathlib.Path(__file__).resolve().parent.parent / "docs" / "results_notes.md"


def read(folder):
    path = pathlib.Path(folder) / "results.jsonl"
    try:
        lines = [json.loads(line) for line in path.read_text().splitlines() if line.strip()]
    except (OSError, ValueError) as error:
        sys.exit(f"{path}: {error}; valid: a folder that gnomon compare wrote")
    if not lines:
        sys.exit(f"{path}: no results")
    return lines


def percent(error):
    return f"{100.0 * error['area'] * error['severity']:.2f}"


def row(line):
    visibility = line["visibility"]
    hard, area = visibility["hard"], visibility.get("area")
    cost = line["gpu_ms"]
    cells = [line["technique"], f"{hard['mae']:.4f}", f"{area['mae']:.4f}" if area else "", percent(hard["false_shadow"]),
             percent(hard["false_light"]), f"{cost['build']:.3f}", f"{cost['resolve']:.3f}", f"{line['memory_bytes'] / 2**20:.1f}"]
    return "| " + " | ".join(cells) + " |"


def error_of(line):
    visibility = line["visibility"]
    return visibility.get("area", visibility["hard"])["mae"]


def section(lines):
    first = lines[0]
    width, height = first["size"]
    print(f"\n## {first['scene']['name']}\n")
    light = first["lights"][0]
    print(f"{first['scene']['triangles']} triangles, {first['scene']['objects']} objects; {width} x {height}, {first['samples']} sample(s); "
          f"light `{light['name']}` ({light['kind']}); {first['device']['name']}, driver {first['device']['driver_version']}; gnomon "
          f"{first['gnomon']['version']} ({first['gnomon']['commit']}).\n")
    print("| technique | mae, hard light | mae, real size | false shadow % | false light % | build ms | resolve ms | MiB |")
    print("|---|---|---|---|---|---|---|---|")
    good = [line for line in lines if line["status"] == "ok"]
    for line in sorted(good, key=error_of):
        print(row(line))
    for line in lines:
        if line["status"] != "ok":
            print(f"| {line['technique']} | unavailable: {line['reason']} | | | | | | |")
    print("\nRepeat one row: `" + good[0]["command"] + "`")


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    print("# Results\n")
    print("Made by `scripts/make_results.py` from `gnomon compare SCENE --techniques all`; every technique at its default settings. Sorted by the")
    print("error against the light's real size where it has one. False shadow and false light: share of receivers times mean difference, against")
    print("the light shrunk to its centre. Errors depend on scene, view and settings: measure your own scene before you choose.")
    for folder in sys.argv[1:]:
        section(read(folder))
    if NOTES.exists():
        print("\n" + NOTES.read_text().rstrip())


if __name__ == "__main__":
    main()
