// The page: a bar with the panels, one panel below it, and the state that all share.

const kPanels = [
  {id: "picture", name: "Picture", make: (page) => new PicturePanel(page)},
  {id: "passes", name: "Passes", make: (page) => new PassesPanel(page)},
  {id: "path", name: "Path", make: (page) => new PathPanel(page)},
  {id: "ledger", name: "Ledger", make: (page) => new LedgerPanel(page)},
  {id: "sweep", name: "Settings", make: (page) => new SweepPanel(page)},
  {id: "compare", name: "A and B", make: (page) => new ComparePanel(page)},
];

class Page {
  constructor(recording) {
    this.recording = recording;
    this.state = stateOfAddress(location.hash);
    this.panels = new Map();
    this.help = makeHelp();
    this.place = make("main", {});
    this.bar = make("header", {});
    document.body.append(this.bar, this.place, this.help);
    window.addEventListener("hashchange", () => this.readAddress());
    listenToKeys(this);
    this.show();
  }

  run() {
    return this.recording.runs[this.state.run ?? 0] ?? this.recording.runs[0];
  }

  panel() {
    const wanted = kPanels.find((panel) => panel.id === this.state.panel) ?? kPanels[0];
    if (!this.panels.has(wanted.id)) this.panels.set(wanted.id, wanted.make(this));
    return this.panels.get(wanted.id);
  }

  // Changes what is shown. Each change can be taken back with the browser's back button, but for small ones.
  set(changes) {
    const small = Object.keys(changes).every((key) => ["texel", "value"].includes(key));
    Object.assign(this.state, changes);
    const address = addressOfState(this.state);
    if (small) window.history.replaceState(null, "", address);
    else window.history.pushState(null, "", address);
    this.show();
  }

  readAddress() {
    this.state = stateOfAddress(location.hash);
    this.show();
  }

  show() {
    const panel = this.panel();
    this.showBar();
    if (this.place.firstChild !== panel.element) this.place.replaceChildren(panel.element);
    // Screen readers wait while an element is busy; so do the tests.
    this.place.setAttribute("aria-busy", "true");
    const shown = Promise.resolve(panel.show(this.state)).catch((error) => this.sayFailure(error)).then(() => {
      if (this.shown === shown) this.place.setAttribute("aria-busy", "false");
    });
    this.shown = shown;
  }

  showBar() {
    const run = this.run();
    const focused = document.activeElement?.id;
    const current = kPanels.find((panel) => this.panel() === this.panels.get(panel.id));
    this.bar.replaceChildren(make("h1", {title: run.scene}, run.scene.split("/").at(-1)),
      make("nav", {"aria-label": "Panels"}, kPanels.map((panel, i) => make("button", {type: "button",
        id: `panel-${panel.id}`, "aria-current": panel === current ? "page" : "false",
        onclick: () => this.set({panel: panel.id})}, make("kbd", {}, String(i + 1)), ` ${panel.name}`))),
      ...this.runChoice(), make("span", {class: "device"}, `${run.device}. ${this.recording.program}`),
      make("button", {type: "button", id: "projector", title: "Large letters (P)", onclick: () => this.toggleProjector()}, "Projector"),
      make("button", {type: "button", id: "help", title: "Keys (?)", onclick: () => this.help.showModal()}, "?"));
    if (focused) document.getElementById(focused)?.focus();
  }

  runChoice() {
    const runs = this.recording.runs;
    if (runs.length < 2) return [];
    return [make("label", {}, "Run ", make("select", {id: "run", onchange: (event) => this.set({run: Number(event.target.value)})},
      runs.map((run, index) => make("option", {value: index, selected: run === this.run()}, run.name))))];
  }

  toggleProjector() {
    document.documentElement.classList.toggle("projector");
  }

  sayFailure(error) {
    console.error(error);
    this.place.prepend(make("p", {class: "failure", role: "alert"}, `This part of the page failed: ${error.message}`));
  }
}

function startPage() {
  const json = JSON.parse(document.getElementById("recording").textContent);
  const recording = new Recording(json);
  if (!recording.runs.length) {
    document.body.append(paragraph("This recording holds no run."));
    return null;
  }
  return new Page(recording);
}

startPage();
