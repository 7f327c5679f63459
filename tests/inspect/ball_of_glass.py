"""A ball of glass over a floor under slanted parallel light, traced ray by ray: small, and real enough
to look at."""
import functools
import math
import operator

CENTER, RADIUS, INDEX = (0.0, 1.0, 0.0), 0.7, 1.5
LIGHT = (0.5, -math.sqrt(0.75), 0.0)
RIGHT, UP = (math.sqrt(0.75), 0.5, 0.0), (0.0, 0.0, 1.0)
GRID, HALF_WINDOW = 40, 0.75
CELL_SIDE = 2 * HALF_WINDOW / GRID


def plus(a, b, k=1.0):
    return tuple(x + k * y for x, y in zip(a, b))


def total(values):
    """One after the other: sum() rounds otherwise from Python 3.12 on."""
    return functools.reduce(operator.add, values, 0)


def dot(a, b):
    return total(x * y for x, y in zip(a, b))


def refract(way, normal, eta):
    cosine = -dot(way, normal)
    square = 1 - eta * eta * (1 - cosine * cosine)
    if square < 0:
        return None
    return plus(tuple(eta * w for w in way), normal, eta * cosine - math.sqrt(square))


def vertex_ray(i, j):
    """Where the ray of a grid vertex starts, far on the light's side."""
    across = plus(CENTER, RIGHT, (i + 0.5) * CELL_SIDE - HALF_WINDOW)
    return plus(plus(across, UP, (j + 0.5) * CELL_SIDE - HALF_WINDOW), LIGHT, -5.0)


def way_through(i, j):
    """(entry, exit, landing, normal at the entry), or None beside the ball."""
    start = vertex_ray(i, j)
    to = plus(start, CENTER, -1.0)
    half = dot(to, LIGHT)
    inside = half * half - dot(to, to) + RADIUS * RADIUS
    if inside <= 0:
        return None
    entry = plus(start, LIGHT, -half - math.sqrt(inside))
    normal = tuple(x / RADIUS for x in plus(entry, CENTER, -1.0))
    way = refract(LIGHT, normal, 1 / INDEX)
    leave = plus(entry, way, -2 * RADIUS * dot(way, normal))
    outward = tuple(x / RADIUS for x in plus(leave, CENTER, -1.0))
    out = refract(way, tuple(-x for x in outward), INDEX)
    if out is None or out[1] >= 0:
        return entry, leave, None, normal
    return entry, leave, plus(leave, out, -leave[1] / out[1]), normal


def sphere_mesh(rings=24, sectors=36):
    points = [
        (
            CENTER[0] + RADIUS * math.sin(math.pi * r / rings) * math.cos(2 * math.pi * s / sectors),
            CENTER[1] + RADIUS * math.cos(math.pi * r / rings),
            CENTER[2] + RADIUS * math.sin(math.pi * r / rings) * math.sin(2 * math.pi * s / sectors),
        )
        for r in range(rings + 1)
        for s in range(sectors)
    ]
    triangles = []
    for r in range(rings):
        for s in range(sectors):
            a, b = r * sectors + s, r * sectors + (s + 1) % sectors
            triangles += [a, b, a + sectors, b, b + sectors, a + sectors]
    return [x for point in points for x in point], triangles
