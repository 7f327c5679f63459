"""Image files for tests, byte by byte: made, and read."""

import itertools
import struct
import zlib


def exr(channels, width, height):
    """An uncompressed OpenEXR file of 32-bit floats: {name: values by rows from the top}."""
    names = sorted(channels)

    def attribute(name, kind, value):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value

    listed = b"".join(name.encode() + b"\0" + struct.pack("<iiii", 2, 0, 1, 1) for name in names)
    window = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    head = struct.pack("<ii", 20000630, 2) + b"".join([
        attribute("channels", "chlist", listed + b"\0"), attribute("compression", "compression", b"\0"),
        attribute("dataWindow", "box2i", window), attribute("displayWindow", "box2i", window),
        attribute("lineOrder", "lineOrder", b"\0"),
        attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0)),
        attribute("screenWindowWidth", "float", struct.pack("<f", 1))]) + b"\0"
    row = 8 + 4 * width * len(names)
    offsets = struct.pack(f"<{height}Q", *(len(head) + 8 * height + y * row for y in range(height)))
    body = b""
    for y in range(height):
        values = [v for name in names for v in channels[name][y * width:(y + 1) * width]]
        body += struct.pack("<ii", y, row - 8) + struct.pack(f"<{len(values)}f", *values)
    return head + offsets + body


def png(pixels, width, height):
    """An 8-bit RGB file: [(r, g, b), ...] by rows from the top."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))

    rows = b"".join(b"\0" + bytes(v for pixel in pixels[y * width:(y + 1) * width] for v in pixel)
                    for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Exr:
    """An OpenEXR file of 32-bit floats, stored or deflated in scanlines. Raises an error on anything else,
    and on anything that is missing."""

    def __init__(self, data):
        assert data[:8] == struct.pack("<ii", 20000630, 2), "no plain OpenEXR file"
        at, head = 8, {}
        while data[at]:
            name, kind, _ = data[at:at + 600].split(b"\0", 2)
            at += len(name) + len(kind) + 2
            size, = struct.unpack_from("<i", data, at)
            head[name.decode()] = data[at + 4:at + 4 + size]
            at += 4 + size
        left, self.top, right, self.bottom = struct.unpack("<iiii", head["dataWindow"])
        self.width, self.height = right - left + 1, self.bottom - self.top + 1
        self.rows_a_chunk = {0: 1, 2: 1, 3: 16}[head["compression"][0]]
        self.names, rest = [], head["channels"]
        while rest[0]:
            name, rest = rest.split(b"\0", 1)
            assert struct.unpack_from("<i", rest)[0] == 2, "a channel is not of 32-bit floats"
            self.names.append(name.decode())
            rest = rest[16:]
        self.data, self.chunks_at = data, at + 1

    def chunks(self):
        """(rows, bytes, whether they were deflated) from the top."""
        for number in range(-(-self.height // self.rows_a_chunk)):
            place, = struct.unpack_from("<Q", self.data, self.chunks_at + 8 * number)
            first, size = struct.unpack_from("<ii", self.data, place)
            assert first == self.top + number * self.rows_a_chunk, "a chunk is out of its place"
            rows = min(self.rows_a_chunk, self.bottom + 1 - first)
            whole = 4 * rows * len(self.names) * self.width
            chunk = self.data[place + 8:place + 8 + size]
            deflated = size < whole
            if deflated:
                chunk = zlib.decompress(chunk)
            assert len(chunk) == whole, "a chunk is cut short"
            yield rows, chunk, deflated

    def values(self):
        """{channel: values by rows from the top}."""
        channels = {name: [] for name in self.names}
        for rows, chunk, deflated in self.chunks():
            if deflated:  # differences, and the bytes of even places before those of odd ones
                summed = bytes(itertools.accumulate(chunk, lambda a, b: (a + b - 128) % 256))
                plain, half = bytearray(len(summed)), (len(summed) + 1) // 2
                plain[0::2], plain[1::2] = summed[:half], summed[half:]
                chunk = bytes(plain)
            values = struct.unpack(f"<{len(chunk) // 4}f", chunk)
            for i in range(rows * len(self.names)):
                channels[self.names[i % len(self.names)]] += values[i * self.width:(i + 1) * self.width]
        return channels
