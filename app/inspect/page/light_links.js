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

  // What the page holds of the pixels of the picture (app/inspect/pixel_table.hpp); null where it holds nothing.
  async pixelTable() {
    const {pixels} = this.light;
    if (!pixels) return null;
    const [start, samples, map, fetches] = await Promise.all(
      [pixels.start, pixels.samples, pixels.map, pixels.fetches].map((array) => this.run.blobs.get(array)));
    const sizes = (this.light.maps ?? []).map((_, number) => this.mapAttachment(number));
    return start && samples && map && fetches ? {...pixels, start, samples, map, fetches, sizes} : null;
  }

  // The texels of the caustic maps that a pixel reads, [{map, x, y, weight}], as `probe --pixel` has them. Null
  // where that is not in the page.
  async texelsOfPixel(x, y) {
    const table = await this.pixelTable();
    if (!table || x >= table.width || y >= table.height) return null;
    return texelsOfFetches(table, y * table.width + x);
  }

  // All histories of the light's maps in the order in which their passes ran: [{map, history}].
  allHistories() {
    return (this.light.maps ?? []).flatMap((_, map) => this.histories(map).map((history) => ({map, history})))
      .sort((a, b) => a.history.pass - b.history.pass);
  }

  // All that put light into these texels, the largest first, with their shares of it. Sums are taken in the
  // order of `probe --pixel` (app/probe/pixel_light.cpp), so that they are its sums.
  async givers(texels) {
    const list = [];
    for (const {map, history} of this.allHistories()) {
      const here = texels.filter((texel) => texel.map === map);
      const fluxes = here.length ? await this.fluxes(history, map) : null;
      if (fluxes) list.push(...this.giversIn(history, here, fluxes));
    }
    const total = list.reduce((sum, giver) => sum + giver.flux, 0);
    for (const giver of list) giver.share = total > 0 ? giver.flux / total : 0;
    return {total, list: list.sort((a, b) => b.share - a.share)};
  }

  // Those of one pass, by their numbers.
  giversIn(history, texels, {start, primitive, outcome, fluxAt}) {
    const found = new Map();
    for (const {x, y, weight} of texels) {
      const texel = y * history.width + x;
      for (let i = start[texel]; i < start[texel + 1]; i++) {
        if (outcome?.[i]) continue;
        const flux = weight * fluxAt(i);
        if (flux === 0) continue;
        if (!found.has(primitive[i])) found.set(primitive[i], this.giver(history, primitive[i]));
        found.get(primitive[i]).flux += flux;
      }
    }
    return [...found.values()].sort((a, b) => a.primitive - b.primitive);
  }

  giver(history, primitive) {
    return {history, primitive, flux: 0, vertex: verticesOf(history, primitive, this.light.grid)};
  }

  // A history's arrays, with functions that say the flux of an event: of all colours together, as shares count
  // it, and its brightness.
  async fluxes(history, map) {
    const texture = this.mapAttachment(map)?.texture;
    const ids = Object.keys(history.values ?? {});
    const id = ids.find((one) => this.run.attachment(Number(one))?.texture === texture) ?? ids[0];
    const [start, primitive, outcome, values] = await Promise.all(
      [history.start, history.primitive, history.outcome, history.values?.[id]].map((a) => this.run.blobs.get(a)));
    if (!start || !primitive || !values) return null;
    const channels = Math.round(values.length / Math.max(primitive.length, 1)) || 1;
    return {start, primitive, outcome, fluxAt: (i) => sumOfColors(values, i * channels, channels),
      brightnessAt: (i) => brightness(values, i * channels, channels)};
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

  // The pixels that read one of these texels, [{x, y, share}]: share is the light that they have of it, the most
  // first.
  async pixelsOf(texels) {
    const table = await this.pixelTable();
    if (!table) return null;
    const flux = table.sizes.map((size) => size ? new Float64Array(size.width * size.height) : null);
    for (const texel of texels) {
      if (flux[texel.map]) flux[texel.map][texel.y * table.sizes[texel.map].width + texel.x] += texel.flux;
    }
    const found = [];
    for (let pixel = 0; pixel < table.width * table.height; pixel++) {
      let share = 0;
      eachTexel(table, pixel, (map, x, y, part) => { share += flux[map][y * table.sizes[map].width + x] * part; });
      if (share > 0) found.push({x: pixel % table.width, y: Math.floor(pixel / table.width), share});
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

// What a texel gives to all colours together.
function sumOfColors(values, at, channels) {
  let sum = 0;
  for (let c = 0; c < Math.min(channels, 3); c++) sum += values[at + c];
  return sum;
}

// The texels around each look-up of a pixel with their part of it, those beyond the edges clamped:
// `map_texels` of app/probe/pixel_light.cpp, step by step in the same arithmetic.
function eachTexel({start, map, fetches, sizes}, pixel, visit) {
  for (let i = start[pixel]; i < start[pixel + 1]; i++) {
    const size = sizes[map[i]];
    if (!size) continue;
    const weight = fetches[4 * i + 2] * fetches[4 * i + 3];
    const [x, y] = [fetches[4 * i] * size.width - 0.5, fetches[4 * i + 1] * size.height - 0.5];
    const [left, below] = [Math.floor(x), Math.floor(y)];
    for (let dy = 0; dy < 2; dy++) {
      for (let dx = 0; dx < 2; dx++) {
        const part = (dx ? x - left : 1 - (x - left)) * (dy ? y - below : 1 - (y - below)) * weight;
        if (part === 0) continue;
        visit(map[i], clamp(left + dx, 0, size.width - 1), clamp(below + dy, 0, size.height - 1), part);
      }
    }
  }
}

// By map, row and column.
function texelsOfFetches(table, pixel) {
  const found = new Map();
  eachTexel(table, pixel, (map, x, y, part) => {
    const key = `${map}:${y}:${x}`;
    if (!found.has(key)) found.set(key, {map, x, y, weight: 0});
    found.get(key).weight += part;
  });
  const samples = Math.max(table.samples[pixel], 1);
  return [...found.values()].map((texel) => ({...texel, weight: texel.weight / samples}))
    .sort((a, b) => a.map - b.map || a.y - b.y || a.x - b.x);
}

function collectTexels(found, map, history, wanted, {start, primitive, outcome, brightnessAt}) {
  const byTexel = new Map();
  let texel = 0;
  for (let event = 0; event < primitive.length; event++) {
    if (!wanted.has(primitive[event]) || outcome?.[event]) continue;
    while (start[texel + 1] <= event) texel++;
    byTexel.set(texel, (byTexel.get(texel) ?? 0) + brightnessAt(event));
  }
  for (const [at, flux] of byTexel) {
    if (flux > 0) found.push({map, x: at % history.width, y: Math.floor(at / history.width), flux});
  }
}
