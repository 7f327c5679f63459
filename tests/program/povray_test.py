"""lab/reference/povray: what is handed to POV-Ray, and the arithmetic of the comparison. POV-Ray itself is
not needed."""

import math
import pathlib
import subprocess
import sys

import glb as small
import pictures as files
from program import PROGRAM, ProgramTest, main

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOL = ROOT / "lab" / "reference" / "povray"


def modules_of_the_tool(*names):
    """The tool's modules: two have names that this folder has, too."""
    ours = {name: sys.modules.pop(name) for name in ("glb", "pictures")}
    sys.path.insert(0, str(TOOL))
    try:
        return [__import__(name) for name in names]
    finally:
        sys.path.remove(str(TOOL))
        for name in ours:
            sys.modules.pop(name, None)
        sys.modules.update(ours)


reader, exporter, pictures, report = modules_of_the_tool("glb", "export", "pictures", "report")


class Povray(ProgramTest):
    def compare(self, *arguments):
        return subprocess.run([sys.executable, TOOL / "compare.py", "--program", PROGRAM, *arguments],
                              cwd=self.folder, text=True, capture_output=True, timeout=60)

    def refused(self, code, saying, *arguments):
        before = self.files()
        result = self.compare(*arguments)
        self.assertEqual((result.returncode, result.stdout), (code, ""), result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertIn(saying, result.stderr)
        self.assertEqual(self.files(), before)

    def test_what_is_missing_is_said_in_one_line(self):
        self.refused(3, "install the package povray", "--povray", "./no-such-povray")
        # Anything that can be run: it is looked for, but these scenes are refused before.
        self.refused(3, "only indexed triangles with normals", "--povray", sys.executable, "--scene",
                     "ball.glb")
        sphere = str(ROOT / "scenes" / "glass_sphere.glb")
        self.refused(3, "no orthographic camera 'view'", "--povray", sys.executable, "--scene", sphere,
                     "--camera", "view")
        self.refused(3, "no mesh 'bell'", "--povray", sys.executable, "--scene", sphere, "--exact", "bell")
        self.refused(3, "no.glb", "--povray", sys.executable, "--scene", "no.glb")
        self.refused(3, "light 'spot'", "--povray", sys.executable, "--scene",
                     str(ROOT / "scenes" / "two_lights.glb"))
        (self.folder / "torn.glb").write_bytes(small.scene()[:1000])
        self.refused(3, "torn.glb", "--povray", sys.executable, "--scene", "torn.glb")

    def test_scenes_are_handed_on_as_they_are(self):
        scene = reader.read(ROOT / "scenes" / "glass_sphere.glb")
        self.assertEqual([(m.name, len(m.triangles)) for m in scene.meshes],
                         [("sphere", 20480), ("floor", 2)])
        self.assertEqual((scene.lights[0].kind, scene.lights[0].color), ("directional", (1, 1, 1)))
        for got, expected in zip(scene.lights[0].travel, (0, -1, 0)):
            self.assertAlmostEqual(got, expected, delta=1e-6)
        view = scene.cameras["floor"]
        for vector, expected in ((view.right, (1, 0, 0)), (view.up, (0, 0, -1)), (view.forward, (0, -1, 0))):
            self.assertTrue(math.dist(vector, expected) < 1e-6, vector)
        text = exporter.scene_text(scene, view, "count 1000 gather 20, 100")
        for word in ("count 1000 gather 20, 100", "ior 1.5 ", "fresnel on", "refraction on reflection off"):
            self.assertIn(word, text)
        self.assertIn("refraction on reflection on",
                      exporter.scene_text(scene, view, "count 1", reflections=True))
        self.assertNotIn("photons { target", exporter.scene_text(scene, view, None))
        sphere = exporter.sphere(scene.meshes[0])
        self.assertTrue(sphere.startswith("sphere { <0,0.799999982,0>, 0.500000"), sphere)

    def test_absorption_is_that_of_the_file(self):
        volume = {"attenuationColor": [0.9, 0.5, 0.2], "attenuationDistance": 0.4}
        text = exporter.absorption({"extensions": {"KHR_materials_volume": volume}})
        words = text.replace("<", " ").replace(">", "").split()
        distance = float(words[words.index("fade_distance") + 1])
        for color, fade in zip(volume["attenuationColor"], map(float, words[-1].split(","))):
            self.assertTrue(0 <= fade <= 1)
            self.assertAlmostEqual(math.exp(-(1 - fade) * 0.7 / distance), color ** (0.7 / 0.4), delta=1e-6)

    def test_pictures_are_read_and_averaged(self):
        values = {c: [i + 100 * k for i in range(16)] for k, c in enumerate("RGB")}
        (self.folder / "p.exr").write_bytes(files.exr({f"caustic.{c}": v for c, v in values.items()}, 4, 4))
        picture = pictures.read(self.folder / "p.exr", self.folder, "caustic")
        self.assertEqual([list(p) for p in picture.planes], [values[c] for c in "RGB"])
        boxes = picture.boxes(2)
        self.assertEqual(list(boxes.planes[0]), [2.5, 4.5, 10.5, 12.5])
        self.assertAlmostEqual(pictures.relative_l1(boxes.scaled(1.25), boxes), 0.25, delta=1e-6)
        self.assertEqual(self.files(), ["ball.glb", "p.exr"])

    def test_seconds_for_an_error_lie_between_settings(self):
        rows = [{"wall": t, "raw": {4: e}} for t, e in ((1, 0.4), (2, 0.5), (4, 0.1), (8, 0.1))]
        points = report.front(rows, 4, "wall")
        self.assertEqual(points, [(0.4, 1), (0.1, 4)])
        self.assertAlmostEqual(report.seconds_for(points, 0.2)["seconds"], 2, delta=1e-9)
        self.assertEqual(report.seconds_for(points, 0.6), {"seconds": 1, "bound": True})
        self.assertIsNone(report.seconds_for(points, 0.05))


if __name__ == "__main__":
    main()
