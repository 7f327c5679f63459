"""Shapes: positions, normals, indices."""
import math

from making.vectors import add, cross, mul, sub, unit


def square(half, y=0.0):
    p = [(-half, y, half), (half, y, half), (half, y, -half), (-half, y, -half)]
    return p, [(0.0, 1.0, 0.0)] * 4, [0, 1, 2, 0, 2, 3]


def icosphere(centre, radius, levels):
    """20 * 4^levels triangles with the sphere's own normals."""
    g = (1 + math.sqrt(5)) / 2
    points = [unit(p) for p in ((-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
                                (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1))]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
             (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5),
             (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                points.append(unit(add(points[a], points[b])))
            return middles[key]

        finer = []
        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return ([add(centre, mul(p, radius)) for p in points], points, [i for f in faces for i in f])


def flat_faces(polygons):
    """A closed body of flat polygons, each counter-clockwise from outside."""
    positions, normals, indices = [], [], []
    for polygon in polygons:
        n = unit(cross(sub(polygon[1], polygon[0]), sub(polygon[2], polygon[0])))
        first = len(positions)
        positions += polygon
        normals += [n] * len(polygon)
        for i in range(2, len(polygon)):
            indices += [first, first + i - 1, first + i]
    return positions, normals, indices


def box(lower, upper):
    (a, b, c), (d, e, f) = lower, upper
    return flat_faces([[(a, e, f), (d, e, f), (d, e, c), (a, e, c)],
                       [(a, b, c), (d, b, c), (d, b, f), (a, b, f)],
                       [(a, b, f), (d, b, f), (d, e, f), (a, e, f)],
                       [(d, b, c), (a, b, c), (a, e, c), (d, e, c)],
                       [(d, b, f), (d, b, c), (d, e, c), (d, e, f)],
                       [(a, b, c), (a, b, f), (a, e, f), (a, e, c)]])


def sheet(half, height, slope, cells):
    """An open surface y = height(x, z) with exact normals; slope(x, z) gives its two derivatives."""
    positions, normals, indices = [], [], []
    for j in range(cells + 1):
        for i in range(cells + 1):
            x, z = -half + 2 * half * i / cells, half - 2 * half * j / cells
            dx, dz = slope(x, z)
            positions.append((x, height(x, z), z))
            normals.append(unit((-dx, 1.0, -dz)))
    for j in range(cells):
        for i in range(cells):
            a = j * (cells + 1) + i
            b, c, d = a + 1, a + cells + 2, a + cells + 1
            indices += [a, b, c, a, c, d]
    return positions, normals, indices


def ring(inner, outer, height, cells):
    """A flat-topped ring around the y axis that stands on y = 0; its walls have the cylinders' normals."""
    positions, normals, indices = [], [], []

    def band(a, b):
        """A strip around the axis between two profiles (radius, y, radial normal, upward normal)."""
        first = len(positions)
        for i in range(cells + 1):
            t = 2 * math.pi * i / cells
            for radius, y, radial, up in (a, b):
                positions.append((radius * math.cos(t), y, radius * math.sin(t)))
                normals.append((radial * math.cos(t), up, radial * math.sin(t)))
        for i in range(cells):
            k = first + 2 * i
            indices.extend((k, k + 1, k + 3, k, k + 3, k + 2))

    band((outer, 0.0, 1.0, 0.0), (outer, height, 1.0, 0.0))
    band((outer, height, 0.0, 1.0), (inner, height, 0.0, 1.0))
    band((inner, height, -1.0, 0.0), (inner, 0.0, -1.0, 0.0))
    band((inner, 0.0, 0.0, -1.0), (outer, 0.0, 0.0, -1.0))
    return positions, normals, indices


def torus(centre, major, minor, axis, cells):
    """A torus around `axis` through `centre`, with its own normals."""
    z = unit(axis)
    x = unit(cross((0.0, 0.0, 1.0) if abs(z[2]) < 0.9 else (0.0, 1.0, 0.0), z))
    y = cross(z, x)
    around, across = 2 * cells, cells
    positions, normals, indices = [], [], []
    for i in range(around):
        a = 2 * math.pi * i / around
        out = add(mul(x, math.cos(a)), mul(y, math.sin(a)))
        for j in range(across):
            b = 2 * math.pi * j / across
            n = add(mul(out, math.cos(b)), mul(z, math.sin(b)))
            positions.append(add(centre, add(mul(out, major), mul(n, minor))))
            normals.append(n)
            p, q = i * across + j, i * across + (j + 1) % across
            r, s = (i + 1) % around * across + j, (i + 1) % around * across + (j + 1) % across
            indices.extend((p, r, s, p, s, q))
    return positions, normals, indices


def upright(x, half, low, high):
    """A rectangle across the x axis."""
    p = [(x, low, half), (x, low, -half), (x, high, -half), (x, high, half)]
    return p, [(1.0, 0.0, 0.0)] * 4, [0, 1, 2, 0, 2, 3]


def surface_of(field, lower, upper, cells):
    """The closed surface field = 0 (negative inside) by surface nets: one vertex a cell that the surface
    crosses, moved onto it; normals from the field's gradient."""
    size = [upper[k] - lower[k] for k in range(3)]
    step = max(size) / cells
    n = [int(math.ceil(size[k] / step)) + 1 for k in range(3)]

    def at(i, j, k): return (lower[0] + i * step, lower[1] + j * step, lower[2] + k * step)

    def gradient(p):
        h = 0.25 * step
        return unit(tuple((field(add(p, d)) - field(sub(p, d)))
                          for d in ((h, 0, 0), (0, h, 0), (0, 0, h))))

    values = [[[field(at(i, j, k)) for k in range(n[2])] for j in range(n[1])] for i in range(n[0])]
    positions, normals, indices, vertex = [], [], [], {}

    def vertex_of(i, j, k):
        if (i, j, k) in vertex:
            return vertex[(i, j, k)]
        crossings = []
        corners = [(a, b, c) for a in (0, 1) for b in (0, 1) for c in (0, 1)]
        for a in corners:
            for axis in range(3):
                if a[axis]:
                    continue
                b = tuple(a[m] + (m == axis) for m in range(3))
                fa = values[i + a[0]][j + a[1]][k + a[2]]
                fb = values[i + b[0]][j + b[1]][k + b[2]]
                if (fa < 0) != (fb < 0):
                    t = fa / (fa - fb)
                    crossings.append(tuple(a[m] + t * (b[m] - a[m]) for m in range(3)))
        p = at(*(x + sum(c[m] for c in crossings) / len(crossings)
                 for m, x in enumerate((i, j, k))))
        for _ in range(3):  # onto the surface
            g = gradient(p)
            p = sub(p, mul(g, field(p)))
        vertex[(i, j, k)] = len(positions)
        positions.append(p)
        normals.append(gradient(p))
        return vertex[(i, j, k)]

    for i in range(n[0] - 1):
        for j in range(n[1] - 1):
            for k in range(n[2] - 1):
                for axis in range(3):
                    here = (i, j, k)
                    there = tuple(here[m] + (m == axis) for m in range(3))
                    a, b = values[i][j][k], values[there[0]][there[1]][there[2]]
                    if (a < 0) == (b < 0):
                        continue
                    u, v = (axis + 1) % 3, (axis + 2) % 3
                    cells_around = []
                    for du, dv in ((0, 0), (-1, 0), (-1, -1), (0, -1)):
                        cell = list(here)
                        cell[u] += du
                        cell[v] += dv
                        cells_around.append(vertex_of(*cell))
                    if a >= 0:
                        cells_around.reverse()
                    q = cells_around
                    indices += [q[0], q[1], q[2], q[0], q[2], q[3]]
    edges = {}
    for t in range(0, len(indices), 3):
        for e in range(3):
            pair = (indices[t + e], indices[t + (e + 1) % 3])
            edges[pair] = edges.get(pair, 0) + 1
    assert all(edges.get((b, a)) == count == 1 for (a, b), count in edges.items()), 'not a closed manifold'
    return positions, normals, indices


def equilateral_prism(edge, length, height, travel, incidence):
    """Faces of a prism along z whose left face leans so that light along `travel` meets it at `incidence`
    degrees."""
    h = edge * math.sqrt(3) / 2
    corners = [(-edge / 2, -h / 3), (edge / 2, -h / 3), (0.0, 2 * h / 3)]
    normal_angle = math.atan2(travel[1], travel[0]) + math.pi - math.radians(incidence)
    turn = normal_angle - math.radians(150)  # the left face's outward normal is at 150 degrees

    def placed(x, y, z):
        c, w = math.cos(turn), math.sin(turn)
        return (c * x - w * y, w * x + c * y + height, z)

    front = [placed(x, y, length / 2) for x, y in corners]
    back = [placed(x, y, -length / 2) for x, y in corners]
    faces = [front, [back[0], back[2], back[1]]]
    for i in range(3):
        j = (i + 1) % 3
        faces.append([front[i], back[i], back[j], front[j]])
    return flat_faces(faces)


def lens(radius, sphere_radius, segments, rings):
    """A biconvex lens around the y axis and the origin: two caps of spheres, with the spheres' normals."""
    drop = math.sqrt(sphere_radius ** 2 - radius ** 2)
    half_angle = math.asin(radius / sphere_radius)
    positions, normals, indices = [], [], []
    for side in (1.0, -1.0):
        first = len(positions)
        for i in range(rings + 1):
            a = half_angle * i / rings
            for j in range(segments if i else 1):
                b = 2 * math.pi * j / segments
                n = (math.sin(a) * math.cos(b), side * math.cos(a), math.sin(a) * math.sin(b))
                positions.append((sphere_radius * n[0], sphere_radius * n[1] - side * drop,
                                  sphere_radius * n[2]))
                normals.append(n)
        for i in range(rings):
            for j in range(segments):
                k = (j + 1) % segments
                a, b = first + 1 + (i - 1) * segments, first + 1 + i * segments
                faces = [(first, b + k, b + j)] if i == 0 else [(a + j, a + k, b + k), (a + j, b + k, b + j)]
                for f in faces:
                    indices += f if side > 0 else f[::-1]
    return positions, normals, indices


def lens_along(centre, axis, radius, curvature, cells):
    """A biconvex lens with an edge that tapers to nothing: two caps of spheres, with the spheres' own
    normals."""
    z = unit(axis)
    x = unit(cross((0.0, 0.0, 1.0) if abs(z[2]) < 0.9 else (0.0, 1.0, 0.0), z))
    y = cross(z, x)
    depth = curvature - math.sqrt(curvature ** 2 - radius ** 2)  # of one cap
    positions, normals, indices = [], [], []
    for side in (1.0, -1.0):
        middle = add(centre, mul(z, side * (depth - curvature)))
        first = len(positions)
        rings, around = cells, 4 * cells
        for i in range(rings + 1):
            r = radius * i / rings
            for j in range(1 if i == 0 else around):
                turn = 2 * math.pi * j / around
                out = add(mul(x, r * math.cos(turn)), mul(y, r * math.sin(turn)))
                n = unit(add(out, mul(z, side * math.sqrt(curvature ** 2 - r * r))))
                positions.append(add(middle, mul(n, curvature)))
                normals.append(n)

        def at(i, j): return first if i == 0 else first + 1 + (i - 1) * around + j % around

        for i in range(rings):
            for j in range(around):
                a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
                faces = [(a, b, c)] + ([(a, c, d)] if i else [])
                for f in faces:
                    indices += f if side > 0 else (f[0], f[2], f[1])
    return positions, normals, indices


def holed_board(centre, axis, hole, half, thickness, cells):
    """A square board across `axis` with a round hole, its walls included."""
    z = unit(axis)
    x = unit(cross((0.0, 1.0, 0.0), z))
    y = cross(z, x)
    inner, outer = [], []
    for j in range(cells):
        c, w = math.cos(2 * math.pi * j / cells), math.sin(2 * math.pi * j / cells)
        reach = half / max(abs(c), abs(w))
        inner.append((hole * c, hole * w))
        outer.append((reach * c, reach * w))

    def placed(p, side):
        return add(add(centre, add(mul(x, p[0]), mul(y, p[1]))), mul(z, 0.5 * side * thickness))

    faces = []
    for j in range(cells):
        k = (j + 1) % cells
        for side in (1, -1):
            quad = [placed(inner[j], side), placed(outer[j], side), placed(outer[k], side),
                    placed(inner[k], side)]
            faces.append(quad if side > 0 else quad[::-1])
        faces.append([placed(inner[j], 1), placed(inner[k], 1), placed(inner[k], -1), placed(inner[j], -1)])
        faces.append([placed(outer[j], -1), placed(outer[k], -1), placed(outer[k], 1), placed(outer[j], 1)])
    return flat_faces(faces)


def room(lower, upper):
    """The six sides of a room, seen from inside: name and shape."""
    positions, _, _ = box(lower, upper)
    names = ('ceiling', 'floor', 'front wall', 'back wall', 'right wall', 'left wall')
    for i, name in enumerate(names):
        yield name, flat_faces([positions[4 * i:4 * i + 4][::-1]])
