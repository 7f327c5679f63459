"""Bodies of revolution about the y axis."""
import math

from making.vectors import unit


def arc(centre, radius, start, end, steps):
    """Points of a circle in the plane of (radius, y), angles in degrees from the radius axis."""
    angles = [math.radians(start + (end - start) * i / steps) for i in range(steps + 1)]
    points = [(centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a)) for a in angles]
    return [(0.0 if abs(r) < 1e-9 else r, y) for r, y in points]


def line(start, end, steps=1):
    return [tuple(a + (b - a) * i / steps for a, b in zip(start, end)) for i in range(steps + 1)]


def revolved(curves, around):
    """The surface that curves of points (radius, y) sweep; each is smooth in itself, and sharp against the
    next. Outside lies to the right of a curve's way in the plane with the radius to the right and y up."""
    positions, normals, indices = [], [], []
    for points in curves:
        first = len(positions)
        for k, (radius, y) in enumerate(points):
            before, after = points[max(k - 1, 0)], points[min(k + 1, len(points) - 1)]
            way = (after[0] - before[0], after[1] - before[1])
            for i in range(around + 1):
                t = 2.0 * math.pi * (i % around) / around
                positions.append((radius * math.cos(t), y, radius * math.sin(t)))
                normals.append(unit((way[1] * math.cos(t), -way[0], way[1] * math.sin(t))))
        for k in range(len(points) - 1):
            for i in range(around):
                a = first + k * (around + 1) + i
                b, c, d = a + 1, a + around + 1, a + around + 2
                if points[k][0] > 0.0:
                    indices += [a, c, b]
                if points[k + 1][0] > 0.0:
                    indices += [b, c, d]
    return positions, normals, indices


def wound(curves, around, top, height):
    """Texture coordinates of what `revolved` makes: u once around the axis, v downwards from a top."""
    return [(i / around, (top - y) / height)
            for points in curves for _, y in points for i in range(around + 1)]
