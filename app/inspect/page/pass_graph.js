// The passes of a run in the order they ran, with bars for their times and arcs from each pass to those that read
// what it wrote. Below them what did not run, and why.

const kRowHeight = 26;
const kArcsWidth = 74;

class PassGraph {
  // `choose(passNumber)`: a pass was chosen.
  constructor(choose) {
    this.choose = choose;
    this.element = make("nav", {class: "pass-graph", "aria-label": "Passes in the order they ran"});
  }

  show(run, chosen) {
    if (run !== this.run) this.build(run);
    this.rows.forEach((row, number) => {
      row.setAttribute("aria-current", number === chosen ? "true" : "false");
    });
    this.drawArcs(chosen);
    const row = this.rows[chosen];
    if (!row) return;
    if (this.element.contains(document.activeElement) && this.rows.includes(document.activeElement)) row.focus();
    row.scrollIntoView({block: "nearest"});
  }

  build(run) {
    this.run = run;
    this.edges = edgesOf(run);
    const longest = Math.max(...run.passes.map((pass) => pass.milliseconds ?? 0), 1e-9);
    this.rows = run.passes.map((pass, number) => this.row(pass, number, longest));
    this.arcs = draw("svg", {class: "arcs", width: kArcsWidth, height: run.passes.length * kRowHeight,
      "aria-hidden": "true"});
    const total = run.passes.reduce((time, pass) => time + (pass.milliseconds ?? 0), 0);
    this.element.replaceChildren(
      make("p", {class: "note"}, `${plural(run.passes.length, "pass", "passes")}, ${formatMilliseconds(total)}. `,
        "Arcs lead from a pass to those that read its textures."),
      make("div", {class: "graph-rows"}, this.arcs, make("div", {class: "rows"}, this.rows)),
      ...this.rest(run));
  }

  row(pass, number, longest) {
    const share = (pass.milliseconds ?? 0) / longest;
    return make("button", {type: "button", class: "pass-row", title: pass.purpose,
      onclick: () => this.choose(number)},
    make("span", {class: "time-bar", style: `width:${(100 * share).toFixed(1)}%`}),
    make("span", {class: "pass-label"}, pass.label),
    make("span", {class: "pass-time"}, pass.left_out ? "cleared" : formatMilliseconds(pass.milliseconds)));
  }

  rest(run) {
    const list = (entries) => make("ul", {class: "reasons"}, entries.map(([name, reason]) =>
      make("li", {}, make("strong", {}, name), ` ${reason}`)));
    const parts = [];
    if (run.skipped.length) {
      parts.push(folded(`Did not run: ${plural(run.skipped.length, "pass", "passes")}`,
        list(run.skipped.map((skipped) => [skipped.pass, skipped.reason]))));
    }
    const [on, off] = [true, false].map((active) => run.effects.filter((effect) => effect.active === active));
    const effects = (chosen) => list(chosen.map((effect) => [effect.name, effect.reason]));
    if (on.length) parts.push(folded(`Effects in use: ${on.length}`, effects(on)));
    if (off.length) parts.push(folded(`Effects not in use: ${off.length}`, effects(off)));
    return parts;
  }

  // Those of the chosen pass are drawn last, so they lie on top.
  drawArcs(chosen) {
    const touches = (edge) => edge.from === chosen || edge.to === chosen;
    const ordered = [...this.edges].sort((a, b) => touches(a) - touches(b));
    this.arcs.replaceChildren(...ordered.map((edge) => {
      const [top, bottom] = [edge.from, edge.to].map((number) => (number + 0.5) * kRowHeight);
      const reach = Math.min(kArcsWidth - 6, 10 + 7 * Math.sqrt(edge.to - edge.from) * 1.6);
      const [right, left] = [kArcsWidth - 2, kArcsWidth - 2 - reach];
      const kind = edge.from === chosen ? "arc gives" : edge.to === chosen ? "arc takes" : "arc";
      return draw("path", {class: kind,
        d: `M${right} ${top} C${left} ${top}, ${left} ${bottom}, ${right} ${bottom}`});
    }));
  }
}

// One edge a pair of passes, however many textures pass between them.
function edgesOf(run) {
  const edges = [];
  run.passes.forEach((pass, to) => {
    const makers = new Set((pass.reads ?? []).flatMap((texture) => run.makersOf(to, texture)));
    for (const from of makers) edges.push({from, to});
  });
  return edges;
}
