// Turns a texture's values into colours by what they mean. A way of showing is a `mode`:
// "display", "position", "normal", "color", "light" (brightness on a logarithmic scale), "codes:C",
// "linear:C" and "log:C" of one channel C.

// Of a logarithmic scale: five decades below the brightest.
const kDecades = 1e-5;

function modesOf(attachment) {
  const channels = channelsOf(attachment);
  const modes = [];
  if (attachment.kind === "display") modes.push(["display", "as on the screen"]);
  if (attachment.kind === "position") modes.push(["position", "positions as colours"]);
  if (attachment.kind === "normal") modes.push(["normal", "normals, 0.5 + 0.5 n"]);
  if (channels >= 3 && attachment.kind !== "display") {
    modes.push(["light", "brightness, logarithmic"], ["color", "colour with exposure"]);
  }
  for (let c = 0; c < channels; c++) {
    const name = channelName(attachment, c);
    if (attachment.codes?.[c]) modes.push([`codes:${c}`, `${name}: by name`]);
    modes.push([`linear:${c}`, `${name}: linear`], [`log:${c}`, `${name}: logarithmic`]);
  }
  return modes;
}

// How a texture is shown at first.
function firstMode(attachment) {
  const channels = channelsOf(attachment);
  const coded = Object.keys(attachment.codes ?? {})[0];
  switch (attachment.kind) {
    case "display": return "display";
    case "position": return channels >= 3 ? "position" : "linear:0";
    case "normal": return channels >= 3 ? "normal" : "linear:0";
    case "flux": return channels >= 3 ? "light" : "log:0";
    case "radiance": case "color": return channels >= 3 ? "color" : "log:0";
    case "status": return coded !== undefined ? `codes:${coded}` : "linear:0";
    default: return "linear:0";
  }
}

// The values with all that is needed to colour them. `range` is {low, high} where the user chose one.
class Shading {
  constructor(attachment, values, mode, exposure = 0, range = null) {
    Object.assign(this, {attachment, values, mode, range});
    this.channels = Math.round(values.length / (attachment.width * attachment.height));
    this.gain = 2 ** exposure;
    const [kind, channel] = mode.split(":");
    this.kind = kind;
    this.channel = channel === undefined ? null : Number(channel);
    this.scale = this.makeScale();
  }

  // What the legend says: {low, high, logarithmic, unit}, or null where colours are not a scale.
  makeScale() {
    if (this.kind === "linear") return {...this.linearRange(), logarithmic: false, unit: this.unit(this.channel)};
    if (this.kind === "log") return {...this.logRange(this.channel), logarithmic: true, unit: this.unit(this.channel)};
    if (this.kind === "light") return {...this.logRange(null), logarithmic: true, unit: this.unit(0)};
    return null;
  }

  unit(channel) {
    return this.attachment.channels?.[channel]?.unit ?? "";
  }

  linearRange() {
    if (this.range) return this.range;
    if (this.attachment.kind === "depth") return this.depthRange();
    const {low, high} = finiteRange(this.values, this.channel, this.channels);
    return low > high ? {low: 0, high: 1} : {low, high: high > low ? high : low + 1};
  }

  // Depth 1 is where nothing was drawn.
  depthRange() {
    const range = robustRange(this.values, this.channel, this.channels,
      (i) => this.values[i * this.channels + this.channel] < 1, 0);
    return range.high > range.low ? range : {low: range.low - 0.001, high: range.low + 0.001};
  }

  logRange(channel) {
    if (this.range) return this.range;
    let low = Infinity, high = 0;
    for (let i = 0; i < this.values.length; i += this.channels) {
      const v = channel === null ? brightness(this.values, i, this.channels) : this.values[i + channel];
      if (v > high && v < Infinity) high = v;
      if (v < low && v > 0) low = v;
    }
    if (!(high > 0)) return {low: kDecades, high: 1};
    low = clamp(low, high * kDecades, high / 10);
    return {low: low / this.gain, high: high / this.gain};
  }

  // Colours of all texels, the top row first, as canvases have it.
  image() {
    const {width, height} = this.attachment;
    const image = new ImageData(width, height);
    const words = new Uint32Array(image.data.buffer);
    const colorAt = this.painter();
    for (let y = 0, texel = 0; y < height; y++) {
      for (let x = 0, to = (height - 1 - y) * width; x < width; x++, to++, texel++) words[to] = colorAt(texel);
    }
    return image;
  }

  painter() {
    switch (this.kind) {
      case "display": return this.displayPainter();
      case "position": return this.positionPainter();
      case "normal": return this.normalPainter();
      case "color": return this.colorPainter();
      case "codes": return this.codePainter();
      default: return this.scalePainter();
    }
  }

  displayPainter() {
    const {values, channels} = this;
    const [green, blue] = channels >= 3 ? [1, 2] : [0, 0];
    const whole = values instanceof Uint8Array ? 1 : 255;
    const part = (at) => clamp(Math.round(values[at] * whole), 0, 255);
    return (i) => packed(part(i * channels), part(i * channels + green), part(i * channels + blue));
  }

  // x red, y green, z blue, each over the range of the texels that have a position.
  positionPainter() {
    const {values, channels} = this;
    const counts = (i) => channels < 4 || values[i * channels + 3] !== 0;
    const ranges = [0, 1, 2].map((c) => robustRange(values, c, channels, counts));
    this.axisRanges = ranges;
    const part = (v, {low, high}) => clamp(high > low ? 40 + 215 * (v - low) / (high - low) : 128, 40, 255) | 0;
    return (i) => {
      const at = i * channels;
      const [x, y, z] = [values[at], values[at + 1], values[at + 2]];
      const bad = strikingColor(x + y + z);
      if (bad) return bad;
      if (!counts(i)) return kNothing;
      return packed(part(x, ranges[0]), part(y, ranges[1]), part(z, ranges[2]));
    };
  }

  normalPainter() {
    const {values, channels} = this;
    const part = (v) => clamp(127.5 + 127.5 * v, 0, 255) | 0;
    return (i) => {
      const at = i * channels;
      const [x, y, z] = [values[at], values[at + 1], values[at + 2]];
      const bad = strikingColor(x + y + z);
      if (bad) return bad;
      if (x === 0 && y === 0 && z === 0) return kNothing;
      return packed(part(x), part(y), part(z));
    };
  }

  // White is where 99 % of the texels are darker, times the exposure.
  colorPainter() {
    const {values, channels} = this;
    const white = Math.max(...[0, 1, 2].map((c) => robustRange(values, c, channels, () => true, 0.01).high)) || 1;
    const steps = 4095;
    const screen = Uint8Array.from({length: steps + 1}, (_, i) => screenValue(i / steps));
    const gain = this.gain / white * steps;
    const part = (v) => screen[clamp(v * gain, 0, steps) | 0];
    return (i) => {
      const at = i * channels;
      const [r, g, b] = [values[at], values[at + 1], values[at + 2]];
      return strikingColor(r + g + b) || packed(part(r), part(g), part(b));
    };
  }

  codePainter() {
    const {values, channels, channel} = this;
    const colors = Array.from({length: 32}, (_, code) => packedHex(namedColor(code)));
    return (i) => {
      const v = values[i * channels + channel];
      return strikingColor(v) || (colors[v] ?? kNothing);
    };
  }

  scalePainter() {
    const {values, channels, channel, scale} = this;
    const colors = viridisPalette();
    const last = kPaletteSize - 1;
    const [from, to] = scale.logarithmic ? [Math.log(scale.low), Math.log(scale.high)] : [scale.low, scale.high];
    const factor = last / (to - from || 1);
    const nothing = this.attachment.kind === "depth" ? 1 : null;
    return (i) => {
      const v = channel === null ? brightness(values, i * channels, channels) : values[i * channels + channel];
      const bad = strikingColor(v);
      if (bad) return bad;
      if (v === nothing || (scale.logarithmic && v <= 0)) return kNothing;
      return colors[clamp(((scale.logarithmic ? Math.log(v) : v) - from) * factor, 0, last) | 0];
    };
  }
}

// A sum of values is NaN or infinite where one of them is.
function strikingColor(v) {
  if (v !== v) return kNotANumber;
  return v === Infinity || v === -Infinity ? kInfinite : 0;
}
