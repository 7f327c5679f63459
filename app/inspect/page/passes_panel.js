// The pass graph, the chosen pass's attachments, and what is known of both.

class PassesPanel {
  constructor(page) {
    this.page = page;
    this.graph = new PassGraph((number) => page.set({pass: page.run().passes[number].label, texture: null, texel: null}));
    this.tabs = make("div", {class: "tabs", role: "group", "aria-label": "Textures that the pass wrote"});
    this.view = new TextureView("Texture", {controls: true, pick: (x, y) => page.set({texel: [x, y]})});
    this.history = new TexelHistory((i, j) => page.set({panel: "picture", pick: ["cell", i, j],
      light: page.run().passes[this.number].light ?? 0}));
    this.facts = make("div", {class: "facts"});
    this.meaning = make("p", {class: "meaning"});
    this.element = make("div", {class: "panel passes-panel"}, this.graph.element,
      make("div", {class: "middle"}, this.tabs, this.meaning, this.view.element),
      make("aside", {class: "side", "aria-label": "About the pass"}, this.history.element, this.facts));
  }

  async show(state) {
    const run = this.page.run();
    if (!run.passes.length) return;
    this.number = run.byLabel.get(state.pass) ?? firstWithData(run);
    const attachments = run.attachmentsOf(this.number);
    const attachment = attachments.find((one) => one.label === state.texture) ?? attachments[0] ?? null;
    this.graph.show(run, this.number);
    this.showFacts(run);
    this.showTabs(attachments, attachment);
    const history = this.history.show(run, this.number, state.texel);
    await this.view.show(run, attachment, "this pass writes no texture that is kept");
    if (this.view.attachment === attachment) this.showTexel(state.texel);
    await history;
  }

  showFacts(run) {
    this.facts.replaceChildren(...passFacts(run, this.number, {
      pass: (number) => this.page.set({pass: run.passes[number].label, texture: null, texel: null}),
      texture: (one) => this.page.set({pass: run.passes[one.pass].label, texture: one.label}),
    }));
  }

  showTabs(attachments, chosen) {
    this.tabs.replaceChildren(...attachments.map((one) => make("button", {type: "button",
      "aria-pressed": one === chosen ? "true" : "false", onclick: () => this.page.set({texture: one.label})},
    one.name)));
    this.meaning.textContent = chosen ?
      `${chosen.format}, ${chosen.width} × ${chosen.height}. ${chosen.meaning}` : "";
  }

  showTexel(texel) {
    const view = this.view;
    if (!texel || !view.values) {
      view.image.setMarks([]);
      return;
    }
    const [x, y] = texel;
    view.rest(x, y);
    view.image.setMarks([{x0: x, y0: y, x1: x + 1, y1: y + 1, color: "#fff"}]);
    if (!view.image.shows(x, y)) view.image.centerOn(x, y);
  }

  // Up and down: passes. Left and right: the textures of a pass.
  step(dx, dy) {
    const run = this.page.run();
    if (dy) {
      const number = clamp(this.number + dy, 0, run.passes.length - 1);
      this.page.set({pass: run.passes[number].label, texture: null, texel: null});
      return;
    }
    const attachments = run.attachmentsOf(this.number);
    const at = attachments.indexOf(this.view.attachment);
    const next = attachments[clamp(at + dx, 0, attachments.length - 1)];
    if (next) this.page.set({texture: next.label});
  }

  moveTexel(dx, dy) {
    const {attachment} = this.view;
    if (!attachment) return;
    const [x, y] = this.page.state.texel ?? [attachment.width >> 1, attachment.height >> 1];
    this.page.set({texel: [clamp(x + dx, 0, attachment.width - 1), clamp(y + dy, 0, attachment.height - 1)]});
  }

  views() {
    return [this.view];
  }
}

function firstWithData(run) {
  const number = run.passes.findIndex((pass, index) => run.attachmentsOf(index).some((one) => one.data));
  return Math.max(number, 0);
}
