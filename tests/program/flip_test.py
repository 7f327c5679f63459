"""FLIP as `compare --flip` has it, against the paper's formulas written down a second time: full
two-dimensional filters instead of sums of separable ones, no code in common.

P. Andersson and others, "FLIP: A Difference Evaluator for Alternating Images", 2020, sections 4.1 to 4.5.
"""

import cmath
import json
import math

from pictures import png
from program import ProgramTest, main
from shown import png_channels

PER_DEGREE = 3840 * math.pi / 180
TO_XYZ = [[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
          [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
          [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]]
WHITE = [sum(row) for row in TO_XYZ]
# The inverse of TO_XYZ, to the digits that the authors publish.
FROM_XYZ = [[3.241003275, -1.537398934, -0.498615861], [-0.969224334, 1.875930071, 0.041554224],
            [0.055639423, -0.204011202, 1.057148933]]


def times(matrix, v):
    return [sum(m * x for m, x in zip(row, v)) for row in matrix]


def linear(byte):
    v = byte / 255
    return ((v + 0.055) / 1.055) ** 2.4 if v > 0.04045 else v / 12.92


def ycxcz(rgb):
    x, y, z = (v / w for v, w in zip(times(TO_XYZ, rgb), WHITE))
    return [116 * y - 16, 500 * (x - y), 200 * (y - z)]


def clamped_rgb(color):
    y = (color[0] + 16) / 116
    xyz = [(y + color[1] / 500) * WHITE[0], y * WHITE[1], (y - color[2] / 200) * WHITE[2]]
    return [min(max(v, 0), 1) for v in times(FROM_XYZ, xyz)]


def hunt_lab(rgb):
    x, y, z = (t ** (1 / 3) if t > (6 / 29) ** 3 else t / (3 * (6 / 29) ** 2) + 4 / 29
               for t in (v / w for v, w in zip(times(TO_XYZ, rgb), WHITE)))
    lightness = 116 * y - 16
    return [lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)]


def hyab(a, b):
    return abs(a[0] - b[0]) + math.hypot(a[1] - b[1], a[2] - b[2])


def filtered(values, width, height, weights, radius):
    """Pixels beyond the border are those on it."""
    return [sum(w * values[min(max(y + dy, 0), height - 1) * width + min(max(x + dx, 0), width - 1)]
                for (dx, dy), w in weights.items())
            for y in range(height) for x in range(width)]


def square(radius, weight):
    return {(x, y): weight(x, y) for y in range(-radius, radius + 1) for x in range(-radius, radius + 1)}


def sensitivity(*gaussians):
    radius = math.ceil(3 * math.sqrt(0.04 / (2 * math.pi ** 2)) * PER_DEGREE)
    weights = square(radius, lambda x, y: sum(
        a * math.sqrt(math.pi / b) * math.exp(-math.pi ** 2 * (x * x + y * y) / PER_DEGREE ** 2 / b)
        for a, b in gaussians))
    total = sum(weights.values())
    return {place: w / total for place, w in weights.items()}, radius


def detector(point, down):
    deviation = 0.5 * 0.082 * PER_DEGREE
    radius = math.ceil(3 * deviation)

    def weight(x, y):
        t = y if down else x
        shape = t * t / deviation ** 2 - 1 if point else -t
        return shape * math.exp(-(x * x + y * y) / (2 * deviation ** 2))

    weights = square(radius, weight)
    positive = sum(w for w in weights.values() if w > 0)
    negative = -sum(w for w in weights.values() if w < 0)
    return {place: w / (positive if w > 0 else negative) for place, w in weights.items()}, radius


def strengths(luma, width, height, point):
    return [math.hypot(a, b) for a, b in zip(*(filtered(luma, width, height, *detector(point, down))
                                               for down in (False, True)))]


def flip(test, reference, width, height):
    seen, edges, points = [], [], []
    for picture in (test, reference):
        opponent = list(zip(*(ycxcz([linear(v) for v in pixel]) for pixel in picture)))
        soft = [filtered(plane, width, height, *sensitivity(*gaussians)) for plane, gaussians in
                zip(opponent, ([(1, 0.0047)], [(1, 0.0053)], [(34.1, 0.04), (13.5, 0.025)]))]
        seen.append([hunt_lab(clamped_rgb(color)) for color in zip(*soft)])
        luma = [(v + 16) / 116 for v in opponent[0]]
        edges.append(strengths(luma, width, height, False))
        points.append(strengths(luma, width, height, True))
    largest = hyab(hunt_lab([0, 1, 0]), hunt_lab([0, 0, 1])) ** 0.7
    errors = []
    for i in range(width * height):
        power, knee = hyab(seen[0][i], seen[1][i]) ** 0.7, 0.4 * largest
        color = (0.95 / knee * power if power < knee else
                 0.95 + (power - knee) / (largest - knee) * 0.05)
        feature = max(abs(edges[0][i] - edges[1][i]), abs(points[0][i] - points[1][i]))
        errors.append(color ** (1 - math.sqrt(feature / math.sqrt(2))))
    return errors


def cubehelix(level):
    """D. A. Green, "A colour scheme for the display of astronomical intensity images", 2011, as the map has
    it: from black to white, one and a half turns round the grey line."""
    turn = cmath.exp(2j * math.pi * (0.5 / 3 + 1 - 1.5 * level))
    amplitude = level * (1 - level) / 2
    return [level + amplitude * (a * turn.real + b * turn.imag)
            for a, b in ((-0.14861, 1.78277), (-0.29227, -0.90649), (1.97294, 0))]


class Flip(ProgramTest):
    WIDTH, HEIGHT = 13, 9

    def test_is_what_the_formulas_say(self):
        size = self.WIDTH * self.HEIGHT
        cases = {
            "noise": ([((i * 37) % 256, (i * 91) % 256, (i * 53) % 256) for i in range(size)],
                      [((i * 29) % 256, (i * 83) % 256, (i * 59) % 256) for i in range(size)]),
            "shifted edge": ([(240, 200, 30) if i % self.WIDTH > 5 else (10, 20, 90)
                              for i in range(size)],
                             [(240, 200, 30) if i % self.WIDTH > 6 else (10, 20, 90)
                              for i in range(size)]),
            "a lost point": ([(0, 0, 0)] * size,
                             [(255, 255, 255) if i == size // 2 else (0, 0, 0) for i in range(size)])}
        for name, (test, reference) in cases.items():
            (self.folder / "a.png").write_bytes(png(test, self.WIDTH, self.HEIGHT))
            (self.folder / "b.png").write_bytes(png(reference, self.WIDTH, self.HEIGHT))
            result = self.run_program("compare", "a.png", "b.png", "--flip", "--json")
            figures = json.loads(result.stdout)["layers"][0]["flip"]
            errors = flip(test, reference, self.WIDTH, self.HEIGHT)
            with self.subTest(name):
                # The matrices are published to ten digits, the map is of floats.
                self.assertAlmostEqual(figures["mean"], sum(errors) / size, places=6)
                self.assertAlmostEqual(figures["maximum"], max(errors), places=6)
                self.assertIsNone(figures["exposure"])

    def test_the_map_shows_each_pixels_error_in_the_middle_and_what_is_left_out_in_grey(self):
        size = self.WIDTH * self.HEIGHT
        test, reference = ([((i * a) % 256, (i * b) % 256, 40) for i in range(size)]
                           for a, b in ((37, 91), (29, 83)))
        for name, pixels in (("a.png", test), ("b.png", reference)):
            (self.folder / name).write_bytes(png(pixels, self.WIDTH, self.HEIGHT))
        errors = flip(test, reference, self.WIDTH, self.HEIGHT)
        for left, top, width, height in ((0, 0, self.WIDTH, self.HEIGHT), (2, 1, 5, 3)):
            result = self.run_program("compare", "a.png", "b.png", "--flip", "--diff=d",
                                      f"--region={left},{top},{width},{height}")
            self.assertEqual(result.returncode, 1, result.stderr)
            across, _, channels = png_channels((self.folder / "d_flip.png").read_bytes())
            paper = [values[0] for values in channels.values()]
            begin = (across - self.WIDTH) // 2
            for y in range(self.HEIGHT):
                for x in range(across):
                    shown = [values[y * across + x] for values in channels.values()]
                    at, of = x - begin, y * self.WIDTH + x - begin
                    if not 0 <= at < self.WIDTH:
                        expected = paper
                    elif left <= at < left + width and top <= y < top + height:
                        expected = [255 * v for v in cubehelix(errors[of])]
                    else:
                        expected = [102] * 3  # four tenths
                    for a, b in zip(shown, expected):
                        self.assertAlmostEqual(a, b, delta=1, msg=(x, y, shown, expected))


if __name__ == "__main__":
    main()
