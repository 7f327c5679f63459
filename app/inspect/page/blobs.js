// The arrays that the page carries: base64 of a zlib stream each, decoded when first asked for.

class Blobs {
  // Bytes of decoded arrays that are kept. The oldest go first; they can be decoded again.
  constructor(limit = 700e6) {
    this.limit = limit;
    this.kept = new Map();
    this.bytes = 0;
  }

  // The values of an Array of the recording, or null where the page does not hold it. Half floats come as floats.
  async get(array) {
    if (!array) return null;
    const key = array.blob;
    if (!this.kept.has(key)) {
      const values = decodeArray(array);
      this.kept.set(key, values);
      this.bytes += (await values).byteLength;
      this.forget();
    } else {
      const values = this.kept.get(key);
      this.kept.delete(key);
      this.kept.set(key, values);
    }
    return this.kept.get(key) ?? decodeArray(array);
  }

  async forget() {
    for (const [key, values] of [...this.kept]) {
      if (this.bytes <= this.limit || this.kept.size < 2) return;
      this.kept.delete(key);
      this.bytes -= (await values).byteLength;
    }
  }
}

async function decodeArray(array) {
  const element = document.getElementById(`blob-${array.blob}`);
  if (!element) throw new Error(`the page lacks blob ${array.blob}`);
  return typedValues(await inflate(element.textContent), array.type);
}

async function inflate(text) {
  const stream = new Blob([bytesOfBase64(text.trim())]).stream();
  return new Uint8Array(await new Response(
    stream.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer());
}

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

// The bytes of a value lie in planes, lowest first: bytes alike lie side by side, which packs better.
function typedValues(bytes, type) {
  switch (type) {
    case "u8": return bytes;
    case "f16": return floatsOfHalves(bytes);
    case "u16": return new Uint16Array(joinPlanes(bytes, 2).buffer);
    case "u32": return new Uint32Array(joinPlanes(bytes, 4).buffer);
    case "f32": return new Float32Array(joinPlanes(bytes, 4).buffer);
    default: throw new Error(`unknown array type ${type}`);
  }
}

function joinPlanes(bytes, size) {
  const count = bytes.length / size;
  const joined = new Uint8Array(bytes.length);
  for (let plane = 0; plane < size; plane++) {
    for (let i = 0, from = plane * count, to = plane; i < count; i++, from++, to += size) joined[to] = bytes[from];
  }
  return joined;
}

function floatsOfHalves(bytes) {
  const halves = halfTable();
  const count = bytes.length >> 1;
  const floats = new Float32Array(count);
  for (let i = 0; i < count; i++) floats[i] = halves[bytes[i] | (bytes[count + i] << 8)];
  return floats;
}

let halves = null;

// All 65536 half floats: 1 bit sign, 5 bits exponent, 10 bits fraction (IEEE 754 binary16).
function halfTable() {
  if (halves) return halves;
  halves = new Float32Array(65536);
  for (let bits = 0; bits < 65536; bits++) {
    const exponent = (bits >> 10) & 31;
    const fraction = bits & 1023;
    let size = exponent === 31 ? (fraction ? NaN : Infinity) : 2 ** (exponent - 15) * (1 + fraction / 1024);
    if (exponent === 0) size = fraction * 2 ** -24;
    halves[bits] = bits & 32768 ? -size : size;
  }
  return halves;
}
