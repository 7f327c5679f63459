// Everything that a pass drew into one texel, in order, and what the texel held before and after each.

const kOutcomes = ["passed", "failed: discarded by the shader", "failed: behind (depth test)"];

// How what the shader gave meets what was there, by channel: in single precision, denormals flushed to 0, as the
// device blends.
const kBlends = {add: (held, gave) => stored(held + gave), multiply: (held, gave) => stored(held * gave),
  min: Math.min, max: Math.max};

function stored(value) {
  const single = Math.fround(value);
  return Math.abs(single) < 2 ** -126 ? 0 * Math.sign(single) : single;
}

// An attachment's value after each event of a texel. `events`: [{outcome, gave: [numbers]}].
// A fragment that passed is blended with what was there; without a blend it takes its place.
function replay(before, events, blend) {
  const meet = kBlends[blend] ?? ((held, gave) => gave);
  let held = before;
  return events.map((event) => {
    const after = event.outcome !== 0 ? held : held.map((v, c) => meet(v, event.gave[c]));
    const step = {before: held, after};
    held = after;
    return step;
  });
}

// Reads the history of texel (x, y): {events, attachments}, each event with what it gave to each attachment.
async function historyAt(run, history, x, y) {
  const start = await run.blobs.get(history.start);
  if (!start) return null;
  const texel = y * history.width + x;
  const [from, to] = [start[texel], start[texel + 1]];
  const [drawn, primitive, outcome, depth] = await Promise.all(
    [history.draw, history.primitive, history.outcome, history.depth].map((array) => run.blobs.get(array)));
  const events = [];
  for (let i = from; i < to; i++) {
    events.push({draw: drawn?.[i] ?? 0, primitive: primitive?.[i] ?? 0, outcome: outcome?.[i] ?? 0,
      depth: depth?.[i] ?? null});
  }
  const total = start[start.length - 1];
  const attachments = [];
  for (const [id, array] of Object.entries(history.values ?? {})) {
    attachments.push(await stepsOf(run, history, {id: Number(id), array, events, from, texel, total}));
  }
  if (!attachments.length && depth) attachments.push(await depthSteps(run, history, events, texel));
  return {events, attachments: attachments.filter(Boolean)};
}

// Of a pass that draws depth only: each fragment that passes takes the place of what was there.
async function depthSteps(run, history, events, texel) {
  const attachment = run.attachmentsOf(history.pass).find((one) => one.kind === "depth") ?? null;
  const gave = events.map((event) => ({outcome: event.outcome, gave: [event.depth]}));
  // A test for the farthest begins with the nearest depth.
  const cleared = run.passes[history.pass].state?.depth?.startsWith("greater") ? 0 : 1;
  const before = await beforeOf(run, history.before?.[attachment?.id] ?? [cleared], texel, 1);
  return {attachment, given: gave.map((event) => event.gave), steps: replay(before, gave, null)};
}

async function stepsOf(run, history, {id, array, events, from, texel, total}) {
  const values = await run.blobs.get(array);
  if (!values || !total) return null;
  const channels = Math.round(values.length / total);
  const gave = events.map((event, i) => ({outcome: event.outcome,
    gave: Array.from(values.subarray((from + i) * channels, (from + i + 1) * channels))}));
  const before = await beforeOf(run, history.before?.[id], texel, channels);
  const blend = run.passes[history.pass].state?.blend;
  return {attachment: run.attachment(id), given: gave.map((event) => event.gave), steps: replay(before, gave, blend)};
}

// Kept as a texture, or as the one value that all texels were cleared to.
async function beforeOf(run, before, texel, channels) {
  if (Array.isArray(before)) return before.slice(0, channels);
  const values = await run.blobs.get(before);
  return values ? Array.from(values.subarray(texel * channels, (texel + 1) * channels)) : new Array(channels).fill(0);
}

function primitiveName(run, history, event) {
  const grid = lightOf(run, run.passes[history.pass])?.grid;
  const vertex = verticesOf(history, event.primitive, grid);
  if (vertex) return `${history.vertices_of === "cell" ? "cell" : "vertex"} (${vertex.join(", ")})`;
  const drawn = run.passes[history.pass].draws?.[event.draw];
  const mesh = drawn?.mesh ? ` of ${drawn.mesh}` : "";
  return `triangle ${event.primitive}${mesh}${drawn?.material ? `, ${drawn.material}` : ""}`;
}

// The grid vertex of a primitive, of a cell its lowest one; null for other things.
function verticesOf(history, primitive, grid) {
  if (!history.vertices_of || !grid) return null;
  const across = history.vertices_of === "cell" ? grid - 1 : grid;
  return [primitive % across, Math.floor(primitive / across)];
}

const kRowsAtFirst = 60;

// The history as a table. `goVertex(i, j)`: shows a grid vertex's links.
class TexelHistory {
  constructor(goVertex) {
    this.goVertex = goVertex;
    this.element = make("div", {class: "texel-history"});
    this.turn = 0;
  }

  async show(run, number, texel) {
    const history = run.historyOf(number);
    const turn = ++this.turn;
    const say = (...parts) => this.element.replaceChildren(make("h3", {}, "History of a texel"), ...parts);
    if (!history) return say(paragraph(run.passes[number].draws?.some((drawn) => drawn.mesh) ?
      "What was drawn into each texel is not in this page." :
      "This pass is drawn over the whole texture at once: each texel has one fragment."));
    if (history.left_out) return say(paragraph("Not in this page: ", history.left_out));
    if (!texel) return say(paragraph("Click a texel: here is shown all that was drawn into it, in order."));
    const [x, y] = texel;
    if (x >= history.width || y >= history.height) return say(paragraph("That texel is outside."));
    const found = await historyAt(run, history, x, y);
    if (turn !== this.turn) return;
    if (!found) return say(paragraph("Not in this page."));
    say(...this.parts(run, history, texel, found));
  }

  parts(run, history, [x, y], {events, attachments}) {
    const passed = events.filter((event) => event.outcome === 0).length;
    const intro = paragraph(events.length ?
      `Texel (${x}, ${y}): ${plural(events.length, "fragment")}, ${passed} passed.` :
      `Nothing was drawn into texel (${x}, ${y}).`);
    if (!events.length) return [intro, ...attachments.map((one) =>
      paragraph(`${one.attachment?.name ?? "value"} stayed as before.`))];
    return [intro, ...attachments.map((one) => this.attachmentTable(run, history, events, one, kRowsAtFirst))];
  }

  attachmentTable(run, history, events, one, count) {
    const rows = events.slice(0, count).map((event, i) => [
      String(i + 1), this.primitive(run, history, event), exactly(one.given[i]),
      exactly(one.steps[i].before), exactly(one.steps[i].after),
      ...history.depth ? [exactly([event.depth], formatNumber(event.depth))] : [],
      make("span", {class: event.outcome === 0 ? "passed" : "failed"}, kOutcomes[event.outcome] ?? "?")]);
    const header = ["#", "drawn", "gave", "before", "after", ...history.depth ? ["depth"] : [], "outcome"];
    const box = make("div", {class: "history-table"},
      make("h4", {}, one.attachment?.label ?? "", one.attachment ? make("small", {}, ` ${one.attachment.meaning}`) : ""),
      make("div", {class: "wide"}, table(header, rows)));
    if (events.length > count) {
      box.append(linkTo(`Show all ${wholeNumber(events.length)}`,
        () => box.replaceWith(this.attachmentTable(run, history, events, one, events.length))));
    }
    return box;
  }

  primitive(run, history, event) {
    const name = primitiveName(run, history, event);
    const vertex = verticesOf(history, event.primitive, lightOf(run, run.passes[history.pass])?.grid);
    return vertex ? linkTo(name, () => this.goVertex(...vertex)) : name;
  }
}
