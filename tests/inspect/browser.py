"""Tests of pages in a real browser. They need Debian's chromium, chromium-driver and python3-selenium; they
are skipped where these are missing. SHOTS=DIR keeps screenshots."""
import os
import pathlib
import shutil
import tempfile
import unittest

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
    By = Keys = None
    MISSING = "no selenium (package python3-selenium)"

PANELS = ["picture", "passes", "path", "ledger", "sweep", "compare"]


def start_browser():
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1440,1000"):
        options.add_argument(argument)
    # Containers give shared memory 64 MB, too little for a page; files in its place are slow.
    if shutil.disk_usage("/dev/shm").total < 2**28:
        options.add_argument("--disable-dev-shm-usage")
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
        """Until the page shows all that it was asked for, and the condition holds."""

        def quietly(_):
            try:
                return self.find("main").get_attribute("aria-busy") == "false" and condition()
            except Exception:  # not there yet
                return False

        return WebDriverWait(self.browser, 60, 0.05).until(quietly, what)

    def go(self, state):
        """To another state of the page that is open, until all of it is shown."""
        self.browser.execute_async_script(
            "const [state, done] = arguments;"
            "if (decodeURIComponent(location.hash) === decodeURIComponent('#' + state)) return done();"
            "window.addEventListener('hashchange', () => done(), {once: true});"
            "location.hash = state;",
            state,
        )
        self.wait(lambda: True)

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
