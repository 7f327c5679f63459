// What the page shows, kept in the address after "#", so that a link shows the same to somebody else.

const kTexts = ["panel", "pass", "texture", "estimator", "setting", "compare"];
const kNumbers = ["run", "light", "map", "value"];
const kPairs = ["texel", "vertex"];
const kPickKinds = ["pixel", "texel", "vertex", "cell"];

function emptyState() {
  return Object.fromEntries([...kTexts, ...kNumbers, ...kPairs, "pick"].map((key) => [key, null]));
}

function stateOfAddress(hash) {
  const state = emptyState();
  const found = new URLSearchParams(hash.replace(/^#/, ""));
  for (const key of kTexts) state[key] = found.get(key);
  for (const key of kNumbers) state[key] = found.has(key) ? wholeOr(found.get(key), null) : null;
  for (const key of kPairs) state[key] = numbersOf(found.get(key), 2);
  const [kind, numbers] = (found.get("pick") ?? "").split(":");
  const at = numbersOf(numbers, 2);
  if (kPickKinds.includes(kind) && at) state.pick = [kind, ...at];
  return state;
}

function addressOfState(state) {
  const parts = new URLSearchParams();
  for (const key of [...kTexts, ...kNumbers]) if (state[key] !== null) parts.set(key, state[key]);
  for (const key of kPairs) if (state[key]) parts.set(key, state[key].join(","));
  if (state.pick) parts.set("pick", `${state.pick[0]}:${state.pick.slice(1).join(",")}`);
  return "#" + parts.toString();
}

function wholeOr(text, other) {
  return /^\d+$/.test(text ?? "") ? Number(text) : other;
}

function numbersOf(text, count) {
  const numbers = (text ?? "").split(",").map((part) => wholeOr(part, null));
  return numbers.length === count && !numbers.includes(null) ? numbers : null;
}
