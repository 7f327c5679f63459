"""The inspect page in a browser, on a recording whose every share can be computed in the head
(tiny_recording.py)."""
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "program")]
from browser import BrowserTest, By, Keys, PANELS  # noqa: E402
from page_file import page  # noqa: E402
from program import main  # noqa: E402
from recording_parts import bare_recording  # noqa: E402
from tiny_recording import HEIGHT, WIDTH, tiny_recording  # noqa: E402


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

    def test_each_pair_of_textures_is_named_by_its_pass_and_its_texture(self):
        self.open("panel=compare")
        self.wait_text(".compare-list", "First to differ")
        # As text, because the equal ones are folded away.
        said = self.browser.execute_script(
            "return [...document.querySelectorAll('.compare-list .pair')].map(e => e.textContent)"
        )
        a, b = tiny_recording()[0]["runs"]
        names, equal = [], []
        for one, other in zip(a["attachments"], b["attachments"]):
            names.append(f"{a['passes'][one['pass']]['label']} {one['texture']} ")
            equal.append(one["sha256"] == other["sha256"])
        wanted = [name for alike in (False, True) for name, same in zip(names, equal) if same == alike]
        self.assertEqual([text[: len(name)] for text, name in zip(said, wanted)], wanted)
        self.assertEqual(len(said), len(wanted))
        words = [text[len(name) :] for text, name in zip(said, wanted)]
        self.assertEqual([word == "equal" for word in words], sorted(equal))

    def test_linked_pictures_of_one_texture_move_together(self):
        views = [".three > :nth-child(1)", ".three > :nth-child(2)"]
        # Lets the pictures be drawn first.
        pictures = lambda: self.browser.execute_async_script(
            "const [views, done] = arguments;"
            "const frame = (then) => requestAnimationFrame(() => setTimeout(then));"
            "frame(() => frame(() => done(views.map("
            "view => document.querySelector(view + ' canvas').toDataURL()))));",
            views,
        )
        self.open("panel=compare&compare=caster_map[sun]/caster_position[sun]")
        self.wait_text(".summary", "caster_position[sun]")
        self.wait(lambda: len(self.colors_shown(views[0])) > 9 and len(self.colors_shown(views[1])) > 9)
        seen = [pictures()]
        act = (
            "const c = document.querySelector(arguments[0] + ' canvas'), b = c.getBoundingClientRect();"
            "c.setPointerCapture = () => {};"
            "const kinds = {bubbles: true, cancelable: true};"
            "const at = (x, y) => ({...kinds, clientX: b.left + x, clientY: b.top + y});"
        )
        wheel = "c.dispatchEvent(new WheelEvent('wheel', {...at(50, 70), deltaY: -300}));"
        drag = "".join(
            f"c.dispatchEvent(new PointerEvent('pointer{kind}', at({x}, {y})));"
            for kind, x, y in (("down", 40, 40), ("move", 65, 52), ("up", 65, 52))
        )
        for view, what in ((0, wheel), (1, drag), (1, wheel), (0, drag)):
            self.browser.execute_script(act + what, views[view])
            seen.append(pictures())
        self.press("0")
        seen.append(pictures())
        for one, other in seen:
            self.assertEqual(one, other)
        # All differ, but for the last, which shows the whole again.
        self.assertEqual([one for one, _ in seen].index(seen[-1][0]), 0)
        self.assertEqual(len({one for one, _ in seen}), len(seen) - 1)

    def test_a_canvas_has_a_pixel_for_each_of_the_screens_however_fine_it_is(self):
        self.addCleanup(self.browser.execute_cdp_cmd, "Emulation.clearDeviceMetricsOverride", {})
        for ratio in (1, 1.5, 2, 0.75):
            self.browser.execute_cdp_cmd(
                "Emulation.setDeviceMetricsOverride",
                {"width": 1440, "height": 1000, "deviceScaleFactor": ratio, "mobile": False},
            )
            self.open("panel=passes&pass=view_surfaces")
            self.wait_text(".texture-view h3", "view_position")
            sides = lambda: self.browser.execute_script(
                "const f = document.querySelector('.passes-panel .view-frame');"
                "const c = f.querySelector('canvas');"
                "const {width, height} = f.getBoundingClientRect();"
                "return [window.devicePixelRatio, c.width, c.height, width, height];"
            )
            self.wait(lambda: sides()[1:3] == [round(ratio * side) for side in sides()[3:]], str(sides()))
            self.assertEqual(sides()[0], ratio)
            # So a click is at the texel that it seems to be at.
            self.click_texel(".passes-panel .middle", WIDTH, HEIGHT, 61, 17)
            self.wait_text(".reading", "Texel (61, 17)")

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

    def texels_shown(self, view, width, height):
        """The colour in the middle of each texel of a picture that is shown whole, rows from the bottom."""
        return self.browser.execute_script(
            "const [view, width, height] = arguments;"
            "const c = document.querySelector(view + ' canvas');"
            "const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data, colors = [];"
            "const side = Math.min(c.width / width, c.height / height);"
            "for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) {"
            "  const row = Math.floor((height - y - 0.5) * side), column = Math.floor((x + 0.5) * side);"
            "  const at = 4 * (row * c.width + column);"
            "  colors.push([...d.slice(at, at + 4)].join(' '));"
            "} return colors;",
            view,
            width,
            height,
        )

    def test_where_there_is_nothing_every_way_of_showing_has_the_same_colour(self):
        recording, blobs = tiny_recording()
        attachments = {each["texture"]: each for each in recording["runs"][0]["attachments"]}
        for state, texture, nothing in (
            ("caster_map[sun]", "caster_position[sun]", lambda texel: texel[3] == 0),
            ("caster_map[sun]", "caster_normal[sun]", lambda texel: texel[:3] == (0, 0, 0)),
            ("shadow_map[sun]", "shadow_depth[sun]", lambda texel: texel[0] == 1),
            ("caustic_cells[sun]", "caustic_map[sun]", lambda texel: texel[0] == 0),
            ("caustic_cells[lamp]", "caustic_map[lamp]", lambda texel: texel[0] == 0),
        ):
            with self.subTest(texture=texture):
                attachment = attachments[texture]
                values = blobs.values(attachment["data"])
                size = attachment["width"], attachment["height"]
                channels = len(values) // (size[0] * size[1])
                texels = [values[i : i + channels] for i in range(0, len(values), channels)]
                self.open(f"panel=passes&pass={state}&texture={texture}")
                self.wait_text(".texture-view h3", texture)
                self.wait(lambda: len(set(self.texels_shown(".passes-panel .middle", *size))) > 1)
                shown = self.texels_shown(".passes-panel .middle", *size)
                self.assertEqual(
                    [color == "40 43 48 255" for color in shown], [nothing(texel) for texel in texels]
                )
                self.assertIn(True, map(nothing, texels))

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

    def test_values_without_a_description_are_named_by_their_place(self):
        self.open("panel=passes&texel=1,0", self.small)
        self.wait_text(".reading", "Texel (1, 0)")
        self.assertEqual(self.text(".reading"), "Texel (1, 0). x: 0.2; y: 0.4; z: 0.6; w: 1")

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
            current = [button.get_attribute("id") for button in self.all("nav [aria-current=page]")]
            self.assertEqual(current, [f"panel-{panel}"])
        self.press("?")
        self.wait(lambda: self.find("dialog[open]"))
        self.press(Keys.ESCAPE)
        self.press("p")
        self.wait(lambda: "projector" in self.find("html").get_attribute("class"))

    def test_zooming_keeps_what_lies_under_the_pointer(self):
        # Readings at a pointer that does not move and, beside it, a texel of the whole picture farther right.
        self.open("panel=passes&pass=view_surfaces")
        self.wait_text(".texture-view h3", "view_position")
        read = """
        const [x, down, width, height, turns] = arguments;
        const canvas = document.querySelector(".passes-panel .middle canvas");
        const box = canvas.getBoundingClientRect(), side = Math.min(box.width / width, box.height / height);
        const clientX = Math.round(box.left + (x + 0.5) * side);
        const clientY = Math.round(box.top + (down + 0.5) * side);
        const at = {bubbles: true, cancelable: true, clientX, clientY};
        const texel = (clientX) => {
          canvas.dispatchEvent(new PointerEvent("pointermove", {...at, clientX}));
          return document.querySelector(".passes-panel .reading").textContent.split(".")[0];
        };
        return [0, ...turns].map((deltaY) => {
          if (deltaY) canvas.dispatchEvent(new WheelEvent("wheel", {...at, deltaY}));
          return [texel(clientX), texel(clientX + side)];
        });
        """
        turns = [-500, -300, 200, -100, 700]
        for x, down in ((3, 2), (20, 40), (61, 17)):
            self.press("0")
            readings = self.browser.execute_script(read, x, down, WIDTH, HEIGHT, turns)
            here, beside = (f"Texel ({i}, {HEIGHT - 1 - down})" for i in (x, x + 1))
            self.assertEqual([at for at, _ in readings], [here] * 6)
            # At the first, and where the wheel has been turned back, the picture is as large as it was.
            self.assertEqual([right for _, right in readings], [beside] + [here] * 4 + [beside])

    def test_brackets_change_the_exposure_by_half_a_stop(self):
        self.open("panel=passes&pass=compose")
        stops = lambda: float(self.find("[data-control=exposure]").get_attribute("value"))
        for key, wanted in (("]", 0.5), ("]", 1), ("[", 0.5), ("[", 0), ("[", -0.5)):
            self.press(key)
            self.assertEqual(stops(), wanted)

    def test_a_light_is_chosen_and_left_to_the_page_again(self):
        self.open("pick=pixel:2,2")
        choice = "select[aria-label=Light] option"
        self.wait(lambda: len(self.all(choice)) == 3)
        for number, state in ((2, "light=1"), (1, "light=0"), (0, None)):
            self.all(choice)[number].click()
            self.wait(lambda: self.all(choice)[number].is_selected())
            if state:
                self.assertIn(state, self.browser.current_url)
            else:
                self.assertNotIn("light=", self.browser.current_url)

    def test_small_changes_are_in_the_address_and_not_in_the_history(self):
        self.open("panel=passes&pass=landing[lamp]&texel=1,1")
        length = self.browser.execute_script("return history.length")
        self.browser.execute_script(
            "document.body.dispatchEvent(new KeyboardEvent('keydown',"
            " {key: 'ArrowRight', shiftKey: true, bubbles: true}))"
        )
        self.wait(lambda: "texel=2" in self.browser.current_url)
        self.assertEqual(self.browser.execute_script("return history.length"), length)

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

    def test_the_lines_of_a_plot_go_from_its_first_step_to_its_last_and_its_points_lie_between_them(self):
        for sweep in tiny_recording()[0]["runs"][0]["sweeps"]:
            self.open(f"panel=sweep&setting={sweep['setting']}")
            self.wait_text(".sweep-panel h3", f"Error by {sweep['setting']}")
            lines, ticks, points = self.browser.execute_script(
                "const found = (selector) => [...document.querySelectorAll('.plot ' + selector)];"
                "const all = (selector, read) => found(selector).map(read);"
                "const numbers = (names) => (e) => names.map(name => Number(e.getAttribute(name)));"
                "return [all('.grid-line', numbers(['x1', 'x2', 'y1', 'y2'])),"
                " all('.tick', e => [e.textContent, ...numbers(['x'])(e)]),"
                " document.querySelector('.plot polyline').getAttribute('points')]"
            )
            steps = [x for text, x in ticks if text in sweep["values"]]
            self.assertEqual(len(steps), len(sweep["values"]))
            for x1, x2, y1, y2 in lines:
                self.assertEqual((x1, x2, y1), (steps[0], steps[-1], y2))
            shares = [text.replace("\u00a0", " ") for text, _ in ticks if "%" in text]
            decades = [math.log10(float(text.split(" ")[0]) / 100) for text in shares]
            self.assertEqual(len(lines), len(decades))
            # A straight line through the first and the last, by logarithms.
            (low, high), (bottom, top) = (decades[0], decades[-1]), (lines[0][2], lines[-1][2])
            y_of = lambda decade: bottom + (top - bottom) * (decade - low) / (high - low)
            for decade, line in zip(decades, lines):
                self.assertAlmostEqual(line[2], y_of(decade))
            wanted = [(x, y_of(math.log10(e))) for x, e in zip(steps, sweep["error"]) if e is not None]
            drawn = [tuple(map(float, point.split(","))) for point in points.split(" ")]
            self.assertEqual(len(drawn), len(wanted))
            for (x, y), (right, down) in zip(drawn, wanted):
                self.assertAlmostEqual(x, right)
                self.assertAlmostEqual(y, down)

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


if __name__ == "__main__":
    main()
