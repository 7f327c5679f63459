// What is known of a pass, in words.

// `go`: {pass(number), texture(attachment)}: shows that pass or attachment.
function passFacts(run, number, go) {
  const pass = run.passes[number];
  const light = lightOf(run, pass);
  return [
    make("h3", {}, pass.label),
    paragraph(pass.purpose),
    paragraph(make("strong", {}, "Why it ran: "), pass.reason || "not said"),
    light ? paragraph(make("strong", {}, "Light: "), `${light.name} (${light.type}, ${formatNumber(light.intensity)} ${light.unit})`) : null,
    countersOf(pass),
    readsOf(run, number, go),
    readersParagraph(run, number, go),
    stateOf(pass),
    pass.draws?.length ? folded(plural(pass.draws.length, "draw"), drawsTable(pass)) : null,
    pass.uniforms?.length ? folded(`${plural(pass.uniforms.length, "uniform")} of its first draw`, uniformsTable(pass)) : null,
  ].filter(Boolean);
}

function countersOf(pass) {
  const counts = [["vertex", "vertices", pass.vertices], ["primitive", "primitives", pass.primitives],
    ["fragment", "fragments", pass.fragments], ["sample that passed", "samples that passed", pass.samples_passed]]
    .filter(([, , count]) => count !== null && count !== undefined)
    .map(([one, many, count]) => plural(count, one, many));
  const times = `${formatMilliseconds(pass.milliseconds)}, ${formatMilliseconds(pass.processor_milliseconds)} of the processor. `;
  return paragraph(make("strong", {}, "Time: "), times, counts.join(", ") + ".",
    pass.left_out ? ` Nothing was drawn, since ${pass.label.includes(".layer ") ? "the picture has no such layer"
      : "no light reaches it"}: its textures were cleared.` : "");
}

function readsOf(run, number, go) {
  const reads = run.passes[number].reads ?? [];
  if (!reads.length) return paragraph(make("strong", {}, "Reads: "), "no texture of another pass");
  const items = reads.map((texture) => {
    const attachment = run.attachmentBefore(number, texture);
    return make("li", {}, attachment ? linkTo(attachment.label, () => go.texture(attachment),
      `from ${run.passes[attachment.pass].label}`) : texture);
  });
  return make("div", {}, make("strong", {}, "Reads:"), make("ul", {class: "inline"}, items));
}

function readersParagraph(run, number, go) {
  const readers = run.readersOf(number);
  if (!readers.length) return null;
  return make("div", {}, make("strong", {}, "Read by:"), make("ul", {class: "inline"},
    readers.map((reader) => make("li", {}, linkTo(run.passes[reader].label, () => go.pass(reader))))));
}

function stateOf(pass) {
  const {topology, depth, cull, blend} = pass.state ?? {};
  const parts = [topology, depth ? `depth: ${depth}` : null, cull ? `cull ${cull}` : null,
    blend ? `blend: ${blend}` : null].filter(Boolean);
  return parts.length ? paragraph(make("strong", {}, "State: "), parts.join("; ")) : null;
}

function drawsTable(pass) {
  return table(["draw", "mesh", "material"],
    pass.draws.map((drawn, index) => [String(index), drawn.mesh ?? "–", drawn.material ?? "–"]));
}

function uniformsTable(pass) {
  return table(["name", "value", "meaning"], pass.uniforms.map(({name, value, meaning}) =>
    [name, Array.isArray(value) ? formatPoint(value) : formatNumber(value), meaning ?? ""]));
}
