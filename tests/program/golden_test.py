"""The bits of many small frames, and the figures stated of them, are those that golden.txt keeps.

    CAUSTICS_PROGRAM=... tests/program/golden_test.py --update     writes it anew

They are the same for every compiler, lane width and number of threads. A line is a frame: the pass or the
part of an answer, and the beginning of its hash. Whoever changes a line says in the commit why."""
import collections
import hashlib
import json
import pathlib
import subprocess
import sys
import tempfile

import golden_scenes
from program import PROGRAM, ProgramTest, main

KEPT = pathlib.Path(__file__).with_name("golden.txt")
SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
SMALL = ["-r", "40x24", "--grid", "20", "--map", "28", "-D", "shadow=36", "-D", "light.samples=3",
         "-D", "shafts=10", "-D", "medium.steps=5"]
# Scenes, of golden_scenes.py or else of the samples, and how each is drawn: a frame for each text of options.
FRAMES = {
    "crystal": ["", "--wavelengths 1 --camera floor", "--splat gaussian -D splat.sigma=0.9 -D cascades=off",
                "--splat point -D views=shared --interfaces 1", "--preset paper", "-D reflections=yes",
                "--estimator newton -D thickness=wyman", "--estimator impostor --map 48",
                "-D samples=4 --exposure 1.5 --tone-map neutral",
                "--view 200,30 --zoom 1.4 --fov 50 --ground on"],
    "surfaces": ["", "-D samples=8 -D highlights=off", "--environment-strength 1.5 --tone-map linear",
                 "--sun 140,50,9 --ground off --view auto",
                 "-D mirror.metallic=0.85 -D mirror.roughness=0.6 -D emissive.lights=on --camera floor"],
    "frosted": ["", "-D glass.roughness=0.4 --wavelengths 8", "-D reflections=yes -D hidden_receivers=off",
                "--interfaces 1"],
    "window": ["", "--assume-solid", "--grid 48 --map 48 -D shadow=48 -D cube=on --camera floor",
               "-D medium.steps=9 -D samples=4"],
    "misty": ["", "-D cube=off -D reflections=yes", "--splat point -D shafts=7 --camera floor",
              "--wavelengths 8 -D cascades=off"],
    "oblong_pool": ["", "--time 0.7 -D reflections=yes", "--estimator newton --splat gaussian"],
    "nested": ["", "-D bounces=3 -D reflections=yes -D least_share=0.01 --camera floor",
               "-D further.share=1", "-D splits=0 --grid 48 --map 48 -D shadow=48 -D cube=on"],
    "many_lamps": ["-D light.least=0.1 -D light.full=0.3"],
    "stored": ["", "--time 0.3", "--time 0.8 --animation moves", "--animation none --camera floor"],
    "shining": ["", "-D emissive.lights=off --wavelengths 1", "-D light.samples=6"],
    "glass_sphere_coarse": ["", "-D pixel_means=off -D outside_share=0.1"],
    "prism": ["--wavelengths 9", "--estimator paper -D search.start=0.2 -D unconverged=draw"],
    "spectrum": ["--camera close"],
    "metal_ring": ["", "--splat gaussian"],
    "receivers": ["-D hidden_receivers=off --camera floor"],
    "two_lights": ["-D samples=16 -r 20x12"],
    "sun_disk": [""],
    "thin_panes": ["--weights paper"],
    "water_patch": ["--estimator newton -D newton.guard=off -D newton.epsilon=0.02"],
    "water_normal_map": ["", "-D reflections=yes"],
    "stained_glass": ["--splat point", "-D thickness=wyman"],
    "moving_lens": ["--time 1.3", "--animation none"],
    "hazy_lens": [""],
    "closed_room": ["--camera other -D further.share=1"],
    "slab_glass": ["-D iterations=1"],
    "glass/drinking_glass": ["-D splits=1"],
    "glass/bottle_of_liquid": ["-D splits=1"],
    "glass/deep_ring": [""],
}
# What depends on the machine, or on how long something took.
OF_THE_MACHINE = {"program", "device", "file", "scene_file", "milliseconds", "processor_milliseconds",
                  "seconds", "memory_bytes", "memory_budget_bytes", "frames", "refused"}


def short(text):
    return hashlib.sha256(text.encode()).hexdigest()[:8]


def without_machine(value):
    if isinstance(value, dict):
        return {key: without_machine(part) for key, part in value.items() if key not in OF_THE_MACHINE}
    return [without_machine(part) for part in value] if isinstance(value, list) else value


def parts(name, answer):
    """The hashes of an answer's parts."""
    return {f"{name}.{key}": short(json.dumps(part)) for key, part in without_machine(answer).items()
            if key not in ("scene", "settings", "format")}


def frame(folder, scene, options):
    """The hashes of one frame: of each pass's attachments, of `plan` and of `--stats`, in the order of the
    run."""
    def asked(*arguments):
        result = subprocess.run([PROGRAM, *map(str, arguments), *SMALL, *options], cwd=folder, text=True,
                                capture_output=True, timeout=300)
        if result.returncode != 0:
            raise RuntimeError(f"{arguments}: {result.stderr}")
        return result.stdout

    texts = collections.defaultdict(str)
    for line in asked("digest", scene).splitlines():
        _, label, attachment, value = line.split(" ")
        texts[label.split("[")[0].split(".")[0]] += f"{label} {attachment} {value}\n"
    hashes = parts("plan", json.loads(asked("plan", "--json", scene)))
    hashes.update((label, short(text)) for label, text in texts.items())
    asked("render", scene, "-q", "-o", "picture.png", "--stats", "stats.json")
    hashes.update(parts("stats", json.loads((folder / "stats.json").read_text())))
    return hashes


def frames(folder, name):
    """The hashes of a scene's frames, by their options."""
    scene = SAMPLES / f"{name}.glb"
    if hasattr(golden_scenes, name):
        scene = folder / f"{name}.glb"
        getattr(golden_scenes, name)().write(scene)
    for options in FRAMES[name]:
        yield " ".join([name, *options.split()]), frame(folder, scene, options.split())


def line_of(name, hashes):
    return f"{name}: " + " ".join(f"{part}={value}" for part, value in hashes.items())


def kept():
    lines = (line.rsplit(": ", 1) for line in KEPT.read_text().splitlines())
    return {name: dict(part.split("=") for part in hashes.split()) for name, hashes in lines}


class Golden(ProgramTest):
    def check(self, name):
        expected = kept()
        for frame_name, hashes in frames(self.folder, name):
            with self.subTest(frame_name):
                before = expected.get(frame_name, {})
                differing = [part for part in {**before, **hashes} if before.get(part) != hashes.get(part)]
                self.assertEqual(differing, [], "differ from golden.txt")


def add_tests():
    for name in FRAMES:
        setattr(Golden, "test_" + name.replace("/", "_"), lambda self, name=name: self.check(name))


add_tests()


def update():
    with tempfile.TemporaryDirectory() as folder:
        lines = [line_of(*named) for name in FRAMES for named in frames(pathlib.Path(folder), name)]
    KEPT.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    if sys.argv[1:] == ["--update"]:
        update()
    else:
        main()
