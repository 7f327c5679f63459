// One picture for each value of a setting, with its error: move the slider and see what the setting buys.

class SweepPanel {
  constructor(page) {
    this.page = page;
    this.image = new ImageView("Picture at the chosen setting");
    this.controls = make("div", {class: "controls"});
    this.side = make("aside", {class: "side", "aria-label": "Error by setting"});
    this.element = make("div", {class: "panel sweep-panel"},
      make("div", {class: "middle"}, this.controls, this.image.element), this.side);
    this.turn = 0;
  }

  async show(state) {
    const turn = ++this.turn;
    const run = this.page.run();
    this.sweep = run.sweeps.find((sweep) => sweep.setting === state.setting) ?? run.sweeps[0];
    this.image.element.hidden = !this.sweep;
    if (!this.sweep) {
      this.controls.replaceChildren(paragraph("No pictures at other settings are in this page."));
      this.side.replaceChildren(make("ul", {}, run.left_out.map((line) => make("li", {}, line))));
      return;
    }
    this.at = clamp(state.value ?? this.sweep.values.length - 1, 0, this.sweep.values.length - 1);
    this.showControls(run);
    this.showErrors();
    const values = await run.blobs.get(this.sweep.pictures[this.at]);
    if (turn !== this.turn) return;
    if (values) this.paint(values);
    else this.image.clear();
  }

  paint(values) {
    const attachment = {width: this.sweep.width, height: this.sweep.height, kind: "display"};
    this.image.setImage(new Shading(attachment, values, "display").image());
  }

  showControls(run) {
    const {setting, values, error} = this.sweep;
    if (!this.slider || this.shown !== this.sweep) this.makeControls(run);
    this.slider.value = this.at;
    this.slider.setAttribute("aria-valuetext", `${setting} ${values[this.at]}`);
    const stated = error?.[this.at];
    this.says.replaceChildren(make("strong", {}, `${setting} ${values[this.at]}`),
      stated === null || stated === undefined ? ", error not stated" : `, error ${formatShare(stated)}`);
  }

  // Made once a sweep, so that a hand on the slider keeps hold of it.
  makeControls(run) {
    this.shown = this.sweep;
    const choice = make("select", {"aria-label": "Setting", onchange: (event) =>
      this.page.set({setting: event.target.value, value: null})}, run.sweeps.map((sweep) =>
      make("option", {value: sweep.setting, selected: sweep === this.sweep}, sweep.setting)));
    this.slider = make("input", {type: "range", min: 0, max: this.sweep.values.length - 1, step: 1, class: "long",
      "aria-label": "Value of the setting", oninput: (event) => this.page.set({value: Number(event.target.value)})});
    this.says = make("output", {class: "says"});
    this.controls.replaceChildren(make("label", {}, "Setting ", choice), this.slider, this.says);
  }

  showErrors() {
    const {setting, values, error} = this.sweep;
    this.side.replaceChildren(make("h3", {}, `Error by ${setting}`),
      errorPlot([{name: "error", values: error ?? []}], {labels: values, unit: "%", title: `Relative error by ${setting}`}),
      table([setting, "error", ""], values.map((value, i) => [value, error?.[i] === null || error?.[i] === undefined ? "–" : formatShare(error[i]),
        i === this.at ? "shown" : linkTo("show", () => this.page.set({value: i}))])));
  }

  step(dx, dy) {
    if (this.sweep) this.page.set({value: clamp(this.at + dx + dy, 0, this.sweep.values.length - 1)});
  }

  views() {
    return [{image: this.image, expose() {}}];
  }
}
