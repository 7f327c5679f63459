// The section as a drawing: what the plane cuts, the way of the light, and an estimator's iterates. Can be zoomed
// and moved; lines and letters keep their size.

const kRoleClasses = {"refractor": "refractor", "mirror": "mirror", "receiver": "receiver", "thin pane": "pane"};

class SectionDrawing {
  constructor() {
    this.svg = draw("svg", {class: "section", role: "img", tabindex: 0, "aria-label": "Section through the scene"});
    this.element = make("div", {class: "section-frame"}, this.svg);
    new ResizeObserver(() => this.redraw()).observe(this.element);
    this.listen();
  }

  // `cuts`: [{mesh, segments}]; `path`: a Path of the recording; `came`: a point that the light comes from.
  show({plane, cuts, path, came}) {
    Object.assign(this, {plane, cuts, path, came});
    this.fit();
  }

  fit() {
    if (!this.plane) return;
    const points = this.path.points.map((point) => this.plane.coordinates(point.at));
    const [xs, ys] = [0, 1].map((axis) => points.map((point) => point[axis]));
    const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    this.middle = [(left + right) / 2, (low + high) / 2];
    this.extent = 1.7 * Math.max(right - left, high - low, 1e-6);
    this.zoom = 1;
    this.redraw();
  }

  reset() {
    this.fit();
  }

  zoomBy(factor, around = this.middle) {
    if (!this.plane) return;
    this.zoom = clamp(this.zoom * factor, 0.02, 1e6);
    this.middle = this.middle.map((v, axis) => around[axis] + (v - around[axis]) / factor);
    this.redraw();
  }

  // The middle of the drawing goes to a point of the scene.
  lookAt(point, zoom) {
    this.middle = this.plane.coordinates(point);
    this.zoom = zoom;
    this.redraw();
  }

  listen() {
    let drag = null;
    this.svg.addEventListener("pointerdown", (event) => {
      drag = {x: event.clientX, y: event.clientY, middle: this.middle};
      this.svg.setPointerCapture(event.pointerId);
    });
    this.svg.addEventListener("pointermove", (event) => {
      if (!drag || !this.plane) return;
      const scale = this.scale();
      this.middle = [drag.middle[0] - (event.clientX - drag.x) / scale, drag.middle[1] + (event.clientY - drag.y) / scale];
      this.redraw();
    });
    this.svg.addEventListener("pointerup", () => { drag = null; });
    this.svg.addEventListener("wheel", (event) => {
      event.preventDefault();
      if (!this.plane) return;
      this.zoomBy(Math.exp(-event.deltaY / 400), this.sceneOf(event));
    }, {passive: false});
  }

  scale() {
    return this.zoom * Math.min(this.width, this.height) / this.extent;
  }

  sceneOf(event) {
    const box = this.svg.getBoundingClientRect();
    const scale = this.scale();
    return [this.middle[0] + (event.clientX - box.left - this.width / 2) / scale,
      this.middle[1] - (event.clientY - box.top - this.height / 2) / scale];
  }

  screen([x, y]) {
    const scale = this.scale();
    return [this.width / 2 + (x - this.middle[0]) * scale, this.height / 2 - (y - this.middle[1]) * scale];
  }

  redraw() {
    const box = this.element.getBoundingClientRect();
    [this.width, this.height] = [box.width, box.height];
    if (!this.plane || !this.width) return;
    this.svg.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    this.svg.replaceChildren(...this.cuts.map((cut) => this.cutPath(cut)), ...this.wayLines().filter(Boolean),
      ...this.iterateDots(), ...this.pointLabels(), ...this.ruler());
  }

  cutPath({mesh, segments}) {
    let d = "";
    // What lies far beside the drawing is left out: browsers slow down at huge coordinates.
    const far = 4 * (this.width + this.height);
    for (let s = 0; s < segments.length; s += 4) {
      const [x0, y0] = this.screen([segments[s], segments[s + 1]]);
      const [x1, y1] = this.screen([segments[s + 2], segments[s + 3]]);
      if (Math.min(x0, x1) > far || Math.max(x0, x1) < -far || Math.min(y0, y1) > far || Math.max(y0, y1) < -far) continue;
      d += `M${x0.toFixed(1)} ${y0.toFixed(1)}L${x1.toFixed(1)} ${y1.toFixed(1)}`;
    }
    return draw("path", {class: `cut ${kRoleClasses[mesh.role] ?? ""}`, d},
      draw("title", {}, `${mesh.name}, ${mesh.role}, ${mesh.material}`));
  }

  wayLines() {
    const points = this.path.points;
    const ends = [this.came, ...points.map((point) => point.at)].map((at) => this.screen(this.plane.coordinates(at)));
    const [[x, y]] = ends;
    const name = draw("text", {class: "met-label", x: x + 10, y: Math.max(y + 14, 18)}, "light");
    return [name, ...points.map((point, i) => {
      const medium = i === 0 ? "outside" : points[i - 1].medium;
      const [[x1, y1], [x2, y2]] = [ends[i], ends[i + 1]];
      return [draw("line", {class: `way ${medium === "inside" ? "inside" : "outside"}`, x1, y1, x2, y2}),
        arrowHead([x1, y1], [x2, y2], medium)];
    }).flat()];
  }

  iterateDots() {
    return (this.path.iterates ?? []).filter((iterate) => iterate.at).map((iterate, i) => {
      const [cx, cy] = this.screen(this.plane.coordinates(iterate.at));
      return draw("circle", {class: "iterate", cx, cy, r: 4}, draw("title", {},
        `${iterate.label}: ${formatNumber(iterate.distance)} m, error ${formatNumber(iterate.error)} m`));
    });
  }

  pointLabels() {
    return this.path.points.flatMap((point, i) => {
      const [cx, cy] = this.screen(this.plane.coordinates(point.at));
      const onLeft = cx > this.width * 0.7;
      const x = onLeft ? cx - 12 : cx + 12;
      return [draw("circle", {class: "met", cx, cy, r: 5}),
        draw("text", {class: "met-label", x, y: cy - 8, "text-anchor": onLeft ? "end" : "start"},
          `${i + 1} ${point.surface}`)];
    });
  }

  // A length in round numbers, about a fifth of the drawing.
  ruler() {
    const wanted = this.width / 5 / this.scale();
    const power = 10 ** Math.floor(Math.log10(wanted));
    const length = [5, 2, 1].map((step) => step * power).find((step) => step <= wanted) ?? power;
    const [x1, y1] = [16, this.height - 16];
    const x2 = x1 + length * this.scale();
    return [draw("line", {class: "ruler", x1, y1, x2, y2: y1}),
      draw("text", {class: "ruler-label", x: x1, y: y1 - 8}, `${formatNumber(length)} m`)];
  }
}

// In the middle of a piece of the way, pointing as the light goes.
function arrowHead([x1, y1], [x2, y2], medium) {
  const [dx, dy] = [x2 - x1, y2 - y1];
  const length = Math.hypot(dx, dy);
  if (!(length > 40)) return null;
  const [ux, uy] = [dx / length, dy / length];
  const [x, y] = [(x1 + x2) / 2 + 8 * ux, (y1 + y2) / 2 + 8 * uy];
  const corner = (back, aside) => `${x - back * ux - aside * uy} ${y - back * uy + aside * ux}`;
  return draw("path", {class: `arrow ${medium === "inside" ? "inside" : "outside"}`,
    d: `M${corner(0, 0)}L${corner(14, 6)}L${corner(14, -6)}Z`});
}
