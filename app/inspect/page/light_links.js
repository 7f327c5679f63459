// Where the light of a pixel comes from, and where the light of a grid vertex goes: the ways between the picture,
// a light's caustic maps, and its grid on the casters.

class LightLinks {
  constructor(run, light) {
    this.run = run;
    this.light = light;
  }

  mapAttachment(map) {
    return this.run.attachment(this.light.maps?.[map]?.attachment);
  }

  // The caster's texture whose texels are the grid's vertices: of the first branch that has one.
  entryAttachment() {
    const branch = this.light.branches?.find((one) => one.entry !== null && one.entry !== undefined);
    return branch ? this.run.attachment(branch.entry) : null;
  }

  histories(map) {
    return (this.light.maps?.[map]?.histories ?? []).map((index) => this.run.histories[index]).filter(Boolean);
  }

  // What the page does not hold of what these links need.
  leftOut(map) {
    return this.histories(map).map((history) => history.left_out).filter(Boolean);
  }

  // The texels of a map that a pixel reads, each with the share of it that lies in the pixel's rectangle.
  // Null where the pixel reads none.
  async texelsOfPixel(x, y) {
    const {pixels} = this.light;
    const [maps, rectangles] = await Promise.all([pixels?.map, pixels?.rectangle].map((a) => this.run.blobs.get(a)));
    if (!maps || !rectangles || x >= pixels.width || y >= pixels.height) return null;
    const pixel = y * pixels.width + x;
    const attachment = this.mapAttachment(maps[pixel]);
    if (maps[pixel] === 255 || !attachment) return null;
    const rectangle = Array.from(rectangles.subarray(4 * pixel, 4 * pixel + 4));
    return {map: maps[pixel], rectangle, texels: texelsUnder(rectangle, attachment.width, attachment.height)};
  }

  // All that put light into these texels of a map, the largest first, with their shares of it.
  async givers(map, texels) {
    const found = new Map();
    let total = 0;
    for (const history of this.histories(map)) {
      const fluxes = await this.fluxes(history, map);
      if (!fluxes) continue;
      const {start, primitive, outcome, fluxAt} = fluxes;
      for (const {x, y, weight} of texels) {
        const texel = y * history.width + x;
        for (let i = start[texel]; i < start[texel + 1]; i++) {
          if (outcome?.[i]) continue;
          const flux = weight * fluxAt(i);
          if (flux === 0) continue;
          total += flux;
          const key = `${history.pass}:${primitive[i]}`;
          if (!found.has(key)) found.set(key, this.giver(history, primitive[i]));
          found.get(key).flux += flux;
        }
      }
    }
    const list = [...found.values()].sort((a, b) => b.flux - a.flux);
    for (const giver of list) giver.share = giver.flux / total;
    return {total, list};
  }

  giver(history, primitive) {
    return {history, primitive, flux: 0, vertex: verticesOf(history, primitive, this.light.grid)};
  }

  // A history's arrays, with a function that says the flux of an event.
  async fluxes(history, map) {
    const texture = this.mapAttachment(map)?.texture;
    const ids = Object.keys(history.values ?? {});
    const id = ids.find((one) => this.run.attachment(Number(one))?.texture === texture) ?? ids[0];
    const [start, primitive, outcome, values] = await Promise.all(
      [history.start, history.primitive, history.outcome, history.values?.[id]].map((a) => this.run.blobs.get(a)));
    if (!start || !primitive || !values) return null;
    const channels = Math.round(values.length / Math.max(primitive.length, 1)) || 1;
    return {start, primitive, outcome, fluxAt: (i) => brightness(values, i * channels, channels)};
  }

  // The texels that a vertex's or cell's light went to: [{map, x, y, flux}], the brightest first.
  // A vertex gives to the up to four cells around it, or is a splat itself.
  async texelsOf([kind, i, j]) {
    const found = [];
    for (let map = 0; map < (this.light.maps ?? []).length; map++) {
      for (const history of this.histories(map)) {
        const wanted = this.primitivesOf(history, kind, i, j);
        const fluxes = wanted.size ? await this.fluxes(history, map) : null;
        if (fluxes) collectTexels(found, map, history, wanted, fluxes);
      }
    }
    return found.sort((a, b) => b.flux - a.flux);
  }

  primitivesOf(history, kind, i, j) {
    const grid = this.light.grid;
    if (history.vertices_of === "vertex") return new Set([j * grid + i]);
    if (history.vertices_of !== "cell") return new Set();
    const corners = kind === "cell" ? [[i, j]] : [[i, j], [i - 1, j], [i, j - 1], [i - 1, j - 1]];
    return new Set(corners.filter(([a, b]) => a >= 0 && b >= 0 && a < grid - 1 && b < grid - 1)
      .map(([a, b]) => b * (grid - 1) + a));
  }

  // The pixels that read one of these texels, [{x, y, share}]: share of the texels' flux that lies in a pixel's
  // rectangle, the largest first.
  async pixelsOf(texels) {
    const {pixels} = this.light;
    const [maps, rectangles] = await Promise.all([pixels?.map, pixels?.rectangle].map((a) => this.run.blobs.get(a)));
    if (!maps || !rectangles) return null;
    const byMap = new Map();
    for (const texel of texels) byMap.set(texel.map, [...byMap.get(texel.map) ?? [], texel]);
    const found = [];
    for (let pixel = 0; pixel < maps.length; pixel++) {
      const wanted = byMap.get(maps[pixel]);
      if (!wanted) continue;
      const share = shareInside(wanted, rectangles, 4 * pixel);
      if (share > 0) found.push({x: pixel % pixels.width, y: Math.floor(pixel / pixels.width), share});
    }
    return found.sort((a, b) => b.share - a.share);
  }

  // What is known of a grid vertex on its way, by branch.
  async vertexWay(i, j) {
    const ways = [];
    for (const branch of this.light.branches ?? []) {
      const way = {branch, entry: await this.texel(branch.entry, i, j), exit: await this.texel(branch.exit, i, j)};
      for (const id of branch.landing ?? []) {
        const landing = await this.texel(id, i, j);
        // The farthest receivers are asked last and know what was found before.
        if (landing) way.landing = landing;
      }
      ways.push(way);
    }
    return ways;
  }

  async texel(id, i, j) {
    const attachment = this.run.attachment(id);
    const values = await this.run.values(attachment);
    if (!values || i >= attachment.width || j >= attachment.height) return null;
    const channels = channelsOf(attachment);
    const at = (j * attachment.width + i) * channels;
    const w = channels > 3 ? values[at + 3] : 1;
    return {attachment, at: Array.from(values.subarray(at, at + 3)), w, name: attachment.codes?.[3]?.[w] ?? null};
  }

  // The middle of where a cell's vertices enter or land, of those that do; null where none does.
  async cellPoint(ids, [i, j]) {
    const corners = [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]];
    const points = [];
    for (const [a, b] of corners) {
      let last = null;
      for (const id of ids) last = await this.texel(id, a, b) ?? last;
      if (last && last.w !== 0 && (last.name === null || kDrawn.has(last.w))) points.push(last.at);
    }
    return points.length ? times(points.reduce(sum), 1 / points.length) : null;
  }

  // The branch that a history's pass belongs to: labels are "pass[light branch]".
  branchOf(history) {
    const branches = this.light.branches ?? [];
    if (Number.isInteger(history.branch)) return branches[history.branch] ?? null;
    const label = this.run.passes[history.pass]?.label ?? "";
    return branches.find((branch) => branch.name && label.includes(` ${branch.name}]`)) ??
      branches.find((branch) => !branch.name) ?? branches[0] ?? null;
  }

  // The lattice vertex of the recorded ways that is nearest to (i, j): its number, or -1.
  nearestPath(i, j) {
    const vertices = this.light.paths?.vertices ?? [];
    let best = -1, least = Infinity;
    vertices.forEach(([x, y], number) => {
      const distance = (x - i) ** 2 + (y - j) ** 2;
      if (distance < least) [best, least] = [number, distance];
    });
    return best;
  }
}

// Statuses whose light is drawn into the map: landed, and stopped but drawn.
const kDrawn = new Set([1, 8]);

// Texel i spans i to i + 1. A rectangle without extent reads the texel that it lies in.
function texelsUnder([x0, y0, x1, y1], width, height) {
  const texels = [];
  const [right, top] = [Math.max(Math.ceil(x1), Math.floor(x0) + 1), Math.max(Math.ceil(y1), Math.floor(y0) + 1)];
  for (let y = Math.max(0, Math.floor(y0)); y < Math.min(top, height); y++) {
    for (let x = Math.max(0, Math.floor(x0)); x < Math.min(right, width); x++) {
      const weight = overlap(x, x0, x1) * overlap(y, y0, y1);
      if (weight > 0) texels.push({x, y, weight});
    }
  }
  return texels;
}

function overlap(texel, from, to) {
  return to > from ? Math.min(to, texel + 1) - Math.max(from, texel) : 1;
}

function collectTexels(found, map, history, wanted, {start, primitive, outcome, fluxAt}) {
  const byTexel = new Map();
  let texel = 0;
  for (let event = 0; event < primitive.length; event++) {
    if (!wanted.has(primitive[event]) || outcome?.[event]) continue;
    while (start[texel + 1] <= event) texel++;
    byTexel.set(texel, (byTexel.get(texel) ?? 0) + fluxAt(event));
  }
  for (const [at, flux] of byTexel) {
    if (flux > 0) found.push({map, x: at % history.width, y: Math.floor(at / history.width), flux});
  }
}

function shareInside(texels, rectangles, at) {
  const [x0, y0, x1, y1] = [rectangles[at], rectangles[at + 1], rectangles[at + 2], rectangles[at + 3]];
  let inside = 0;
  for (const {x, y, flux} of texels) {
    const across = Math.max(0, Math.min(x1, x + 1) - Math.max(x0, x));
    const up = Math.max(0, Math.min(y1, y + 1) - Math.max(y0, y));
    inside += flux * across * up;
  }
  return inside;
}
