// The way of one grid vertex's light through the scene, in a section, and how each estimator came to its end.

class PathPanel {
  constructor(page) {
    this.page = page;
    this.drawing = new SectionDrawing();
    this.head = make("div", {class: "controls"});
    this.side = make("aside", {class: "side", "aria-label": "The way in numbers"});
    this.key = make("p", {class: "key"}, make("span", {class: "line-key outside"}), " light outside ",
      make("span", {class: "line-key inside"}), " inside ", make("span", {class: "line-key refractor"}), " glass, water ",
      make("span", {class: "line-key mirror"}), " mirror ", make("span", {class: "line-key receiver"}), " receiver");
    this.element = make("div", {class: "panel path-panel"},
      make("div", {class: "middle"}, this.head, this.drawing.element, this.key), this.side);
    this.turn = 0;
  }

  async show(state) {
    const turn = ++this.turn;
    const run = this.page.run();
    const index = state.light ?? run.lights.findIndex((light) => light.paths);
    const light = run.lights[index] ?? run.lights[0];
    if (!light?.paths?.vertices?.length) return this.sayMissing(run, light);
    this.light = light;
    const links = new LightLinks(run, light);
    const wanted = state.vertex ?? pickedVertex(state) ?? middleVertex(light);
    this.number = links.nearestPath(...wanted);
    this.estimator = light.paths.estimators[state.estimator] ? state.estimator : Object.keys(light.paths.estimators)[0];
    const path = light.paths.estimators[this.estimator]?.[this.number];
    this.showHead(run, index, wanted);
    this.showNumbers(path);
    if (!path || path.points.length < 1) return;
    await this.drawSection(run, path, turn);
  }

  sayMissing(run, light) {
    this.drawing.plane = null;
    this.drawing.svg.replaceChildren();
    this.head.replaceChildren(paragraph(light ? `No ways of ${light.name} are in this page.` : "This run has no light."));
    this.side.replaceChildren(make("ul", {}, run.left_out.map((line) => make("li", {}, line))));
  }

  showHead(run, index, wanted) {
    const {vertices, estimators} = this.light.paths;
    const [x, y] = vertices[this.number];
    const exact = x === wanted[0] && y === wanted[1];
    const options = (entries) => entries.map(([value, text, selected]) => make("option", {value, selected}, text));
    const lights = make("select", {onchange: (event) => this.page.set({light: Number(event.target.value), vertex: null})},
      options(run.lights.map((light, i) => [i, light.name, light === this.light])));
    const vertex = make("select", {onchange: (event) => this.page.set({vertex: vertices[Number(event.target.value)]})},
      options(vertices.map((one, i) => [i, `(${one.join(", ")}), ${estimators[this.estimator]?.[i]?.status ?? ""}`, i === this.number])));
    const estimator = make("select", {onchange: (event) => this.page.set({estimator: event.target.value})},
      options(Object.keys(estimators).map((name) => [name, name, name === this.estimator])));
    this.head.replaceChildren(...run.lights.length > 1 ? [make("label", {}, "Light ", lights)] : [],
      make("label", {}, "Grid vertex ", vertex), make("label", {}, "Estimator ", estimator),
      make("button", {type: "button", onclick: () => this.lookAtLanding()}, "Look at the landing"),
      make("button", {type: "button", onclick: () => this.drawing.fit()}, "Whole way"),
      make("p", {class: "note"}, exact ? `The way of vertex (${x}, ${y}).` :
        `Vertex (${wanted.join(", ")}) is not recorded; this is the nearest that is, (${x}, ${y}).`));
  }

  async drawSection(run, path, turn) {
    const points = path.points.map((point) => point.at);
    const {plane, along} = planeOfWay(this.light, points);
    const cuts = [];
    for (const mesh of run.meshes) {
      const [positions, indices] = await Promise.all([mesh.positions, mesh.indices].map((a) => run.blobs.get(a)));
      if (positions && indices) cuts.push({mesh, segments: cutMesh(plane, positions, indices)});
    }
    if (turn !== this.turn) return;
    const reach = Math.max(...points.map((point) => lengthOf(minus(point, points[0]))), 1e-3);
    // The light's own place would shrink the rest to a dot, so the way begins a piece before the caster.
    const came = sum(points[0], times(along, -0.45 * reach));
    this.path = path;
    this.drawing.show({plane, cuts, path, came});
    this.sayAside(run, plane, points);
  }

  sayAside(run, plane, points) {
    const aside = Math.max(...points.map((point) => Math.abs(plane.distance(point))));
    const missing = run.meshes.filter((mesh) => !mesh.positions).map((mesh) => mesh.name);
    this.aside.replaceChildren(
      aside > 1e-4 ? paragraph(`The way leaves the plane by up to ${formatNumber(aside)} m; it is drawn as seen across it.`) : "",
      missing.length ? paragraph(`Not cut, since the page does not hold them: ${missing.join(", ")}.`) : "");
  }

  showNumbers(path) {
    this.aside = make("div", {class: "note"});
    const estimators = Object.entries(this.light.paths.estimators)
      .map(([name, paths]) => ({name, path: paths[this.number]})).filter((one) => one.path);
    this.side.replaceChildren(...path ? this.surfaces(path) : [], this.aside, ...this.errors(estimators), ...this.iterates(path));
  }

  surfaces(path) {
    return [make("h3", {}, `Surfaces it meets: ${path.status ?? ""}`),
      table(["", "surface", "at, metres", "then"], path.points.map((point, i) =>
        [String(i + 1), point.surface, formatPoint(point.at), i + 1 < path.points.length ? point.medium ?? "" : ""]))];
  }

  // A way has a search for each surface that is looked for in a map: a plot for each.
  errors(estimators) {
    const searches = new Set(estimators.flatMap(({path}) => (path.iterates ?? []).map(searchOf)));
    const plots = [...searches].flatMap((search) => this.searchPlot(search, estimators));
    const first = estimators[0]?.path.points.at(-1)?.at;
    return [...plots, table(["estimator", "steps", "ends as", `away from ${estimators[0]?.name ?? "the first"}`],
      estimators.map(({name, path}) => [name, String(path.iterates?.length ?? 0), path.status ?? "",
        first && path.points.length ? formatWithUnit(lengthOf(minus(path.points.at(-1).at, first)), "m") : "–"]))];
  }

  searchPlot(search, estimators) {
    const lines = estimators.map(({name, path}) => ({name, values: (path.iterates ?? [])
      .filter((iterate) => searchOf(iterate) === search).map((iterate) => iterate.error ?? null)}));
    const longest = Math.max(...lines.map((line) => line.values.length));
    const labels = Array.from({length: longest}, (_, i) => String(i + 1));
    return [make("h3", {}, `Error at each step${search ? ` of the search for the ${search}` : ""}`),
      errorPlot(lines, {labels, unit: "m", title: `Error at each step of each estimator, metres ${search}`})];
  }

  iterates(path) {
    if (!path?.iterates?.length) return [];
    return [make("h3", {}, `Iterates of ${this.estimator}`), table(["iterate", "distance, m", "error, m", "at, metres"],
      path.iterates.map((one) => [one.label, formatNumber(one.distance), formatNumber(one.error), formatPoint(one.at)]))];
  }

  lookAtLanding() {
    const last = this.path?.points.at(-1);
    if (last) this.drawing.lookAt(last.at, 12);
  }

  // To the next vertex of the lattice.
  step(dx, dy) {
    const vertices = this.light?.paths?.vertices;
    if (!vertices) return;
    const [x, y] = vertices[this.number];
    const ahead = vertices.filter(([a, b]) => (dx ? b === y && (a - x) * dx > 0 : a === x && (y - b) * dy > 0));
    ahead.sort((a, b) => Math.hypot(a[0] - x, a[1] - y) - Math.hypot(b[0] - x, b[1] - y));
    if (ahead.length) this.page.set({vertex: ahead[0]});
  }

  views() {
    return [{image: this.drawing, expose() {}}];
  }
}

// "landing" of "landing 3"; "" of "iterate 3".
function searchOf(iterate) {
  const search = iterate.label.replace(/ ?\d+$/, "");
  return search === "iterate" ? "" : search;
}

function pickedVertex(state) {
  return ["vertex", "cell"].includes(state.pick?.[0]) ? state.pick.slice(1) : null;
}

// A vertex off the axis whose light lands: there is more to see than straight through.
function middleVertex(light) {
  const {vertices, estimators} = light.paths;
  const paths = Object.values(estimators)[0] ?? [];
  const landed = vertices.filter((vertex, i) => (paths[i]?.points.length ?? 0) > 2);
  return landed[Math.floor(landed.length / 3)] ?? vertices[0];
}
