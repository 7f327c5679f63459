"""The inspect page in a real browser: on a recording whose every share can be computed in the head
(tiny_recording.py), and on pages that the program writes.

Needs Debian's chromium, chromium-driver and python3-selenium; skipped where they are missing. SHOTS=DIR keeps
screenshots."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "program")]
from page_file import page  # noqa: E402
from program import PROGRAM, SMALL, main  # noqa: E402
from recording_parts import bare_recording  # noqa: E402
from tiny_recording import HEIGHT, WIDTH, tiny_recording  # noqa: E402
import glb  # noqa: E402
import numbers_test  # noqa: E402

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import WebDriverWait

    MISSING = (
        None
        if pathlib.Path("/usr/bin/chromedriver").exists()
        else "no chromedriver (package chromium-driver)"
    )
except ImportError:
    MISSING = "no selenium (package python3-selenium)"

PANELS = ["picture", "passes", "path", "ledger", "sweep", "compare"]


def start_browser():
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1440,1000"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(options=options, service=Service("/usr/bin/chromedriver"))


class BrowserTest(unittest.TestCase):
    """With a browser, and a page that no test changes."""

    @classmethod
    def setUpClass(cls):
        if MISSING:
            raise unittest.SkipTest(MISSING)
        cls.folder = tempfile.TemporaryDirectory()
        cls.page = pathlib.Path(cls.folder.name) / "page.html"
        cls.make_pages()
        cls.browser = start_browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.folder.cleanup()

    def setUp(self):
        self.clicks = 0
        self.open()

    def tearDown(self):
        severe = [
            entry["message"] for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"
        ]
        self.assertEqual(severe, [], "the page writes errors to the console")
        if os.environ.get("SHOTS"):
            self.browser.save_screenshot(
                str(pathlib.Path(os.environ["SHOTS"]) / f"{self._testMethodName}.png")
            )

    def open(self, state="", file=None):
        # Another address first: one that differs after "#" only would not load the page anew.
        self.browser.get("about:blank")
        self.browser.get(f"{(file or self.page).as_uri()}#{state}")
        self.wait(lambda: self.find("main .panel"))

    def wait(self, condition, what="the page did not get there"):
        def quietly(_):
            try:
                return condition()
            except Exception:  # not there yet
                return False

        return WebDriverWait(self.browser, 15, 0.05).until(quietly, what)

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def text(self, selector):
        return self.find(selector).text

    def wait_text(self, selector, wanted):
        self.wait(lambda: wanted in self.text(selector), f"{selector} never says {wanted!r}")

    def click(self, element):
        self.clicks += 1
        element.click()

    def click_texel(self, view, width, height, x, y):
        """A real click at the middle of a texel, of a picture that is shown whole."""
        canvas = self.find(f"{view} canvas")
        side = min(canvas.size["width"] / width, canvas.size["height"] / height)
        # Pictures stand in the upper left corner; the mouse moves from the middle.
        right = side * (x + 0.5) - canvas.size["width"] / 2
        up = canvas.size["height"] / 2 - side * (height - y - 0.5)
        self.clicks += 1
        ActionChains(self.browser).move_to_element_with_offset(
            canvas, round(right), round(-up)
        ).click().perform()

    def press(self, *keys):
        ActionChains(self.browser).send_keys(*keys).perform()

    def colors_shown(self, view, box="0, 0, c.width, c.height"):
        """All colours of a view's canvas, or of a box of it, as (red, green, blue)."""
        words = self.browser.execute_script(
            "const c = document.querySelector(arguments[0] + ' canvas');"
            f"const d = c.getContext('2d').getImageData({box}).data; const s = new Set();"
            "for (let i = 0; i < d.length; i += 4) s.add((d[i] << 16) | (d[i + 1] << 8) | d[i + 2]);"
            "return [...s];",
            view,
        )
        return {(word >> 16, (word >> 8) & 255, word & 255) for word in words}


    def colors_in_the_middle(self, view, reach):
        place = f"c.width / 2 - {reach}, c.height / 2 - {reach}, {2 * reach}, {2 * reach}"
        return self.colors_shown(view, place)


class InspectPage(BrowserTest):
    @classmethod
    def make_pages(cls):
        cls.page.write_text(page(*tiny_recording(), title="<script> in the title"), encoding="utf-8")
        cls.bare = pathlib.Path(cls.folder.name) / "bare.html"
        cls.bare.write_text(page(*bare_recording(), title="bare"), encoding="utf-8")
        # Where a pass draws depth only, the page holds no values beside the depths.
        recording, blobs = tiny_recording()
        run = recording["runs"][0]
        labels = [each["label"] for each in run["passes"]]
        for history in run["histories"]:
            if history["pass"] == labels.index("shadow_map[sun]"):
                history |= {"values": {}, "before": {}}
        cls.depths = pathlib.Path(cls.folder.name) / "depths.html"
        cls.depths.write_text(page(recording, blobs, title="depths"), encoding="utf-8")
        # With a picture whose values are no bytes, and shares of all sizes.
        recording, blobs = bare_recording()
        run = recording["runs"][0]
        run["attachments"][0] |= {
            "kind": "display",
            "width": 2,
            "height": 1,
            "data": blobs.add("f32", [1, 0.5, 0, 1, 0.2, 0.4, 0.6, 1]),
        }
        run["lights"][0] |= {
            "ledger": [{"account": "entered", "flux": [1, 1, 1], "meaning": ""}],
            "estimated_error": {"map": 5e-5, "grid": 1.4e-4, "missing": 0, "model": -4.56e-5, "all": 0.99996},
        }
        cls.small = pathlib.Path(cls.folder.name) / "small.html"
        cls.small.write_text(page(recording, blobs, title="small"), encoding="utf-8")

    def test_why_is_this_pixel_bright_is_answered_by_one_click(self):
        self.wait_text(".answer", "Why is this pixel bright?")
        self.click_texel(".picture-panel > .texture-view", WIDTH, HEIGHT, 2, 2)
        self.wait_text(".answer", "Pixel (2, 2)")
        self.assertLessEqual(self.clicks, 3)
        answer = self.text(".answer")
        self.assertIn("lamp: direct light 64 lux, caustic 200 lux", answer)
        self.assertIn("reads 4 texels of caustic_map[lamp]", answer)
        self.assertIn("3 cells of the grid gave light to these 4 texels; the largest gives 60 %", answer)
        rows = [
            [cell.text.replace("\u00a0", " ") for cell in row.find_elements(By.TAG_NAME, "td")]
            for row in self.all(".givers tbody tr")
        ]
        self.assertEqual(
            [row[:2] for row in rows],
            [["60 %", "cell (1, 1)"], ["30 %", "cell (2, 1)"], ["10 %", "cell (4, 5)"]],
        )
        # The middles of the cell's four vertices: (1.5 / 8, 1, 1.5 / 8), and 1.5 / 4 where they land. Half
        # floats.
        self.assertEqual(rows[0][2:], ["(0.188, 1, 0.188)", "(0.375, 0, 0.375)"])

    def test_a_texel_counts_by_the_share_that_the_pixel_covers(self):
        self.open("pick=pixel:3,2")
        self.wait_text(".answer", "Pixel (3, 2)")
        self.assertEqual(
            self.all(".givers tbody tr")[0].text.replace("\u00a0", " ").split(" (0")[0], "100 % cell (2, 1)"
        )

    def test_a_cell_leads_to_the_pixels_that_see_its_light(self):
        self.open("light=1&pick=cell:4,5")
        self.wait_text(".answer", "Cell (4, 5)")
        answer = self.text(".answer")
        self.assertIn(
            "It gave 3 sr (lumen per candela) to 2 texels of the caustic map; "
            "the brightest texel has 66.7 % of that",
            answer,
        )
        # Texel (3, 3) is read by pixels (3, 3) and (2, 2), texel (5, 5) by pixel (5, 5).
        self.assertIn("3 pixels of the picture show its light; most of it (5, 5)", answer)

    def test_a_texel_of_the_map_leads_to_pixels_and_to_its_history(self):
        self.open("light=1&pick=texel:7,7")
        self.wait_text(".answer", "Texel (7, 7) of caustic_map[lamp]")
        self.assertIn("1 pixel of the picture shows its light", self.text(".answer"))
        self.find(".answer").find_element(By.XPATH, ".//button[contains(., 'in order')]").click()
        self.wait_text(".texel-history", "3 fragments, 3 passed")
        rows = [row.text.replace("\u00a0", " ") for row in self.all(".texel-history tbody tr")]
        self.assertEqual(
            rows,
            [
                "1 cell (0, 0) 4 0 4 passed",
                "2 cell (1, 0) 0.5 4 4.5 passed",
                "3 cell (2, 0) 0.25 4.5 4.75 passed",
            ],
        )

    def test_a_history_says_what_the_depth_test_did(self):
        self.check_depth_history(self.page)

    def test_of_a_pass_that_draws_depth_only_the_history_follows_from_what_passed(self):
        self.check_depth_history(self.depths)

    def check_depth_history(self, file):
        self.open("panel=passes&pass=shadow_map[sun]&texel=1,1", file)
        self.wait_text(".texel-history", "4 fragments, 2 passed")
        rows = [
            [cell.text for cell in row.find_elements(By.TAG_NAME, "td")]
            for row in self.all(".texel-history tbody tr")
        ]
        self.assertEqual(
            [row[2:] for row in rows],
            [
                ["0.5", "1", "0.5", "0.5", "passed"],
                ["0.75", "0.5", "0.5", "0.75", "failed: behind (depth test)"],
                ["0.125", "0.5", "0.5", "0.125", "failed: discarded by the shader"],
                ["0.25", "0.5", "0.25", "0.25", "passed"],
            ],
        )
        self.assertIn("leaf, masked", rows[2][1])
        self.assertEqual(
            self.text(".texel-history h4"), "shadow_depth[sun] window depth, 1 where nothing was drawn"
        )

    def test_which_pass_went_wrong_first_takes_one_click(self):
        self.click(self.find("#panel-compare"))
        self.wait_text(".compare-list", "First to differ: landing[sun]")
        self.wait_text(".summary", "1 texel differs, by at most 0.25 at (10, 12)")
        self.assertLessEqual(self.clicks, 2)
        self.assertEqual(
            [pair.find_element(By.TAG_NAME, "strong").text for pair in self.all(".compare-list > ul .pair")],
            ["landing[sun]", "light_shading[sun]", "light_shading[lamp]", "compose", "tone_map"],
        )

    def test_nan_and_infinity_are_marked_and_counted(self):
        self.open("panel=passes&pass=landing[sun]&texture=landing_flux[sun]")
        self.wait_text(".legend", "NaN: 3 values")
        self.assertIn("infinite: 1 value", self.text(".legend"))
        shown = self.colors_shown(".passes-panel .middle")
        self.assertIn((255, 0, 255), shown)
        self.assertIn((0, 255, 255), shown)
        self.find(".not-finite .link").click()
        self.wait_text(".reading", "Texel (5, 1). flux that is left: (NaN, NaN, 0) m2")
        # It stands in the middle, 24 screen pixels wide: all but its border has its colour.
        self.assertEqual(self.colors_in_the_middle(".passes-panel .middle", 9), {(255, 0, 255)})

    def test_statuses_have_names_and_counts(self):
        self.open("panel=passes&pass=landing[lamp]")
        self.wait_text(".codes", "1 landed: 64")

    def test_names_are_text(self):
        self.assertIn("<script>", self.text("h1"))
        for panel in PANELS:
            self.open(f"panel={panel}")
            self.assertIsNone(self.browser.execute_script("return window.wasRun ?? null"))

    def test_what_is_missing_is_said(self):
        self.open("panel=passes&pass=glass")
        self.wait_text(".missing", "it would add 40 MB; caustics render tiny.glb --dump DIR writes it")
        self.open("panel=path&light=1")
        self.wait_text(".path-panel", "No ways of lamp are in this page.")
        self.open("panel=sweep&run=1")
        self.wait_text(".sweep-panel", "No pictures at other settings are in this page.")

    def test_a_page_that_holds_nothing_says_so_everywhere(self):
        for panel, selector, says in [
            ("picture", ".missing", "Not in this page"),
            ("passes", ".missing", "too large"),
            ("path", ".path-panel", "No ways of sun"),
            ("ledger", ".ledger-panel", "no ledger"),
            ("sweep", ".sweep-panel", "--sweep makes them"),
            ("compare", ".summary", "one run"),
        ]:
            for pick in ("", "pixel:3,3", "texel:3,3", "cell:3,3", "vertex:3,3"):
                self.open(f"panel={panel}&texel=1,1" + (f"&pick={pick}" if pick else ""), self.bare)
                self.wait_text(selector, says)
                self.assertEqual(self.all(".failure"), [])

    def test_a_picture_of_floats_is_shown_as_one_of_bytes(self):
        self.open("panel=passes", self.small)
        self.wait(lambda: self.colors_shown(".passes-panel .middle") >= {(255, 128, 0), (51, 102, 153)})

    def test_small_shares_are_said_to_be_small_and_negative_ones_how_large(self):
        self.open("panel=ledger", self.small)
        self.wait_text(".ledger-panel", "Stated error")
        self.assertIn(
            "map < 0.01 %, grid 0.014 %, missing 0 %, model \u22120.0046 %, all 100 %.",
            self.text(".ledger-panel").replace("\u00a0", " "),
        )

    def test_keys_reach_all_panels(self):
        for number, panel in enumerate(PANELS, 1):
            self.press(str(number))
            self.wait(lambda: self.find(f".{panel}-panel"))
        self.press("?")
        self.wait(lambda: self.find("dialog[open]"))
        self.press(Keys.ESCAPE)
        self.press("p")
        self.wait(lambda: "projector" in self.find("html").get_attribute("class"))

    def test_arrows_move_between_passes_and_textures(self):
        self.press("2")
        self.wait_text(".pass-row[aria-current=true]", "view_surfaces")
        self.press(Keys.ARROW_RIGHT)
        self.wait_text(".texture-view h3", "view_normal")
        self.press(Keys.ARROW_DOWN)
        self.wait_text(".pass-row[aria-current=true]", "shadow_map[sun]")
        self.assertIn("pass=shadow_map", self.browser.current_url)

    def test_tab_reaches_every_control_with_a_visible_focus(self):
        for panel in PANELS:
            self.open(f"panel={panel}")
            self.wait(lambda: self.find(f".{panel}-panel"))
            wanted = self.browser.execute_script(
                "return [...document.querySelectorAll('button, select, input, summary, canvas')].filter("
                "e => e.checkVisibility() && !e.closest('dialog')).length"
            )
            seen = set()
            for _ in range(wanted + 5):
                self.press(Keys.TAB)
                focused = self.browser.switch_to.active_element
                if focused.tag_name != "body":
                    seen.add(focused.id)
                    self.assertNotEqual(
                        focused.value_of_css_property("outline-style"),
                        "none",
                        focused.get_attribute("outerHTML")[:200],
                    )
            self.assertGreaterEqual(len(seen), wanted, panel)

    def test_a_slider_moves_over_the_values_of_a_setting(self):
        self.press("5")
        self.wait_text(".says", "iterations 5, error 4 %")
        slider = self.find("input.long")
        slider.send_keys(Keys.ARROW_LEFT)
        self.wait_text(".says", "iterations 3, error 4.5 %")

    def test_a_way_is_drawn_with_every_estimator(self):
        self.open("panel=path&vertex=19,15")
        self.wait_text(
            ".path-panel", "Vertex (19, 15) is not recorded; this is the nearest that is, (20, 14)."
        )
        self.wait(lambda: len(self.all(".section .met")) == 3)
        self.assertTrue(self.all(".section .cut.refractor")[0].get_attribute("d"))
        self.assertEqual([name.text for name in self.all(".line-name")], ["paper", "newton", "secant"])

    def test_the_ledger_names_every_account(self):
        self.press("4")
        self.wait_text(".ledger", "landed 87.1 %")
        self.assertIn("Nothing went to: not converged, exit not found.", self.text(".ledger-panel"))
        self.assertIn("The accounts add up to what entered.", self.text(".ledger-panel"))

    def test_an_address_shows_the_same_again(self):
        self.click_texel(".picture-panel > .texture-view", WIDTH, HEIGHT, 5, 5)
        self.wait_text(".answer", "Pixel (5, 5)")
        address = self.browser.current_url
        self.browser.get("about:blank")
        self.browser.get(address)
        self.wait_text(".answer", "Pixel (5, 5)")


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

    def go(self, state, says):
        self.browser.execute_script("location.hash = arguments[0]", state)
        self.wait_text("main", says)

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
            self.go(f"light={light['light']}&pick=pixel:{x},{47 - y}", f"Pixel ({x}, {47 - y})")
            with self.subTest(scene=name, pixel=(x, y), light=light["light"]):
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
                self.go(f"light=0&pick=vertex:{x},{y}", f"Grid vertex ({x}, {y})")
                with self.subTest(scene=name, vertex=(x, y)):
                    landed += self.compare_vertex(vertex)
        self.assertGreaterEqual(landed, len(self.scenes))

    def compare_vertex(self, vertex):
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
                self.go(
                    f"panel=passes&pass={history['pass']}&texel={x},{y}", f"exel ({x}, {y})",
                )
                with self.subTest(scene=name, history=(history["pass"], x, y)):
                    fragments += self.compare_history(history)
        self.assertGreaterEqual(fragments, 3 * len(self.scenes))

    def compare_history(self, history):
        many = len(history["fragments"])
        self.wait_text(".texel-history", f"{many} fragment" if many else "Nothing was drawn")
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
