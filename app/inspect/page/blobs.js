// The arrays that the page carries: base64 of a zlib stream each, decoded when first asked for.

class Blobs {
  // Bytes of decoded arrays that are kept. The oldest go first; they can be decoded again.
  constructor(limit = 700e6) {
    this.limit = limit;
    this.kept = new Map();
    this.bytes = 0;
  }

  // The values of an Array of the recording, or null where the page does not hold it.
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
  return typedValues(await inflate(element.textContent), array);
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
function typedValues(bytes, {type, channels, beside}) {
  const words = () => {
    const joined = new Uint32Array(joinPlanes(bytes, 4).buffer);
    return channels ? summedUp(joined, channels, beside) : joined;
  };
  switch (type) {
    case "u8": return bytes;
    case "u16": return new Uint16Array(joinPlanes(bytes, 2).buffer);
    case "u32": return words();
    case "f32": return new Float32Array(words().buffer);
    default: throw new Error(`unknown array type ${type}`);
  }
}

// Of words that lie channel after channel, each as the difference from the texel before it (blobs.cpp), what
// they were; "beside": the second and third channel are less the first one's difference, too. All modulo 2^32.
function summedUp(coded, channels, beside) {
  const words = new Uint32Array(coded.length);
  const texels = coded.length / channels;
  for (let c = 0; c < channels; c++) {
    const more = beside && (c === 1 || c === 2);
    let word = 0, first = 0;
    for (let i = 0, at = c, from = c * texels; i < texels; i++, at += channels, from++) {
      const folded = coded[from];
      word = (word + ((folded >>> 1) ^ -(folded & 1))) | 0;
      if (more) {
        word = (word + words[at - c] - first) | 0;
        first = words[at - c];
      }
      words[at] = word;
    }
  }
  return words;
}

function joinPlanes(bytes, size) {
  const count = bytes.length / size;
  const joined = new Uint8Array(bytes.length);
  for (let plane = 0; plane < size; plane++) {
    for (let i = 0, from = plane * count, to = plane; i < count; i++, from++, to += size) joined[to] = bytes[from];
  }
  return joined;
}
