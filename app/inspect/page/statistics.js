// What a texture's values are like: range, numbers that are none, how often each named value comes.

const kSamples = 20000;

// The least and largest finite value of a channel; low > high where there is none.
function finiteRange(values, channel, channels) {
  let low = Infinity, high = -Infinity;
  for (let i = channel; i < values.length; i += channels) {
    const v = values[i];
    if (v < low && v > -Infinity) low = v;
    if (v > high && v < Infinity) high = v;
  }
  return {low, high};
}

// Of textures that were looked through already: a large one takes a while.
const kCounted = new WeakMap();

// How many values are NaN and infinite, of all channels.
function countNotFinite(values) {
  if (kCounted.has(values)) return kCounted.get(values);
  let nan = 0, infinite = 0;
  for (let i = 0; i < values.length; i++) {
    const v = values[i];
    if (v - v === 0) continue;
    if (v !== v) nan++;
    else infinite++;
  }
  kCounted.set(values, {nan, infinite});
  return {nan, infinite};
}

// The values between which a share of 1 - 2 tail of the texels lies, from evenly spread samples: a single wild
// landing does not darken the rest. Texels are asked by `counts` whether they count.
function robustRange(values, channel, channels, counts, tail = 0.005) {
  const texels = values.length / channels;
  const step = Math.max(1, Math.floor(texels / kSamples));
  const samples = [];
  for (let i = 0; i < texels; i += step) {
    const v = values[i * channels + channel];
    if (Number.isFinite(v) && counts(i)) samples.push(v);
  }
  if (!samples.length) return {low: 0, high: 1};
  samples.sort((a, b) => a - b);
  const at = (share) => samples[Math.round(share * (samples.length - 1))];
  return {low: at(tail), high: at(1 - tail)};
}

// How many texels have each whole number.
function codeCounts(values, channel, channels) {
  const counts = new Map();
  for (let i = channel; i < values.length; i += channels) {
    counts.set(values[i], (counts.get(values[i]) ?? 0) + 1);
  }
  return counts;
}

// The first texel, in rows from the bottom, that has a NaN or infinite channel. There is one.
function firstNotFinite(values, channels) {
  return Math.floor(values.findIndex((v) => !Number.isFinite(v)) / channels);
}
