"""Images, sound and damaged."""
import struct
import zlib

from making.gltf_file import jpeg, png


def png_of(width, height):
    whole = png(1, 1, lambda x, y: (9, 9, 9))
    header = b'IHDR' + struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0)
    return whole[:12] + header + struct.pack('>I', zlib.crc32(header)) + whole[33:]


def images():
    grey = png(3, 2, lambda x, y: (80 * x,), 0)
    yield 'rgb.png', png(4, 4, lambda x, y: (60 * x, 60 * y, 128))
    yield 'rgba.png', png(2, 3, lambda x, y: (60 * x, 60 * y, 128, 90), 6)
    yield 'grey.png', grey
    yield 'grey_alpha.png', png(2, 2, lambda x, y: (60 * x, 99 * y), 4)
    yield 'cut.png', grey[:-20]
    yield 'wide.png', png_of(2 ** 31 - 1, 1)
    yield 'large.png', png_of(256, 256)
    yield 'none.png', png_of(0, 4)
    yield 'damaged.png', grey[:45] + b'\x55' + grey[46:]
    yield 'grey.jpg', jpeg()
    yield 'cut.jpg', jpeg()[:-6]
    yield 'scans.jpg', jpeg()[:-2] + b'\xff\xda' * 250 + b'\xff\xd9'
    yield 'large.jpg', jpeg().replace(struct.pack('>BHH', 8, 8, 8), struct.pack('>BHH', 8, 65535, 65535))
    yield 'other.gif', b'GIF89a\1\0\1\0\0\0\0;'
    yield 'other.webp', b'RIFF\x10\0\0\0WEBPVP8 '
