// An attachment on the screen: its picture, how it is shown, the legend, and the value under the mouse.

class TextureView {
  // `controls`: whether the way of showing can be changed. `pick(x, y)`: a texel was clicked. `likeView`: another view,
  // whose choices and scale this one follows.
  constructor(label, {controls = false, pick = null, noun = "Texel", likeView = null} = {}) {
    Object.assign(this, {label, noun, likeView, followers: []});
    likeView?.followers.push(this);
    this.title = make("h3", {}, label);
    this.image = new ImageView(label, {
      hover: (x, y) => this.hover(x, y),
      pick: (x, y) => pick?.(x, y),
    });
    this.reading = make("p", {class: "reading", "aria-live": "polite"});
    this.missing = make("p", {class: "missing", hidden: true});
    this.legend = make("div", {class: "legend"});
    this.controls = make("div", {class: "controls", hidden: !controls});
    this.element = make("section", {class: "texture-view", "aria-label": label},
      this.title, this.controls, this.image.element, this.missing, this.reading, this.legend);
    this.chosen = likeView?.chosen ?? new Map();
    this.exposure = 0;
    this.turn = 0;
  }

  // Shows an attachment of a run, or why there is none to show.
  async show(run, attachment, why = "Nothing to show.") {
    const turn = ++this.turn;
    if (this.attachment === attachment && this.values) return;
    this.attachment = attachment;
    this.values = null;
    const named = attachment && attachment.label !== this.label.toLowerCase();
    this.title.textContent = named ? `${this.label}: ${attachment.label}` : this.label;
    if (!attachment?.data) return this.showMissing(attachment?.left_out ?? why);
    this.reading.textContent = "Decoding …";
    const values = await run.values(attachment);
    if (turn !== this.turn) return;
    this.values = values;
    this.missing.hidden = true;
    this.image.element.hidden = false;
    this.reading.textContent = "";
    this.paint();
  }

  showMissing(why) {
    this.image.clear();
    this.image.element.hidden = true;
    this.missing.hidden = false;
    this.missing.textContent = `Not in this page: ${why}`;
    this.reading.textContent = "";
    this.legend.replaceChildren();
    this.controls.replaceChildren();
  }

  choice() {
    const key = `${this.attachment.texture}`;
    if (!this.chosen.has(key)) this.chosen.set(key, {mode: firstMode(this.attachment), range: null});
    return this.chosen.get(key);
  }

  paint() {
    if (!this.values) return;
    const {mode, range} = this.choice();
    this.shading = new Shading(this.attachment, this.values, mode, this.exposure, range ?? this.followedScale());
    this.image.setImage(this.shading.image());
    this.legend.replaceChildren(...legendOf(this.shading, (texel) => this.goTo(texel)));
    if (!this.controls.hidden) this.makeControls();
    for (const follower of this.followers) follower.paint();
  }

  followedScale() {
    return this.likeView?.values ? this.likeView.shading.scale : null;
  }

  makeControls() {
    const {mode, range} = this.choice();
    const focused = document.activeElement?.getAttribute("data-control");
    const select = make("select", {"data-control": "mode", "aria-label": "How it is shown",
      onchange: (event) => this.change({mode: event.target.value, range: null})},
    modesOf(this.attachment).map(([value, text]) => make("option", {value, selected: value === mode}, text)));
    const exposed = ["color", "light", "log"].includes(this.shading.kind) && !range;
    const exposure = make("input", {type: "range", min: -10, max: 10, step: 0.5, value: this.exposure,
      "data-control": "exposure", "aria-label": "Exposure in stops",
      onchange: (event) => this.expose(Number(event.target.value) - this.exposure)});
    this.controls.replaceChildren(make("label", {}, "Show ", select),
      make("label", {hidden: !exposed}, `Exposure ${this.exposure > 0 ? "+" : ""}${this.exposure} `, exposure),
      ...this.rangeControls(), this.zoomControls());
    if (focused) this.controls.querySelector(`[data-control=${focused}]`)?.focus();
  }

  rangeControls() {
    const scale = this.shading.scale;
    if (!scale) return [];
    const field = (end, text) => make("label", {}, `${text} `, make("input", {type: "number", step: "any",
      "data-control": end, value: fieldText(scale[end]), onchange: (event) => {
        const range = {low: scale.low, high: scale.high, [end]: Number(event.target.value)};
        const sensible = range.high > range.low && (!scale.logarithmic || range.low > 0);
        this.change({range: sensible ? range : null});
      }}));
    return [field("low", "From"), field("high", "to"), make("button", {type: "button", "data-control": "whole",
      onclick: () => this.change({range: null})}, "Whole range")];
  }

  zoomControls() {
    const button = (text, label, action) => make("button", {type: "button", "aria-label": label, title: label,
      "data-control": label.split(" ").join("-").toLowerCase(), onclick: action}, text);
    return make("span", {class: "group"}, button("+", "Zoom in", () => this.image.zoomBy(1.5)),
      button("−", "Zoom out", () => this.image.zoomBy(1 / 1.5)), button("Fit", "Fit", () => this.image.reset()));
  }

  change(choice) {
    Object.assign(this.choice(), choice);
    this.paint();
  }

  // A range that was chosen gives way: both say how bright. One that follows is told by the other.
  expose(stops) {
    if (this.likeView) return;
    if (this.values) this.choice().range = null;
    this.exposure = clamp(this.exposure + stops, -10, 10);
    for (const follower of this.followers) follower.exposure = this.exposure;
    this.paint();
  }

  hover(x, y) {
    if (!this.values) return;
    if (x === null) {
      this.reading.textContent = this.resting ?? "";
      return;
    }
    this.reading.textContent = this.textAt(x, y);
  }

  textAt(x, y) {
    return `${this.noun} (${x}, ${y}). ${readingText(this.attachment, this.values, x, y)}`;
  }

  // The texel that is read while the mouse is elsewhere.
  rest(x, y) {
    this.resting = this.values && x < this.attachment.width && y < this.attachment.height ? this.textAt(x, y) : "";
    this.reading.textContent = this.resting;
  }

  goTo(texel) {
    const [x, y] = [texel % this.attachment.width, Math.floor(texel / this.attachment.width)];
    this.image.centerOn(x, y, 24);
    this.image.handlers.pick?.(x, y);
  }
}

// A field has room for few digits.
function fieldText(value) {
  return Math.abs(value) < 1e-3 || Math.abs(value) >= 1e6 ? value.toExponential(2) : Number(value.toPrecision(4));
}

// What the colours say, and how many values are none.
function legendOf(shading, goTo) {
  const {attachment, values, channels} = shading;
  const parts = [];
  if (shading.kind === "codes") parts.push(codeLegend(shading));
  if (shading.scale) parts.push(scaleLegend(shading.scale));
  if (["position", "normal"].includes(shading.kind)) parts.push(axesLegend(shading));
  const {nan, infinite} = attachment.kind === "display" ? {nan: 0, infinite: 0} : countNotFinite(values);
  if (nan + infinite) parts.push(notFiniteLegend(nan, infinite, () => goTo(firstNotFinite(values, channels))));
  return parts;
}

// Which axis has which colour, and from where to where.
function axesLegend({kind, attachment, axisRanges}) {
  const range = (axis) => kind === "normal" ? "−1 to 1" :
    `${formatNumber(axisRanges[axis].low, 3)} to ${formatWithUnit(axisRanges[axis].high, attachment.channels?.[axis]?.unit)}`;
  return make("p", {class: "axes"}, ["red", "green", "blue"].map((color, axis) =>
    make("span", {}, swatch(["#e33", "#3b3", "#46f"][axis]), ` ${color}: ${channelName(attachment, axis)} ${range(axis)} `)));
}

function swatch(color) {
  return make("span", {class: "swatch", style: `background:${color}`});
}

function codeLegend({attachment, values, channels, channel}) {
  const names = attachment.codes[channel];
  const counts = [...codeCounts(values, channel, channels)].sort((a, b) => a[0] - b[0]);
  return make("ul", {class: "codes"}, counts.filter(([code]) => Number.isFinite(code)).map(([code, count]) =>
    make("li", {}, swatch(namedColor(code)), ` ${code} ${names[code] ?? "not a known value"}: ${wholeNumber(count)}`)));
}

function scaleLegend({low, high, logarithmic, unit}) {
  return make("div", {class: "scale"}, make("span", {}, formatNumber(low)),
    make("span", {class: "bar", style: `background:${viridisGradient()}`}),
    make("span", {}, formatWithUnit(high, unit) + (logarithmic ? ", logarithmic" : "")));
}

function notFiniteLegend(nan, infinite, find) {
  return make("p", {class: "not-finite"}, swatch("#ff00ff"), ` NaN: ${plural(nan, "value")} `,
    swatch("#00ffff"), ` infinite: ${plural(infinite, "value")} `, linkTo("Show the first", find));
}
