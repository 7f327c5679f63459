// Two runs compared, attachment by attachment.

// All attachments of both, in the order of the first run's passes: {key, label, texture, a, b, state}, state being
// "equal" (by hash), "differs", "only in A" or "only in B".
function matchedAttachments(a, b) {
  const inB = new Map(b.attachments.map((one) => [keyOf(b, one), one]));
  const pairs = a.attachments.map((one) => {
    const other = inB.get(keyOf(a, one)) ?? null;
    inB.delete(keyOf(a, one));
    const state = !other ? `only in ${a.name}` : one.sha256 === other.sha256 ? "equal" : "differs";
    return {key: keyOf(a, one), label: a.passes[one.pass]?.label, texture: one.label, a: one, b: other, state};
  });
  for (const [key, one] of inB) {
    pairs.push({key, label: b.passes[one.pass]?.label, texture: one.label, a: null, b: one, state: `only in ${b.name}`});
  }
  return pairs;
}

function sameSize({a, b}) {
  return a.width === b.width && a.height === b.height;
}

function keyOf(run, attachment) {
  return `${run.passes[attachment.pass]?.label}/${attachment.texture}`;
}

// {count, most, texel, channel, differences (of each texel the largest of its channels)}. Two NaNs are equal; a NaN
// beside a number is an infinite difference.
function differenceOf(attachment, a, b) {
  const texels = attachment.width * attachment.height;
  const channels = Math.round(a.length / texels);
  const differences = new Float32Array(texels);
  let count = 0, most = 0, worst = -1;
  for (let texel = 0; texel < texels; texel++) {
    let largest = 0;
    for (let i = texel * channels; i < (texel + 1) * channels; i++) {
      if (a[i] === b[i] || (a[i] !== a[i] && b[i] !== b[i])) continue;
      const difference = Math.abs(a[i] - b[i]);
      largest = Math.max(largest, difference === difference ? difference : Infinity);
    }
    differences[texel] = largest;
    if (largest > 0) count++;
    if (largest > most) [most, worst] = [largest, texel];
  }
  return {count, most, differences, texel: worst < 0 ? null : [worst % attachment.width, Math.floor(worst / attachment.width)]};
}

function differenceText(pair, found) {
  if (pair.state !== "differs") return pair.state;
  if (!found) return "differs";
  if (!sameSize(pair)) {
    return `sizes differ: ${pair.a.width} × ${pair.a.height} and ${pair.b.width} × ${pair.b.height}`;
  }
  if (found.missing) return "hashes differ; the values are not in this page";
  if (!found.count) return "hashes differ by less than this page holds";
  return `${plural(found.count, "texel")} ${found.count === 1 ? "differs" : "differ"}, by at most ${formatNumber(found.most, 3)} at (${found.texel.join(", ")})`;
}
