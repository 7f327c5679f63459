"""All that the inspect page shows of a made recording (tiny_recording.py), view by view: its words, a hash of
its elements with their titles and exact values, of each picture that is painted, and the marks on it.
page_shown.txt keeps them; with --update it is written anew."""
import itertools
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "program")]
from browser import PANELS, BrowserTest  # noqa: E402
from page_file import page  # noqa: E402
from program import main  # noqa: E402
from tiny_recording import tiny_recording  # noqa: E402

KEPT = HERE / "page_shown.txt"
# Before the page's own script: what is painted, and where marks stand, in texels.
WATCH = """
(() => {
if (window.hashOf) return;
window.hashOf = (values) => {
  let hash = 2166136261;
  for (const value of values) hash = Math.imul(hash ^ value, 16777619) >>> 0;
  return hash.toString(16);
};
const {putImageData, drawImage, strokeRect, fillRect} = CanvasRenderingContext2D.prototype;
Object.assign(CanvasRenderingContext2D.prototype, {
  putImageData(image, ...at) {
    this.canvas.picture = `${image.width} x ${image.height} ${hashOf(image.data)}`;
    putImageData.call(this, image, ...at);
  },
  drawImage(source, left, top, width, height) {
    const [scale, rows] = [width / source.width, source.height];
    const square = Math.abs(scale - height / rows) < 1e-9;
    this.canvas.shown = {picture: source.picture, left, top, scale, rows, square, marks: []};
    drawImage.call(this, source, left, top, width, height);
  },
  strokeRect(x, y, width, height) {
    const shown = this.canvas.shown;
    const right = (x + width / 2 - shown.left) / shown.scale;
    const at = [right, shown.rows - (y + height / 2 - shown.top) / shown.scale];
    shown.marks.push(`${at.map((v) => v.toFixed(2))} ${this.lineWidth} ${this.strokeStyle}`);
    strokeRect.call(this, x, y, width, height);
  },
  fillRect(x, y, width, height) {
    const {shown} = this.canvas;
    const right = ((x - shown.left) / shown.scale).toFixed(2);
    shown.marks.push(`filled ${right} ${this.fillStyle} ${this.globalAlpha}`);
    fillRect.call(this, x, y, width, height);
  },
});
})();
"""
# Reads what is shown, once the page says that all is and it has been still for some frames.
SHOW = """
const [state, act, done] = arguments;
const words = () => {
  const copy = document.querySelector("main").cloneNode(true);
  for (const one of copy.querySelectorAll("[style]")) one.removeAttribute("style");
  const texts = [];
  const walk = document.createTreeWalker(document.querySelector("main"), NodeFilter.SHOW_TEXT);
  while (walk.nextNode()) {
    if (walk.currentNode.parentElement.checkVisibility()) texts.push(walk.currentNode.data);
  }
  const said = ({shown}) => shown ? `${shown.picture} ${shown.square} ${shown.marks.join("; ")}` : "nothing";
  const canvases = [...document.querySelectorAll("main canvas")].filter((one) => one.checkVisibility());
  const html = hashOf([...copy.innerHTML].map((c) => c.codePointAt(0)));
  return JSON.stringify({text: texts.join("|"), html, pictures: canvases.map(said), address: location.hash});
};
const frame = () => new Promise((then) => requestAnimationFrame(() => setTimeout(then, 15)));
(async () => {
  location.hash = state;
  await frame();
  if (act) new Function(act)();
  let before = "", still = 0;
  for (let i = 0; i < 200 && still < 3; i++) {
    await frame();
    const now = words();
    const busy = document.querySelector("main").getAttribute("aria-busy") === "true";
    still = !busy && now === before ? still + 1 : 0;
    before = now;
  }
  done(before);
})().catch((error) => done(JSON.stringify({text: String(error), html: "", pictures: [], address: ""})));
"""


def choose(selector, value):
    return (f"const e = document.querySelector({json.dumps(selector)}); e.value = {json.dumps(value)};"
            "for (const kind of ['input', 'change']) e.dispatchEvent(new Event(kind, {bubbles: true}));")


def key(name, shift=False):
    event = json.dumps({"key": name, "shiftKey": shift, "bubbles": True})
    return f"document.body.dispatchEvent(new KeyboardEvent('keydown', {event}))"


def pointer(kind, right, down, canvas=0):
    """At a place of a canvas, in shares of it."""
    return (f"{{ const e = document.querySelectorAll('main canvas')[{canvas}], b = e.getBoundingClientRect();"
            "e.setPointerCapture = () => {};"
            f"e.dispatchEvent(new PointerEvent('pointer{kind}', {{bubbles: true,"
            f"clientX: b.left + {right} * b.width, clientY: b.top + {down} * b.height}})); }}")


def views(run):
    """(state, what is done there)."""
    for light, pick in itertools.product(("", "&light=0", "&light=1"), (
            "", "pixel:2,2", "pixel:3,2", "pixel:5,5", "pixel:0,0", "pixel:48,20", "texel:7,7", "texel:3,3",
            "texel:0,1", "vertex:3,3", "vertex:20,14", "cell:4,5", "cell:1,1")):
        yield f"panel=picture&pick={pick}{light}", ""
    names = {i: each["label"] for i, each in enumerate(run["passes"])}
    for attachment in run["attachments"]:
        state = f"panel=passes&pass={names[attachment['pass']]}&texture={attachment.get('label', '')}"
        yield state + "&texel=1,1", ""
        yield state + "&texel=5,1", ""
    for label, modes in (("landing[sun]", ["light", "color", "linear:1", "log:0", "position", "normal"]),
                         ("shadow_map[sun]", ["log:0"]), ("compose", ["linear:2", "log:1", "light"]),
                         ("landing[lamp]", ["linear:0", "linear:3", "position"])):
        for mode in modes:
            yield f"panel=passes&pass={label}&texel=2,2", choose("[data-control=mode]", mode)
    for control, value in (("low", "0.25"), ("high", "0.5"), ("exposure", "2"), ("exposure", "-3.5")):
        yield "panel=passes&pass=compose", choose("[data-control=mode]", "light" if control == "exposure" else
                                                 "linear:0") + choose(f"[data-control={control}]", value)
    for name in ("+", "-", "0", "ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight", "[", "]"):
        yield "panel=passes&pass=caster_map[sun]&texel=3,4", key(name)
    for name in ("ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight"):
        yield "panel=passes&pass=caster_map[sun]&texel=3,4", key(name, shift=True)
    for label in ("caster_map[sun]", "landing[lamp]", "compose"):
        yield f"panel=passes&pass={label}", pointer("move", 0.31, 0.12)
        yield f"panel=passes&pass={label}", pointer("down", 0.11, 0.13) + pointer("up", 0.11, 0.13)
    for vertex, estimator in itertools.product(("19,15", "20,14", "3,3"), ("", "paper", "newton", "secant")):
        yield f"panel=path&light=0&vertex={vertex}&estimator={estimator}", ""
    yield "panel=path&light=1", ""
    for number in (0, 1):
        yield f"panel=ledger&run={number}", ""
        for value in (0, 1, 2, 9):
            yield f"panel=sweep&value={value}&run={number}", ""
    for sweep in run["sweeps"]:
        yield f"panel=sweep&setting={sweep['setting']}", ""
    yield "panel=compare", ""
    for press in ("ArrowDown", "ArrowDown", "ArrowRight", "ArrowUp"):
        yield "", key(press)
    yield "panel=compare&texel=10,12", ""


class Shown(BrowserTest):
    maxDiff = None

    @classmethod
    def make_pages(cls):
        cls.recording = tiny_recording()
        cls.page.write_text(page(*cls.recording, title="shown"), encoding="utf-8")

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": WATCH})
        cls.browser.set_script_timeout(60)

    def shown(self, state, act):
        said = json.loads(self.browser.execute_async_script(SHOW, state, act))
        lines = [f"# {state} {act[-90:]}".rstrip(), said["address"], " ".join(said["text"].split())]
        return lines + [f"elements {said['html']}"] + [f"picture {each}" for each in said["pictures"]]

    def lines(self):
        return [line for view in views(self.recording[0]["runs"][0]) for line in self.shown(*view)]

    def test_what_every_view_shows_is_what_is_kept(self):
        now, kept, view, wrong = self.lines(), KEPT.read_text(encoding="utf-8").splitlines(), "", []
        for line, before in itertools.zip_longest(now, kept, fillvalue=""):
            view = before if before.startswith("# ") else view
            if line != before:
                wrong += [f"in {view}", f"  kept: {before}", f"  now:  {line}"]
        if wrong:
            self.fail(f"page_shown_test.py --update writes the list anew; {len(wrong) // 3} lines differ:"
                      "\n" + "\n".join(wrong[:18]))

    def test_every_panel_is_among_the_views(self):
        states = [state for state, _ in views(self.recording[0]["runs"][0])]
        seen = {state.split("&")[0].removeprefix("panel=") for state in states}
        self.assertLessEqual(set(PANELS), seen)


def update():
    Shown.setUpClass()
    test = Shown()
    test.setUp()
    KEPT.write_text("\n".join(test.lines()) + "\n", encoding="utf-8")
    Shown.tearDownClass()


if __name__ == "__main__":
    if "--update" in sys.argv:
        update()
    else:
        main()
