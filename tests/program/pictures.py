"""Image files for tests, byte by byte."""

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
