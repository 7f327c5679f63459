// Lines on a logarithmic scale, one for each estimator or setting, named at their ends.

const kPlotWidth = 400, kPlotHeight = 220;
const kPlotMargin = {left: 58, right: 86, top: 12, bottom: 34};
const kLineColors = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
const kSymbols = [
  (x, y) => draw("circle", {cx: x, cy: y, r: 4}),
  (x, y) => draw("rect", {x: x - 4, y: y - 4, width: 8, height: 8}),
  (x, y) => draw("path", {d: `M${x} ${y - 5}L${x + 5} ${y + 4}L${x - 5} ${y + 4}Z`}),
  (x, y) => draw("path", {d: `M${x} ${y - 5}L${x + 5} ${y}L${x} ${y + 5}L${x - 5} ${y}Z`}),
];

// `lines`: [{name, values: [numbers or null]}]; `labels`: of the steps along x. Values that are 0 or none have
// no place on the scale and are left out.
function errorPlot(lines, {labels, unit, title}) {
  const values = lines.flatMap((line) => line.values).filter((v) => v > 0 && Number.isFinite(v));
  if (!values.length) return make("p", {class: "note"}, "No error above 0 to plot.");
  const low = Math.floor(Math.log10(Math.max(Math.min(...values), Math.max(...values) * 1e-12)));
  const high = Math.max(low + 1, Math.ceil(Math.log10(Math.max(...values))));
  const {left, right, top, bottom} = kPlotMargin;
  const xOf = (i) => left + (kPlotWidth - left - right) * (labels.length > 1 ? i / (labels.length - 1) : 0.5);
  const yOf = (v) => top + (kPlotHeight - top - bottom) * (high - clamp(Math.log10(v), low, high)) / (high - low);
  return draw("svg", {class: "plot", viewBox: `0 0 ${kPlotWidth} ${kPlotHeight}`, role: "img", "aria-label": title},
    decades(low, high, yOf, unit), steps(labels, xOf), namedLines(lines, xOf, yOf));
}

function decades(low, high, yOf, unit) {
  const step = Math.max(1, Math.ceil((high - low) / 5));
  const parts = [];
  for (let power = low; power <= high; power += step) {
    const y = yOf(10 ** power);
    parts.push(draw("line", {class: "grid-line", x1: kPlotMargin.left, x2: kPlotWidth - kPlotMargin.right, y1: y, y2: y}),
      draw("text", {class: "tick", x: kPlotMargin.left - 6, y: y + 4, "text-anchor": "end"}, decadeText(power, unit)));
  }
  return parts;
}

function decadeText(power, unit) {
  if (unit === "%") return formatShare(10 ** power);
  if (power === 0) return `1 ${unit}`;
  const raised = String(power).replace("-", "⁻").replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]);
  return `10${raised} ${unit}`;
}

function steps(labels, xOf) {
  const every = Math.ceil(labels.length / 10);
  return labels.map((label, i) => i % every ? null :
    draw("text", {class: "tick", x: xOf(i), y: kPlotHeight - 12, "text-anchor": "middle"}, label));
}

// Names that would lie on each other are moved apart.
function namedLines(lines, xOf, yOf) {
  const names = lines.map((line, number) => {
    const last = line.values.findLastIndex((v) => v > 0 && v < Infinity);
    return {number, last, y: last < 0 ? 0 : yOf(line.values[last])};
  }).filter((name) => name.last >= 0).sort((a, b) => a.y - b.y);
  names.forEach((name, i) => {
    if (i) name.y = Math.max(name.y, names[i - 1].y + 15);
  });
  const tooLow = Math.max(0, (names.at(-1)?.y ?? 0) - (kPlotHeight - kPlotMargin.bottom));
  return names.map(({number, last, y}) => {
    const color = kLineColors[number % kLineColors.length];
    const points = lines[number].values.map((v, i) => v > 0 && v < Infinity ? [xOf(i), yOf(v)] : null).filter(Boolean);
    return draw("g", {stroke: color, fill: color},
      draw("polyline", {class: "line", points: points.map((point) => point.join(",")).join(" ")}),
      points.map(([x, v]) => kSymbols[number % kSymbols.length](x, v)),
      draw("text", {class: "line-name", x: xOf(last) + 9, y: y - tooLow + 4}, lines[number].name));
  });
}
