// Points and directions in the scene, as lists of three numbers.

const sum = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const lengthOf = (a) => Math.sqrt(dot(a, a));

function unit(a) {
  const length = lengthOf(a);
  return length > 0 ? times(a, 1 / length) : [0, 0, 0];
}

// Any direction across this one.
function across(a) {
  return unit(cross(a, Math.abs(a[0]) < 0.7 * lengthOf(a) ? [1, 0, 0] : [0, 0, 1]));
}
