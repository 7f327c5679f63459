"""Pictures of light: reading EXR files through oiiotool, box averages, errors, PNG panels. Standard library
only."""
import array
import math
import struct
import subprocess
import sys
import zlib


class Picture:
    """Three planes (red, green, blue) of `size` x `size` floats, rows from the top."""

    def __init__(self, size, planes):
        self.size, self.planes = size, planes

    def total(self):
        return sum(math.fsum(plane) for plane in self.planes)

    def minus(self, other):
        return Picture(self.size, [array.array('f', (a - b for a, b in zip(p, q)))
                                   for p, q in zip(self.planes, other.planes)])

    def scaled(self, factor):
        return Picture(self.size, [array.array('f', (factor * a for a in plane)) for plane in self.planes])

    def boxes(self, side):
        """Means over boxes of `side` x `side` pixels."""
        if side == 1:
            return self
        planes, n = [], self.size
        for plane in self.planes:
            out = array.array('f')
            for y in range(0, n, side):
                rows = [plane[(y + i) * n:(y + i + 1) * n] for i in range(side)]
                column = [math.fsum(values) for values in zip(*rows)]
                out.extend(math.fsum(column[x:x + side]) / (side * side) for x in range(0, n, side))
            planes.append(out)
        return Picture(n // side, planes)


def relative_l1(picture, truth):
    """Sum of |difference| over the sum of the truth, all pixels and channels."""
    return sum(math.fsum(abs(a - b) for a, b in zip(p, q))
               for p, q in zip(picture.planes, truth.planes)) / truth.total()


def read(path, scratch, layer=None):
    """The channels R, G, B of a square EXR file, of a layer where one is named."""
    names = ','.join(f'{layer}.{c}' if layer else c for c in 'RGB')
    plain = scratch / 'plain.exr'
    subprocess.run(['oiiotool', str(path), '--ch', names, '-d', 'float', '--compression', 'none', '-o',
                    str(plain)],
                   check=True, capture_output=True)
    data = plain.read_bytes()
    plain.unlink()
    at = data.index(b'dataWindow\0box2i\0') + len(b'dataWindow\0box2i\0') + 4
    size = struct.unpack('<4i', data[at:at + 16])[2] + 1
    # The file ends with its scanlines: y, bytes, then the row of each channel, by name: blue, green, red.
    planes, row = [array.array('f') for _ in 'BGR'], 8 + 12 * size
    for y in range(size):
        start = len(data) - (size - y) * row + 8
        for c, plane in enumerate(planes):
            plane.frombytes(data[start + 4 * c * size:start + 4 * (c + 1) * size])
    if sys.byteorder == 'big':
        for plane in planes:
            plane.byteswap()
    return Picture(size, planes[::-1])


# ---------------------------------------------------------------- PNG

def exposed(picture, white):
    """Pixels as bytes, `white` lux as bright as can be shown."""
    def byte(v):
        v = min(1.0, max(0.0, v / white))
        return round(255 * (12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055))
    return [bytes(map(byte, pixel)) for pixel in zip(*picture.planes)]


def signed(difference, full):
    """Grey where equal, red where there is too much light, blue where there is too little; pure at `full`
    lux."""
    def pixel(values):
        v = min(1.0, max(-1.0, sum(values) / 3 / full))
        other = round(255 * (0.5 - 0.5 * abs(v)))
        most = round(255 * (0.5 + 0.5 * abs(v)))
        return bytes((most, other, other) if v > 0 else (other, other, most))
    return [pixel(values) for values in zip(*difference.planes)]


def write_png(path, size, rows_of_panels):
    """Rows of panels, each a list of size x size RGB pixels or None for black."""
    black = [bytes(3)] * (size * size)
    lines = []
    for panels in rows_of_panels:
        for y in range(size):
            lines.append(b'\0' + b''.join(b''.join((panel or black)[y * size:(y + 1) * size])
                                          for panel in panels))
    width, height = size * len(rows_of_panels[0]), size * len(rows_of_panels)

    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    path.write_bytes(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR',
                                                  struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0)) +
                     chunk(b'IDAT', zlib.compress(b''.join(lines))) + chunk(b'IEND', b''))
