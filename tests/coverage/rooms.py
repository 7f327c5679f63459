"""Prints a table of lines and branches that tests reach, by rooms, from gcovr's JSON; then the lines of the
loader and of the devices that throw an error and are not reached. Exit 1 where there is one that a test
could reach.

    rooms.py ROOT COVERAGE.json
"""
import json
import re
import sys

# Rooms whose error paths must all be tested: the loader, the Device contract, and both devices.
HELD = ("pipeline/scene/", "pipeline/gpu/", "raster/", "gl_backend/")
# What no test can bring about here, and why.
OUT_OF_REACH = {
    ("raster/software_device.cpp", "lane width '"): "needs a processor without one of the lane widths",
    ("pipeline/scene/gltf/load_gltf.cpp", "problem.what()"): "for what the libraries may throw one day",
}
THROWS = re.compile(r"\bthrow\s+[A-Za-z]|(?<!void )\b(refuse|fail|bad_input|bad)\(")


def room_of(name):
    parts = name.split("/")
    return "/".join(parts[:2]) if parts[0] == "pipeline" else parts[0]


def main(root, report):
    with open(report, encoding="utf-8") as file:
        files = json.load(file)["files"]
    rooms, unreached = {}, []
    for source in files:
        counts = rooms.setdefault(room_of(source["file"]), [0, 0, 0, 0])
        lines = [line for line in source["lines"] if not line.get("gcovr/noncode")]
        counts[0] += sum(line["count"] > 0 for line in lines)
        counts[1] += len(lines)
        for line in lines:
            taken = [branch["count"] > 0 for branch in line["branches"]]
            counts[2] += sum(taken)
            counts[3] += len(taken)
        if source["file"].startswith(HELD):
            with open(f"{root}/{source['file']}", encoding="utf-8") as file:
                texts = file.read().split("\n")
            unreached += [(source["file"], line["line_number"], texts[line["line_number"] - 1].strip())
                          for line in lines
                          if line["count"] == 0 and THROWS.search(texts[line["line_number"] - 1])]
    print(f"{'room':20} {'lines':>16} {'branches':>18}")
    rooms["all"] = [sum(column) for column in zip(*rooms.values())]
    for room, (reached, lines, taken, branches) in rooms.items():
        print(f"{room:20} {reached:6} / {lines:6} {100 * reached / max(lines, 1):4.1f} %"
              f" {taken:6} / {branches:6} {100 * taken / max(branches, 1):4.1f} %")
    untested = 0
    for name, number, text in unreached:
        reason = next((why for (file, part), why in OUT_OF_REACH.items() if file == name and part in text),
                      None)
        untested += reason is None
        print(f"not reached{f' ({reason})' if reason else ''}: {name}:{number}: {text}")
    return 1 if untested else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2]))
