// Colours that people with colour-blindness can tell apart.

// Viridis in 16 steps (van der Walt and Smith 2015), from dark violet through green to yellow: its lightness
// grows evenly, so it reads in grey too.
const kViridis = ["440154", "481a6c", "472f7d", "414487", "39568c", "31688e", "2a788e", "23888e", "1f988b",
  "22a884", "35b779", "54c568", "7ad151", "a5db36", "d2e21b", "fde725"];

// Okabe and Ito 2008, the colours for things with names; the first is for "nothing".
const kNamed = ["#5a6068", "#56b4e9", "#e69f00", "#009e73", "#f0e442", "#0072b2", "#d55e00", "#cc79a7",
  "#ffffff", "#a6761d"];

const kNotANumber = packed(255, 0, 255);
const kInfinite = packed(0, 255, 255);
const kNothing = packed(40, 43, 48);

const kPaletteSize = 1024;
let palette = null;

// A texel as canvases keep it in a 32-bit word: red in the lowest byte.
function packed(red, green, blue) {
  return ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0;
}

function packedHex(text) {
  const value = parseInt(text.replace("#", ""), 16);
  return packed(value >> 16, (value >> 8) & 255, value & 255);
}

function namedColor(code) {
  return kNamed[((code % kNamed.length) + kNamed.length) % kNamed.length];
}

function viridisPalette() {
  if (palette) return palette;
  palette = new Uint32Array(kPaletteSize);
  for (let i = 0; i < kPaletteSize; i++) {
    const at = i / (kPaletteSize - 1) * (kViridis.length - 1);
    const left = Math.min(Math.floor(at), kViridis.length - 2);
    const [a, b] = [packedHex(kViridis[left]), packedHex(kViridis[left + 1])];
    const mix = (shift) => {
      const [from, to] = [(a >> shift) & 255, (b >> shift) & 255];
      return Math.round(from + (to - from) * (at - left));
    };
    palette[i] = packed(mix(0), mix(8), mix(16));
  }
  return palette;
}

function viridisGradient() {
  return `linear-gradient(to right, ${kViridis.map((color) => "#" + color).join(", ")})`;
}

// sRGB (IEC 61966-2-1) of linear values 0 to 1.
function screenValue(linear) {
  const v = clamp(linear, 0, 1);
  return Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
}
