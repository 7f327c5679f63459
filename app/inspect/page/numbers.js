// Numbers as people read them.

const kNarrowSpace = "\u202f";

function wholeNumber(value) {
  return String(Math.round(value)).replace(/\B(?=(\d{3})+(?!\d))/g, kNarrowSpace);
}

function formatNumber(value, digits = 4) {
  if (value === null || value === undefined) return "–";
  if (Number.isNaN(value)) return "NaN";
  if (!Number.isFinite(value)) return value > 0 ? "+infinity" : "−infinity";
  if (value === 0) return "0";
  const size = Math.abs(value);
  let text;
  if (size >= 1e4 && size < 1e9) text = wholeNumber(size);
  else if (size >= 1e-4 && size < 1e4) text = String(Number(size.toPrecision(digits)));
  else text = size.toExponential(Math.max(0, digits - 2)).replace("e-", "e−").replace("e+", "e");
  return value < 0 ? "−" + text : text;
}

function formatWithUnit(value, unit) {
  return unit ? `${formatNumber(value)} ${unit}` : formatNumber(value);
}

function formatPoint(point, digits = 3) {
  if (!point) return "–";
  return "(" + Array.from(point, (value) => formatNumber(value, digits)).join(", ") + ")";
}

function formatShare(share) {
  if (!Number.isFinite(share)) return "–";
  const percent = 100 * share;
  if (percent === 0) return "0 %";
  if (Math.abs(percent) < 0.01) return percent > 0 ? "< 0.01 %" : formatNumber(percent, 2) + " %";
  return `${Number(percent.toPrecision(percent >= 99.95 ? 4 : 3))} %`;
}

function formatValues(values, digits = 3) {
  return values.length === 1 ? formatNumber(values[0], digits + 1) : formatPoint(values, digits);
}

function formatMilliseconds(value) {
  if (value === null || value === undefined) return "–";
  return `${value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(1) : value.toFixed(2)} ms`;
}

// A number, or several, as a text, with all its digits for those who ask: `probe` prints the same ones.
function exactly(values, text = formatValues(values)) {
  const digits = Array.from(values, String).join(" ");
  return make("data", {value: digits, title: digits}, text);
}

// The first three channels are colours: one number where they are alike.
function formatColor(color, unit) {
  const alike = color[0] === color[1] && color[0] === color[2];
  return exactly(color, `${alike ? formatNumber(color[0]) : formatPoint(color)} ${unit}`);
}

// Relative luminance of linear Rec. 709 colours; of textures with fewer channels the first one.
function brightness(values, at, channels) {
  if (channels < 3) return values[at];
  return 0.2126 * values[at] + 0.7152 * values[at + 1] + 0.0722 * values[at + 2];
}

function clamp(value, low, high) {
  return Math.min(Math.max(value, low), high);
}
