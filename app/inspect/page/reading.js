// A texel's values in words.

// Channels that mean the same are read together: "where the light lands (0.1, 0, 0.2) metres".
function readingOf(attachment, values, x, y) {
  const channels = Math.round(values.length / (attachment.width * attachment.height));
  const at = (y * attachment.width + x) * channels;
  const texel = texelValues(values, at, channels);
  const parts = [];
  for (let c = 0; c < channels;) {
    const {meaning, unit} = attachment.channels?.[c] ?? {meaning: channelName(attachment, c), unit: ""};
    let end = c + 1;
    while (end < channels && !attachment.codes?.[c] && attachment.channels?.[end]?.meaning === meaning &&
      attachment.channels[end].unit === unit) end++;
    parts.push({meaning: meaning || channelName(attachment, c),
      text: groupText(attachment, texel.slice(c, end), c, unit)});
    c = end;
  }
  return parts;
}

// Bytes stand for the 256 values from 0 to 1 that a screen's texture holds.
function texelValues(values, at, channels) {
  const texel = Array.from(values.subarray(at, at + channels));
  return values instanceof Uint8Array ? texel.map((byte) => Math.fround(byte / 255)) : texel;
}

function groupText(attachment, values, channel, unit) {
  const names = attachment.codes?.[channel];
  if (names) return `${formatNumber(values[0])}, ${names[values[0]] ?? "not a known value"}`;
  const text = values.length > 1 ? formatPoint(values) : formatNumber(values[0]);
  return unit ? `${text} ${unit}` : text;
}

function readingText(attachment, values, x, y) {
  return readingOf(attachment, values, x, y).map((part) => `${part.meaning}: ${part.text}`).join("; ");
}
