"""Which room may include which. The arrows below are the architecture; a file that breaks one fails."""

import sys

import source_tree

# A part of the tree -> the parts that its files may include besides themselves. The longest matching
# part counts.
ARROWS = {
    "app": ["passes", "raster", "gl_backend", "reference", "pipeline"],
    "passes": ["pipeline"],
    "raster": ["pipeline"],
    "gl_backend": ["pipeline"],
    "reference": ["pipeline"],
    "pipeline/plan": ["pipeline/scene", "pipeline/gpu"],
    "pipeline/scene": ["pipeline/gpu"],  # Scene holds images as the Device knows them
    "pipeline/shader": ["pipeline/gpu"],
    "pipeline/gpu": [],
}
# Libraries that only one part may name: the rest of the tree builds and runs without them.
OWNED = {
    "epoxy/": ["gl_backend"],
    "EGL/": ["gl_backend"],
    "GL/": ["gl_backend"],
    "tbb/": ["raster"],
    "oneapi/": ["raster"],
    "tiny_gltf.h": ["pipeline/scene/gltf"],
    "nlohmann/": ["pipeline/scene/gltf", "app"],
    "OpenImageIO/": ["pipeline/scene", "app"],
    "CLI/": ["app"],
    "embree": ["reference"],
}


def part_of(path):
    matching = [part for part in ARROWS if path == part or path.startswith(part + "/")]
    return max(matching, key=len) if matching else None


def lies_in(path, folder):
    return path == folder or path.startswith(folder + "/")


def faults_of(path):
    own = part_of(path)
    if own is None:
        yield f"{path}: is in no room of the architecture"
        return
    for quote, target in source_tree.includes(source_tree.ROOT / path):
        if quote == "<":
            for prefix, owners in OWNED.items():
                if target.startswith(prefix) and not any(lies_in(path, owner) for owner in owners):
                    yield f"{path}: <{target}> belongs to {' and '.join(owners)}"
            continue
        if target.startswith("@"):  # a template's own text, set by CMake
            continue
        if not (source_tree.ROOT / target).is_file():
            yield f'{path}: "{target}" is not a path from the repository root'
        elif not any(lies_in(target, part) for part in [own, *ARROWS[own]]):
            yield f'{path}: {own} may not include "{target}"'


def main():
    paths = [source_tree.name(p) for p in source_tree.files(".cpp", ".hpp", ".glsl", ".in")]
    faults = [fault for path in paths for fault in faults_of(path)]
    print(*faults, sep="\n")
    print(f"{len(paths)} files, {len(faults)} faults")
    return 1 if faults or not paths else 0


if __name__ == "__main__":
    sys.exit(main())
