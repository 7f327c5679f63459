// What lies behind a pixel, a texel of a caustic map or a grid vertex, in words with links.

const kGiversAtFirst = 8;

class LightWords {
  constructor(page) {
    this.page = page;
  }

  // What light `index` gives to a pixel: {direct, caustic}, three colours in lux each, as `probe --pixel` prints
  // them; null where the page does not hold it.
  async irradiance(run, index, x, y) {
    const {pixels} = run.lights[index];
    const found = {};
    for (const name of ["direct", "caustic"]) {
      const values = await run.blobs.get(pixels?.[name]);
      const at = 4 * (y * pixels?.width + x);
      found[name] = values && x < pixels.width && y < pixels.height ? Array.from(values.subarray(at, at + 3)) : null;
    }
    return found;
  }

  // What the camera gets from a pixel, where the page holds it.
  async radianceParagraph(run, x, y) {
    const beauty = run.attachments.findLast((one) => one.texture === "beauty");
    const values = await run.values(beauty);
    if (!values || x >= beauty.width || y >= beauty.height) return null;
    const at = (y * beauty.width + x) * channelsOf(beauty);
    return paragraph("It sends ", formatColor(values.subarray(at, at + 3), "nit"), " to the camera.");
  }

  irradianceParagraph(lights, run, chosen) {
    const lux = (color) => color ? formatColor(color, "lux") : "not kept";
    return make("ul", {class: "lights"}, lights.map(({direct, caustic}, index) => {
      const {name} = run.lights[index];
      return make("li", {}, make("strong", {}, name), ": direct light ", lux(direct), ", caustic ", lux(caustic), " ",
        index !== chosen && run.lights.length > 1 ? linkTo("look into it", () => this.page.set({light: index})) : null);
    }));
  }

  // "12 texels, 31 cells; the largest gives 8 %", and the list of the largest.
  async giversOf(links, maps, {list}, texelCount) {
    const missing = maps.flatMap((map) => links.leftOut(map));
    if (!list.length) {
      const more = missing.length > 1 ? `; likewise ${plural(missing.length - 1, "more pass", "more passes")}` : "";
      return [missing.length ? paragraph("Which cells gave this light is not in this page: ", missing[0], more, ".") :
        paragraph("No cell of the grid puts light there.")];
    }
    const unknown = missing.length;
    const kinds = new Set(list.map((giver) => giver.history.vertices_of));
    const many = kinds.size > 1 ? "cells and vertices" : kinds.has("vertex") ? "vertices" : "cells";
    const noun = kinds.has("vertex") ? "vertex" : "cell";
    const table = make("div", {});
    await this.fillGivers(table, links, list, kGiversAtFirst);
    return [
      paragraph(`${plural(list.length, noun, many)} of the grid gave light to ` +
        (texelCount === 1 ? "this texel" : `these ${texelCount} texels`) +
        (list.length > 1 ? `; the largest gives ${formatShare(list[0].share)}: ` : ": "), this.giverLink(list[0]), "."),
      unknown ? paragraph(`What ${plural(unknown, "more pass", "more passes")} drew there is not in this page: shares are of the others' light.`) : null,
      table];
  }

  async fillGivers(element, links, list, count) {
    const rows = [];
    for (const giver of list.slice(0, count)) rows.push(await this.giverRow(links, giver));
    element.replaceChildren(
      table(["share", "from", "enters at, m", "lands at, m"], rows, {class: "givers"}),
      list.length > count ? linkTo(`Show ${list.length > 200 ? "200 of" : "all"} ${wholeNumber(list.length)}`,
        () => this.fillGivers(element, links, list, 200)) : "");
  }

  async giverRow(links, giver) {
    const share = exactly([giver.share], formatShare(giver.share));
    if (!giver.vertex) return [share, this.giverLink(giver), "–", "–"];
    const branch = links.branchOf(giver.history);
    const kind = giver.history.vertices_of;
    const entry = await this.pointOf(links, [branch?.entry], kind, giver.vertex);
    const landing = await this.pointOf(links, branch?.landing ?? [], kind, giver.vertex);
    return [share, this.giverLink(giver, `by ${links.run.passes[giver.history.pass]?.label}`),
      pointOrNone(entry), pointOrNone(landing)];
  }

  giverLink(giver, title = null) {
    if (!giver.vertex) return `primitive ${giver.primitive}`;
    const kind = giver.history.vertices_of;
    return linkTo(`${kind} (${giver.vertex.join(",\u00a0")})`, () => this.page.set({pick: [kind, ...giver.vertex]}), title);
  }

  async pointOf(links, ids, kind, vertex) {
    if (kind === "cell") return links.cellPoint(ids, vertex);
    let point = null;
    for (const id of ids) point = await links.texel(id, ...vertex) ?? point;
    return point && point.w !== 0 ? point.at : null;
  }

  // What is known of one grid vertex: where it enters, leaves and lands, and what became of it.
  async vertexParagraph(links, i, j) {
    const lines = [];
    for (const way of await links.vertexWay(i, j)) {
      const name = way.branch.name ? `${way.branch.name}: ` : "";
      if (!way.entry && !way.landing) continue;
      if (way.entry?.w === 0) {
        lines.push(paragraph(`${name}No caster lies under this vertex: its light goes straight on.`));
        continue;
      }
      const entry = way.entry ? ["Its light enters at ", exactly(way.entry.at, formatPoint(way.entry.at)), " m. "] : "";
      lines.push(paragraph(name, entry, way.landing ? landingText(way.landing) : ""));
    }
    return lines.length ? lines : [paragraph("Where its light enters and lands is not in this page.")];
  }

  pathLink(links, i, j) {
    const nearest = links.nearestPath(i, j);
    if (nearest < 0) return null;
    const [x, y] = links.light.paths.vertices[nearest];
    return paragraph(linkTo("Its way through the scene, in a section", () => this.page.set({panel: "path", vertex: [i, j]})),
      x === i && y === j ? "" : ` (the nearest way that is recorded: vertex (${x}, ${y}))`);
  }
}

function pointOrNone(point) {
  return point ? exactly(point, formatPoint(point)) : formatPoint(null);
}

function landingText(landing) {
  if (!kDrawn.has(landing.w)) return `It does not reach the map: ${landing.name ?? "status " + landing.w}.`;
  return ["It lands at ", exactly(landing.at, formatPoint(landing.at)), " m."];
}
