// What the keys do.

const kKeys = [
  ["1 … 6", "the panels"],
  ["Arrow up, down", "the pass before, after; in other panels the vertex, value or attachment"],
  ["Arrow left, right", "the textures of a pass"],
  ["Shift + arrows", "the chosen texel or pixel, by one"],
  ["+  −", "zoom in, out; the wheel too"],
  ["0", "show the whole"],
  ["[  ]", "less, more exposure"],
  ["P", "large letters and strong contrast, for a projector"],
  ["Tab, Enter", "go through all controls, use one"],
  ["?", "this help"],
];

function makeHelp() {
  const close = make("button", {type: "button", onclick: () => dialog.close()}, "Close");
  const dialog = make("dialog", {class: "help", "aria-label": "Help"}, make("h2", {}, "Keys"),
    make("dl", {}, kKeys.map(([key, does]) => [make("dt", {}, key), make("dd", {}, does)])),
    paragraph("The address in the browser holds what you see: copy it to show somebody the same."),
    paragraph("Texels and pixels are counted from the bottom left, x to the right, y up, from 0."), close);
  return dialog;
}
