"""Pages that `caustics inspect` writes, in a browser: they show what statistics and `caustics probe` say."""
import json
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "program")]
from browser import BrowserTest, By  # noqa: E402
from program import PROGRAM, SMALL, main  # noqa: E402
import glb  # noqa: E402
import numbers_test  # noqa: E402


def luminance(flux):
    """Rec. 709's."""
    return 0.2126 * flux[0] + 0.7152 * flux[1] + 0.0722 * flux[2]


def number_near(value, digits=4):
    """As the page writes numbers between 1e-4 and 1e4."""
    return f"{float(f'{value:.{digits}g}'):.10g}"


class WrittenPage(BrowserTest):
    """What `caustics inspect` writes of a glass ball, alone and beside a run of one iteration."""

    @classmethod
    def make_pages(cls):
        folder = cls.page.parent
        (folder / "ball.glb").write_bytes(glb.scene())
        cls.both = folder / "both.html"
        for file, more in ((cls.page, []), (cls.both, ["--against", "iterations=1"])):
            subprocess.run(
                [PROGRAM, "inspect", "ball.glb", *SMALL, "-o", file, "--quiet", *more],
                cwd=folder,
                check=True,
            )
        (folder / "two.glb").write_bytes(numbers_test.scene_of_two_lights())
        cls.two = folder / "two.html"
        subprocess.run([PROGRAM, "inspect", "two.glb", *SMALL, "-o", cls.two, "-q"], cwd=folder, check=True)
        subprocess.run(
            [PROGRAM, "two.glb", *SMALL, "-o", "two.png", "--stats", "two.json", "-q"], cwd=folder, check=True
        )
        cls.stats = json.loads((folder / "two.json").read_text())

    def test_each_light_has_its_own_ledger_with_the_numbers_of_the_statistics(self):
        self.open("panel=ledger", self.two)
        self.wait_text("main", "Where the light of lamp goes")
        heads, boxes, tables = self.browser.execute_script(
            "const texts = (selector, of = document) => [...of.querySelectorAll(selector)].map("
            "e => e.textContent);"
            "return [texts('.ledger-panel h2'), texts('.ledger-box'), [...document.querySelectorAll("
            "'.ledger-panel table')].map(t => [...t.querySelectorAll('tbody tr')].map(r => texts('td', r)))]"
        )
        self.assertEqual(heads, ["Where the light of sun goes", "Where the light of lamp goes"])
        for box, rows, light in zip(boxes, tables, self.stats["lights"]):
            flux = {name.replace("_", " "): values for name, values in light["flux"].items()}
            entered = number_near(luminance(flux["entered"]))
            self.assertIn(f"{entered} {light['flux']['unit']}", box)
            said = {row[0]: row[1:5] for row in rows}
            for name in ("entered", "fresnel", "absorbed", "total reflection", "missed"):
                share, *channels = said[name]
                self.assertEqual(channels, [number_near(value, 5) for value in flux[name]], name)
                shown = float(share.replace("\u00a0", " ").removeprefix("< ").split(" ")[0]) / 100
                true = luminance(flux[name]) / luminance(flux["entered"])
                self.assertAlmostEqual(shown, true, delta=max(0.005 * true, 1e-4), msg=name)

    def test_a_bright_pixel_names_its_cells_in_three_clicks(self):
        self.wait_text(".answer", "Why is this pixel bright?")
        # The same pixels as probe: those whose caustic has cells.
        lit = self.browser.execute_script("return document.querySelectorAll('.picture-panel canvas').length")
        self.assertGreater(lit, 0)
        self.open("pick=pixel:32,13")
        self.wait_text(".answer", "Pixel (32, 13)")
        self.wait(lambda: self.all(".givers tbody tr"), "no cell gave light to this pixel")
        self.assertIn("caustic", self.text(".answer"))

    def test_the_first_pass_that_differs_is_the_landing(self):
        self.open(file=self.both)
        self.press("6")
        self.wait_text("main", "landing[sun]")
        self.assertNotIn("receiver_map[sun] differs", self.text("main"))

    def test_every_panel_shows(self):
        for number in range(1, 7):
            self.press(str(number))
            self.wait(lambda: len(self.text("main")) > 20)


def scaled(document, k):
    """The scene `k` times as large, its light as bright on it as before."""
    document["nodes"].append({"children": document["scenes"][0]["nodes"], "scale": [k, k, k]})
    document["scenes"][0]["nodes"] = [len(document["nodes"]) - 1]
    for material in document["materials"]:
        volume = material.get("extensions", {}).get("KHR_materials_volume", {})
        for length in ("thicknessFactor", "attenuationDistance"):
            if length in volume:
                volume[length] *= k
    for light in document["extensions"]["KHR_lights_punctual"]["lights"]:
        light["intensity"] *= k * k if light["type"] != "directional" else 1
    document["cameras"][0]["perspective"]["znear"] *= k
    return document


def colored_under_two_lights():
    """Coloured, dispersing glass under a sun and a lamp."""
    document, blob = glb.unpack(glb.scene())
    volume = document["materials"][0]["extensions"]["KHR_materials_volume"]
    volume.update(attenuationColor=[0.9, 0.5, 0.2], attenuationDistance=1)
    document["extensions"]["KHR_lights_punctual"]["lights"].append(
        {"name": "lamp", "type": "point", "intensity": 900, "color": [1, 0.8, 0.5]}
    )
    document["nodes"].append(
        {"name": "lamp", "translation": [1, 4, 1], "extensions": {"KHR_lights_punctual": {"light": 1}}}
    )
    document["scenes"][0]["nodes"].append(len(document["nodes"]) - 1)
    return document, blob


class PageAndProbe(BrowserTest):
    """The page says of pixels, vertices and texels what `caustics probe` prints, to the last bit, whether the
    scene is a centimetre large or a hundred metres."""

    LATTICE = [(x, y) for y in range(2, 48, 6) for x in range(3, 64, 5)]  # pixels, from the left and the top
    VERTICES = [(16, 16), (12, 20), (3, 3), (21, 11)]
    TEXELS = [(16, 16), (13, 18), (18, 14)]
    MAPS = ["caustic_cells[sun]", "caster_map[sun]"]

    @classmethod
    def make_pages(cls):
        cls.scenes = {}
        ball, two = glb.scene(), glb.pack(*colored_under_two_lights())
        for name, data, k in (("ball", ball, 0.01), ("two", two, 1), ("ball", ball, 100)):
            document, blob = glb.unpack(data)
            scene = cls.page.parent / f"{name}{k}.glb"
            scene.write_bytes(glb.pack(scaled(document, k), blob))
            cls.scenes[f"{name} x {k}"] = (scene, cls.written(scene), cls.probed(scene))
        cls.page = next(iter(cls.scenes.values()))[1]

    @classmethod
    def written(cls, scene):
        page = scene.with_suffix(".html")
        subprocess.run([PROGRAM, "inspect", scene, *SMALL, "-o", page, "--quiet"], check=True)
        return page

    @classmethod
    def probed(cls, scene):
        asked = [f"--pixel={x},{y}" for x, y in cls.LATTICE] + [f"--texel={x},{y}" for x, y in cls.VERTICES]
        asked += [f"--history={label}:{x},{y}" for label in cls.MAPS for x, y in cls.TEXELS]
        said = subprocess.run(
            [PROGRAM, "probe", scene, *SMALL, "--json", *asked], check=True, capture_output=True, text=True
        ).stdout
        probed = json.loads(said)
        # Those that a light gives most caustic, the least that is any, and one without.
        by_light = lambda light: sorted(probed["pixels"], key=lambda p: -sum(p["lights"][light]["caustic"]))
        chosen = []
        for light in range(len(probed["pixels"][0]["lights"])):
            lit = [p for p in by_light(light) if sum(p["lights"][light]["caustic"]) > 0]
            chosen += lit[:3] + lit[-1:] + by_light(light)[-1:]
        probed["pixels"] = chosen
        return probed

    def exact(self, element):
        return [float(word) for word in element.get_attribute("value").split()]

    def exact_in(self, selector):
        return [self.exact(data) for data in self.all(f"{selector} data")]

    def test_a_pixel_has_the_light_that_probe_says(self):
        lit = {}
        for name, (_, page, probed) in self.scenes.items():
            self.open(file=page)
            lit[name] = sum(self.compare_pixel(name, pixel) for pixel in probed["pixels"])
        for name, count in lit.items():
            self.assertGreaterEqual(count, 4, name)  # pixels with a caustic

    def compare_pixel(self, name, pixel):
        """How many lights give it a caustic."""
        (x, y), lit = pixel["pixel"], 0
        for light in pixel["lights"]:
            self.go(f"light={light['light']}&pick=pixel:{x},{47 - y}")
            with self.subTest(scene=name, pixel=(x, y), light=light["light"]):
                self.assertEqual(self.text(".answer h3"), f"Pixel ({x}, {47 - y})")
                self.assertIn(pixel["beauty"], self.exact_in(".answer > p"))
                self.assertEqual(
                    self.exact_in(".lights li"),
                    [values for each in pixel["lights"] for values in (each["direct"], each["caustic"])],
                )
                lit += self.compare_givers(light)
        return lit

    def compare_givers(self, light):
        if not light["texels"]:
            self.assertIn("reads no caustic map", self.text(".answer"))
            return 0
        maps = {}
        for texel in light["texels"]:
            maps[texel["map"]] = maps.get(texel["map"], 0) + 1
        reads = next(p.text for p in self.all(".answer > p") if "the pixel reads" in p.text)
        self.assertEqual([int(n) for n in re.findall(r"(\d+) texel", reads)], list(maps.values()))
        contributions = light["contributions"]
        kind_of = lambda each: "cell" if "cell" in each else "vertex"
        kinds = sorted({kind_of(each) for each in contributions})
        if not contributions:
            self.assertIn("No cell of the grid puts light there", self.text(".answer"))
            return 1
        many = " and ".join({"cell": "cells", "vertex": "vertices"}[kind] for kind in kinds)
        noun = kinds[0] if len(contributions) == 1 else many
        self.assertIn(
            f"{len(contributions)} {noun} of the grid gave light", self.text(".answer").replace("\u202f", "")
        )
        rows = self.all(".givers tbody tr")
        expected = contributions[: len(rows)]
        self.assertGreaterEqual(len(rows), min(8, len(contributions)))
        self.assertEqual(
            [self.exact(row.find_element(By.CSS_SELECTOR, "td data"))[0] for row in rows],
            [each["share"] for each in expected],
        )
        self.assertEqual(
            [row.find_elements(By.TAG_NAME, "td")[1].text.replace("\u00a0", " ") for row in rows],
            ["{} ({}, {})".format(kind_of(each), *each[kind_of(each)]) for each in expected],
        )
        return 1

    def test_a_vertex_enters_and_lands_where_probe_says(self):
        landed = 0
        for name, (_, page, probed) in self.scenes.items():
            self.open(file=page)
            for vertex in probed["vertices"]:
                x, y = vertex["vertex"]
                self.go(f"light=0&pick=vertex:{x},{y}")
                with self.subTest(scene=name, vertex=(x, y)):
                    landed += self.compare_vertex(vertex)
        self.assertGreaterEqual(landed, len(self.scenes))

    def compare_vertex(self, vertex):
        self.assertEqual(self.text(".answer h3"), "Grid vertex ({}, {})".format(*vertex["vertex"]))
        if not vertex["passes"]:
            self.assertIn("its light goes straight on", self.text(".answer"))
            return 0
        first, last = vertex["passes"][0], vertex["passes"][-1]
        entry = next((v["values"] for v in first["computes"] if v["name"] == "entry_point"), None)
        if entry is None:
            self.assertIn("its light goes straight on", self.text(".answer"))
            return 0
        said = self.exact_in(".answer > p")
        self.assertEqual(said[0], entry)
        if last.get("status") == "landed":
            landing = next(v["values"] for v in last["stores"] if v["name"] == "landing")
            self.assertEqual(said[1], landing[:3])
        return 1

    def test_a_texel_has_the_history_that_probe_says(self):
        fragments = 0
        for name, (_, page, probed) in self.scenes.items():
            self.open(file=page)
            for history in probed["texels"]:
                x, y = history["texel"]
                self.go(f"panel=passes&pass={history['pass']}&texel={x},{y}")
                with self.subTest(scene=name, history=(history["pass"], x, y)):
                    fragments += self.compare_history(history)
        self.assertGreaterEqual(fragments, 3 * len(self.scenes))

    def compare_history(self, history):
        many = len(history["fragments"])
        self.assertIn("exel ({}, {})".format(*history["texel"]), self.text(".texel-history"))
        self.assertIn(f"{many} fragment" if many else "Nothing was drawn", self.text(".texel-history"))
        tables = self.all(".texel-history table")
        for number, table in enumerate(tables if many else ()):
            given = [
                [self.exact(data) for data in row.find_elements(By.CSS_SELECTOR, "td data")[:3]]
                for row in table.find_elements(By.CSS_SELECTOR, "tbody tr")
            ]
            self.assertEqual(len(given), min(many, 60))
            before = history["before"][number]
            for fragment, (gave, had, has) in zip(history["fragments"], given):
                self.assertEqual(gave, fragment["gives"][number])
                self.assertEqual(had, before)
                before = fragment["after"][number]
                self.assertEqual(has, before)
        return many


if __name__ == "__main__":
    main()
