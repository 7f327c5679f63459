// "Why is this pixel bright?": the picture, a light's caustic map and its grid on the caster, linked. A pixel, a
// texel or a vertex that is picked in one of them is shown in all, and told in words.

const kPixelColor = "#ffffff", kTexelColor = "#56b4e9", kVertexColor = "#e69f00";
// More marks than these only hide the picture.
const kMostMarks = 4000;

class PicturePanel {
  constructor(page) {
    this.page = page;
    this.words = new LightWords(page);
    this.picture = new TextureView("Picture", {noun: "Pixel", pick: (x, y) => page.set({pick: ["pixel", x, y]})});
    this.map = new TextureView("Caustic map", {pick: (x, y) => page.set({pick: ["texel", x, y]})});
    this.caster = new TextureView("Grid on the caster", {noun: "Vertex", pick: (x, y) => page.set({pick: ["vertex", x, y]})});
    this.text = make("div", {class: "answer", "aria-live": "polite"});
    this.lightChoice = make("p", {class: "light-choice"});
    this.element = make("div", {class: "panel picture-panel"}, this.picture.element,
      make("div", {class: "stack"}, this.map.element, this.caster.element),
      make("aside", {class: "side", "aria-label": "Where the light comes from"}, this.lightChoice, this.text));
    this.turn = 0;
  }

  async show(state) {
    const turn = ++this.turn;
    const run = this.page.run();
    const picture = run.picture();
    this.element.classList.toggle("wide", picture?.width > 1.3 * picture?.height);
    await this.picture.show(run, picture, "the recording has no picture");
    if (turn !== this.turn) return;
    const lightIndex = await this.chooseLight(run, state);
    if (turn !== this.turn) return;
    this.lightIndex = lightIndex;
    const light = run.lights[this.lightIndex];
    if (!light) return this.sayNoLight(run);
    this.links = new LightLinks(run, light);
    const found = await this.follow(state.pick);
    if (turn !== this.turn) return;
    this.showLightChoice(run);
    await this.map.show(run, this.links.mapAttachment(found.map), "this light has no caustic map");
    await this.caster.show(run, this.links.entryAttachment(), "where this light enters the casters");
    if (turn !== this.turn) return;
    this.mark(found);
    this.text.replaceChildren(...found.words.filter(Boolean));
  }

  sayNoLight(run) {
    for (const view of [this.map, this.caster]) view.show(run, null, "this run has no light");
    this.text.replaceChildren(paragraph("This run has no light."), ...this.leftOut(run));
  }

  // A pixel asks for the light that gives it most caustic, unless one was chosen.
  async chooseLight(run, state) {
    if (state.light !== null && run.lights[state.light]) return state.light;
    let best = Math.max(0, run.lights.findIndex((light) => light.maps?.length)), most = 0;
    if (state.pick?.[0] !== "pixel") return best;
    for (let index = 0; index < run.lights.length; index++) {
      const {caustic} = await this.words.irradiance(run, index, state.pick[1], state.pick[2]);
      const here = caustic ? brightness(caustic, 0, 3) : 0;
      if (here > most) [best, most] = [index, here];
    }
    return best;
  }

  showLightChoice(run) {
    if (run.lights.length < 2) return this.lightChoice.replaceChildren();
    const choice = make("select", {"aria-label": "Light", onchange: (event) =>
      this.page.set({light: event.target.value === "" ? null : Number(event.target.value)})},
    make("option", {value: "", selected: this.page.state.light === null}, "the one that gives most"),
    run.lights.map((light, index) => make("option", {value: index, selected: this.page.state.light === index},
      `${light.name} (${light.type})`)));
    this.lightChoice.replaceChildren(make("label", {}, "Light ", choice),
      this.page.state.light === null ? ` Shown: ${run.lights[this.lightIndex].name}` : "");
  }

  // All that belongs to what was picked: {map, pixels, texels, vertices, words}.
  async follow(pick) {
    switch (pick?.[0]) {
      case "pixel": return this.followPixel(pick[1], pick[2]);
      case "texel": return this.followTexel(pick[1], pick[2]);
      case "vertex": case "cell": return this.followVertex(pick);
      default: return {map: 0, pixels: [], texels: [], vertices: [], words: this.introduction()};
    }
  }

  introduction() {
    const run = this.page.run();
    return [make("h3", {}, "Why is this pixel bright?"),
      paragraph("Click a pixel of the picture: here is told which light reaches it, and by which cells of the grid."),
      paragraph("Or click a texel of the caustic map, or a vertex of the grid on the caster: which pixels see its light?"),
      paragraph("Wheel or + and − zoom, dragging moves, 0 shows the whole. ? shows all keys."),
      ...this.leftOut(run)];
  }

  leftOut(run) {
    const notes = run.notes.length ? [folded(plural(run.notes.length, "note"), make("ul", {},
      run.notes.map((note) => make("li", {}, note))))] : [];
    if (!run.left_out.length) return notes;
    return [...notes, folded("What this page leaves out", make("ul", {}, byReason(run.left_out).map(([why, names]) =>
      make("li", {}, make("strong", {}, why), `: ${names.join(", ")}`))))];
  }

  async followPixel(x, y) {
    const run = this.page.run();
    const lights = [];
    for (let index = 0; index < run.lights.length; index++) lights.push(await this.words.irradiance(run, index, x, y));
    const head = [make("h3", {}, `Pixel (${x}, ${y})`), await this.words.radianceParagraph(run, x, y), this.words.irradianceParagraph(lights, run, this.lightIndex)];
    const texels = await this.links.texelsOfPixel(x, y);
    if (!texels?.length) return {map: 0, pixels: [{x, y}], texels: [], vertices: [], words: [...head, this.noTexels()]};
    const givers = await this.links.givers(texels);
    const maps = [...new Set(texels.map((texel) => texel.map))];
    const read = maps.map((map) => texels.filter((texel) => texel.map === map));
    const words = [...head,
      paragraph(`From ${this.links.light.name}, the pixel reads `, read.map((some, index) => [index ? " and " : "",
        plural(some.length, "texel"), " of ", this.mapLink(maps[index], some[0])]), "."),
      ...await this.words.giversOf(this.links, maps, givers, texels.length)];
    return {map: maps[0], pixels: [{x, y}], texels: read[0], rectangle: around(read[0]),
      vertices: givers.list.map(asMark), words};
  }

  mapLink(map, {x, y}) {
    return linkTo(this.links.mapAttachment(map).label, () => this.page.set({pick: ["texel", x, y], map}));
  }

  noTexels() {
    const {name, pixels} = this.links.light;
    if (pixels) return paragraph(`The pixel reads no caustic map of ${name}.`);
    return paragraph(`Which texels of the caustic map of ${name} a pixel reads is not in this page.`);
  }

  async followTexel(x, y) {
    const map = clamp(this.page.state.map ?? 0, 0, Math.max(0, (this.links.light.maps?.length ?? 1) - 1));
    const texels = [{x, y, map, weight: 1, flux: 1}];
    const givers = await this.links.givers(texels);
    const pixels = await this.links.pixelsOf(texels);
    const attachment = this.links.mapAttachment(map);
    const words = [make("h3", {}, `Texel (${x}, ${y}) of ${attachment?.label ?? "the caustic map"}`),
      this.mapChoice(map), this.pixelsParagraph(pixels),
      this.historyLink(attachment, x, y), ...await this.words.giversOf(this.links, [map], givers, 1)];
    return {map, pixels: pixels ?? [], texels, vertices: givers.list.map(asMark), words};
  }

  // Where a light has more than one map: the links to the others.
  mapChoice(map) {
    const maps = (this.links.light.maps ?? []).map((one, index) => ({index, made: this.links.mapAttachment(index)}))
      .filter(({made}) => made);
    if (maps.length < 2) return null;
    return make("p", {}, "Maps of this light: ", maps.map(({index, made}, number) => [number ? ", " : "",
      index === map ? made.label : linkTo(made.label, () => this.page.set({map: index}))]));
  }

  historyLink(attachment, x, y) {
    if (!attachment) return null;
    const run = this.page.run();
    return paragraph(linkTo("All that was drawn into it, in order", () => this.page.set({panel: "passes",
      pass: run.passes[attachment.pass].label, texture: attachment.label, texel: [x, y]})));
  }

  pixelsParagraph(pixels) {
    if (!pixels) return paragraph("Which pixels read it is not in this page.");
    if (!pixels.length) return paragraph("No pixel of the picture reads it.");
    const shown = pixels.slice(0, 3).map(({x, y}, index) => [index ? ", " : "",
      linkTo(`(${x}, ${y})`, () => this.page.set({pick: ["pixel", x, y]}))]);
    return make("p", {}, `${plural(pixels.length, "pixel")} of the picture ${pixels.length === 1 ? "shows" : "show"} its light; most of it `, shown, ".");
  }

  async followVertex(pick) {
    const [kind, i, j] = pick;
    const texels = await this.links.texelsOf(pick);
    const pixels = await this.links.pixelsOf(texels);
    const map = texels[0]?.map ?? 0;
    const total = texels.reduce((flux, texel) => flux + texel.flux, 0);
    const share = texels.length ? `; the brightest texel has ${formatShare(texels[0].flux / total)} of that` : "";
    const words = [make("h3", {}, kind === "cell" ? `Cell (${i}, ${j})` : `Grid vertex (${i}, ${j})`),
      ...await this.wayParagraphs(kind, i, j),
      texels.length ? paragraph(`${kind === "cell" ? "It" : "The cells around it"} gave ${formatNumber(total)} ${this.fluxUnit()} to `,
        linkTo(plural(texels.length, "texel"), () => this.page.set({pick: ["texel", texels[0].x, texels[0].y], map})),
        ` of the caustic ${new Set(texels.map((texel) => texel.map)).size > 1 ? "maps" : "map"}${share}.`) :
        paragraph(this.links.leftOut(0).length ? this.links.leftOut(0)[0] : "It gave no light to a caustic map."),
      texels.length ? this.pixelsParagraph(pixels) : null, this.words.pathLink(this.links, i, j)].filter(Boolean);
    return {map, pixels: pixels ?? [], texels: texels.filter((texel) => texel.map === map),
      vertices: [{kind, i, j, share: 1}], words};
  }

  async wayParagraphs(kind, i, j) {
    if (kind !== "cell") return this.words.vertexParagraph(this.links, i, j);
    const corners = [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]];
    const branch = this.links.light.branches?.[0];
    const entry = await this.links.cellPoint([branch?.entry], [i, j]);
    const landing = await this.links.cellPoint(branch?.landing ?? [], [i, j]);
    return [paragraph(`The light enters at ${formatPoint(entry)} m and lands around ${formatPoint(landing)} m.`),
      make("p", {}, "Its vertices: ", corners.map(([a, b], index) => [index ? ", " : "",
        linkTo(`(${a}, ${b})`, () => this.page.set({pick: ["vertex", a, b]}))]), ".")];
  }

  fluxUnit() {
    return this.links.light.flux_unit ?? "";
  }

  mark({pixels, texels, vertices, rectangle}) {
    this.picture.image.setMarks(squares(pixels, kPixelColor));
    this.map.image.setMarks(squares(texels, kTexelColor, rectangle));
    this.caster.image.setMarks(vertices.slice(0, kMostMarks).map((vertex, index) => vertexMark(vertex, index, vertices[0].share)));
    for (const [view, list] of [[this.picture, pixels], [this.map, texels]]) {
      if (list.length && !view.image.shows(list[0].x, list[0].y)) view.image.centerOn(list[0].x, list[0].y);
    }
    this.rest(pixels);
  }

  rest(pixels) {
    if (pixels.length) this.picture.rest(pixels[0].x, pixels[0].y);
  }

  step() {}

  // Moves what is picked by one texel.
  moveTexel(dx, dy) {
    const pick = this.page.state.pick;
    const {attachment} = this.picture;
    if (!attachment) return;
    const [kind, x, y] = pick ?? ["pixel", attachment.width >> 1, attachment.height >> 1];
    this.page.set({pick: [kind, Math.max(0, x + dx), Math.max(0, y + dy)]});
  }

  views() {
    return [this.picture, this.map, this.caster];
  }
}

// [reason, names] of lines "name: reason".
function byReason(lines) {
  const found = new Map();
  for (const line of lines) {
    const [name, ...reason] = line.split(": ");
    const why = reason.join(": ");
    found.set(why, [...found.get(why) ?? [], name]);
  }
  return [...found];
}

// The rectangle around texels.
function around(texels) {
  const [columns, rows] = [texels.map(({x}) => x), texels.map(({y}) => y)];
  return [Math.min(...columns), Math.min(...rows), Math.max(...columns) + 1, Math.max(...rows) + 1];
}

// All are filled; the first, or a rectangle around them, has an outline, so that it is found.
function squares(list, color, rectangle = null) {
  if (!list.length) return [];
  const square = ({x, y}) => ({x0: x, y0: y, x1: x + 1, y1: y + 1});
  const [x0, y0, x1, y1] = rectangle ?? Object.values(square(list[0]));
  return [...list.slice(0, kMostMarks).map((one) => ({...square(one), color, fill: 0.55, outline: false})),
    {x0, y0, x1, y1, color}];
}

function asMark(giver) {
  const [i, j] = giver.vertex ?? [0, 0];
  return {kind: giver.history.vertices_of, i, j, share: giver.share};
}

// A cell lies between the middles of its vertices' texels. The brighter its mark, the more it gave.
function vertexMark({kind, i, j, share}, index, most) {
  const shift = kind === "cell" ? 0.5 : 0;
  return {x0: i + shift, y0: j + shift, x1: i + shift + 1, y1: j + shift + 1, color: kVertexColor,
    fill: 0.25 + 0.7 * share / most, outline: index === 0};
}
