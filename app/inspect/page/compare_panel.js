// A and B: which pass went wrong first, and what differs in it.

class ComparePanel {
  constructor(page) {
    this.page = page;
    this.list = make("nav", {class: "compare-list", "aria-label": "Attachments of both runs"});
    const pick = (x, y) => page.set({texel: [x, y]});
    this.a = new TextureView("A", {pick, controls: true});
    this.b = new TextureView("B", {pick, likeView: this.a});
    this.difference = new TextureView("Difference", {pick});
    ImageView.linkAll([this.a.image, this.b.image, this.difference.image]);
    this.summary = make("div", {class: "summary", "aria-live": "polite"});
    this.element = make("div", {class: "panel compare-panel"}, this.list, make("div", {class: "middle"}, this.summary, this.a.controls,
      make("div", {class: "three"}, this.a.element, this.b.element, this.difference.element)));
    this.found = new Map();
    this.turn = 0;
  }

  async show(state) {
    const [a, b] = this.page.recording.runs;
    if (!b) return this.summary.replaceChildren(paragraph("This page holds one run. With two, they are compared here."));
    this.pairs ??= matchedAttachments(a, b);
    const chosen = this.pairs.find((pair) => pair.key === state.compare) ?? this.firstDifferent() ?? this.pairs[0];
    const changed = chosen !== this.chosen;
    this.chosen = chosen;
    if (!this.rows) this.showList();
    this.markChosen();
    if (changed) await this.showPair(a, b, chosen, ++this.turn);
    if (state.texel) this.showTexel(...state.texel);
  }

  firstDifferent() {
    return this.pairs.find((pair) => pair.state !== "equal");
  }

  // Those that differ first, in the order the passes ran; then the equal ones.
  showList() {
    const different = this.pairs.filter((pair) => pair.state !== "equal");
    const equal = this.pairs.filter((pair) => pair.state === "equal");
    this.rows = new Map();
    const rows = (pairs) => make("ul", {}, pairs.map((pair) => {
      const says = make("span", {class: "pair-says"}, differenceText(pair, null));
      const button = make("button", {type: "button", class: "pair", onclick: () => this.page.set({compare: pair.key, texel: null})},
        make("strong", {}, pair.label), ` ${pair.texture} `, says);
      this.rows.set(pair, {button, says});
      return make("li", {}, button);
    }));
    const first = different[0];
    this.list.replaceChildren(
      paragraph(first ? ["First to differ: ", make("strong", {class: "first"}, first.label)] : "All attachments are equal."),
      rows(different), folded(`Equal: ${plural(equal.length, "attachment")}`, rows(equal)));
    this.measureAll(different);
  }

  // One after the other, so that the page stays quick.
  async measureAll(pairs) {
    for (const pair of pairs) {
      this.rows.get(pair).says.textContent = differenceText(pair, await this.measure(pair));
      await new Promise((resolve) => setTimeout(resolve));
    }
  }

  async measure(pair) {
    if (pair.state !== "differs") return null;
    if (!this.found.has(pair)) {
      const [a, b] = await Promise.all(this.page.recording.runs.slice(0, 2).map((run, i) => run.values(i ? pair.b : pair.a)));
      const {most, texel, count, missing} = a && b && a.length === b.length && sameSize(pair) ? differenceOf(pair.a, a, b) : {missing: true};
      this.found.set(pair, {most, texel, count, missing});
    }
    return this.found.get(pair);
  }

  markChosen() {
    for (const [pair, {button}] of this.rows) button.setAttribute("aria-current", pair === this.chosen ? "true" : "false");
    this.rows.get(this.chosen)?.button.scrollIntoView({block: "nearest"});
  }

  async showPair(a, b, pair, turn) {
    if (!pair) return;
    const found = await this.measure(pair);
    if (turn !== this.turn) return;
    this.summary.replaceChildren(make("h2", {}, `${pair.label}: ${pair.texture}`),
      make("p", {}, differenceText(pair, found), ". ", found?.texel ?
        linkTo("Show that texel", () => this.page.set({texel: found.texel})) : "",
      pair === this.firstDifferent() ? " This is the first pass, in the order they ran, that differs." : ""));
    await this.a.show(a, pair.a, `only in ${b.name}`);
    await this.b.show(b, pair.b, `only in ${a.name}`);
    if (turn === this.turn) await this.showDifference(pair);
  }

  // A texture of its own, made here: one channel, the largest difference of a texel's channels.
  async showDifference(pair) {
    const [a, b] = [this.a.values, this.b.values];
    if (!a || !b) return this.difference.show(null, null, "it needs both");
    if (!sameSize(pair)) return this.difference.show(null, null, "it needs two of one size");
    const {differences} = differenceOf(pair.a, a, b);
    const attachment = {...pair.a, id: -1, label: "|A − B|", kind: "difference", codes: null, data: {count: differences.length},
      channels: [{name: "difference", meaning: "largest difference of the channels", unit: ""}]};
    await this.difference.show({values: async () => differences}, attachment);
    this.difference.change({mode: "log:0", range: null});
  }

  showTexel(x, y) {
    for (const view of [this.a, this.b, this.difference]) {
      if (!view.values) continue;
      view.rest(x, y);
      view.image.setMarks([{x0: x, y0: y, x1: x + 1, y1: y + 1, color: "#fff"}]);
    }
    if (this.a.values && !this.a.image.shows(x, y)) this.a.image.centerOn(x, y);
  }

  step(dx, dy) {
    const order = [...this.rows?.keys() ?? []];
    const next = order[clamp(order.indexOf(this.chosen) + dx + dy, 0, order.length - 1)];
    if (next) this.page.set({compare: next.key, texel: null});
  }

  moveTexel(dx, dy) {
    const one = this.chosen?.a ?? this.chosen?.b;
    if (!one) return;
    const [x, y] = this.page.state.texel ?? [one.width >> 1, one.height >> 1];
    this.page.set({texel: [clamp(x + dx, 0, one.width - 1), clamp(y + dy, 0, one.height - 1)]});
  }

  views() {
    return [this.a, this.b, this.difference];
  }
}
