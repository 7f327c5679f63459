"""Every shader text is GLSL 4.50: glslangValidator accepts both stages. Usage: glsl_test.py VALIDATOR

The text is put together as the OpenGL device does it: version, stage, prelude, exact functions, the
shader's own defines and text, with includes expanded."""

import re
import subprocess
import sys
import tempfile

import source_tree

STAGES = {"vert": "VERTEX_STAGE", "frag": "FRAGMENT_STAGE"}
INCLUDE_LINE = re.compile(r'#include "([^"]+)"')


def expanded(path):
    text = (source_tree.ROOT / path).read_text(encoding="utf-8")
    return INCLUDE_LINE.sub(lambda match: expanded(match.group(1)), text)


def shaders():
    """(name, text path, defines) for every caustics_add_shader of the passes."""
    text = (source_tree.ROOT / "passes/room.cmake").read_text(encoding="utf-8")
    text = re.sub(r"#.*", "", text)
    for arguments in re.findall(r"caustics_add_shader\(([^)]*)\)", text):
        words = arguments.split()
        at_defines = words.index("DEFINES") if "DEFINES" in words else len(words)
        yield words[1], words[words.index("TEXT") + 1], words[at_defines + 1:]


def stage_text(stage, path, defines):
    lines = ["#version 450 core", f"#define {STAGES[stage]} 1"]
    lines += [f"#define {define.replace('=', ' ', 1)}" for define in defines]
    parts = ["pipeline/shader/prelude.glsl", "pipeline/shader/functions.glsl", path]
    return "\n".join(lines + [expanded(part) for part in parts])


def faults_of(validator, folder, stage, shader):
    name, path, defines = shader
    text = stage_text(stage, path, defines)
    if any(ord(character) > 126 for character in text):
        return f"{path}: GLSL is ASCII, and a character here is not"
    file = f"{folder}/{name}.{stage}"
    with open(file, "w", encoding="utf-8") as out:
        out.write(text)
    result = subprocess.run([validator, "-S", stage, file], capture_output=True, text=True)
    return f"{path}, {STAGES[stage]}:\n{result.stdout}{result.stderr}" if result.returncode else ""


def main():
    validator = sys.argv[1]
    listed = list(shaders())
    with tempfile.TemporaryDirectory() as folder:
        faults = [fault for shader in listed for stage in STAGES
                  if (fault := faults_of(validator, folder, stage, shader))]
    print(*faults, sep="\n")
    print(f"{len(listed)} shaders, {len(faults)} faults")
    return 1 if faults or not listed else 0


if __name__ == "__main__":
    sys.exit(main())
