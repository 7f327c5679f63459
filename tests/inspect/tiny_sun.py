"""The tiny recording's light `sun`: its passes, from the grid to the pixels that its map lights."""
import math

import ball_of_glass as ball
from recording_parts import COVERED, FLUX, STATUS, XYZ, pixel_table
from tiny_picture import HEIGHT, LEFT, LOW, PIXEL, WIDTH, floor_of_pixel, in_shadow, pixels, sees_ball

MAP, MAP_LEFT, MAP_LOW, MAP_TEXEL = 64, 0.0, -0.64, 0.02
SCRIPT = "<script>window.wasRun = true</script>"


def shadow_map(maker):
    """Texel (1, 1): 0.5 passes, 0.75 is behind, one is thrown away, 0.25 passes. Texel (2, 1): 0.5 passes."""
    maker.add_pass(
        "shadow_map[sun]",
        "What opaque surfaces shadow",
        light=0,
        milliseconds=0.7,
        state={"depth": "less, written", "cull": "back"},
        draws=[
            {"mesh": "floor", "material": "chalk"},
            {"mesh": f"ball {SCRIPT}", "material": "leaf, masked"},
        ],
    )
    depths = [1.0] * 16
    depths[5], depths[6] = 0.25, 0.5
    maker.write(
        "shadow_depth[sun]",
        "depth",
        (4, 4),
        depths,
        [{"name": "depth", "meaning": "window depth", "unit": ""}],
        "window depth, 1 where nothing was drawn",
    )
    events = {
        5: [
            (0, 7, 0, 0.5, [0.5]),
            (0, 8, 2, 0.75, [0.75]),
            (1, 2, 1, 0.125, [0.125]),
            (1, 3, 0, 0.25, [0.25]),
        ],
        6: [(0, 7, 0, 0.5, [0.5])],
    }
    maker.write_history((4, 4), events, [1.0], 1, None, draws=True)


def sun_grid(maker, wrong):
    """caster_map, landing: where the light enters and lands, of each grid vertex."""
    ways = {(i, j): ball.way_through(i, j) for j in range(ball.GRID) for i in range(ball.GRID)}
    order = [ways[i, j] for j in range(ball.GRID) for i in range(ball.GRID)]
    size = (ball.GRID, ball.GRID)
    maker.add_pass(
        "caster_map[sun]",
        "The nearest surface of the casters, seen from the light",
        light=0,
        milliseconds=1.4,
        state={"depth": "less, written"},
    )
    entry = maker.write(
        "caster_position[sun]",
        "position",
        size,
        [v for way in order for v in ((*way[0], 1) if way else (0, 0, 0, 0))],
        XYZ + [COVERED],
        "xyz: position, metres, scene space; w: 1 a front face, 0 no caster",
    )
    maker.write(
        "caster_normal[sun]",
        "normal",
        size,
        [v for way in order for v in ((*way[3], 0) if way else (0,) * 4)],
        [{"name": n, "meaning": "unit normal, outward", "unit": ""} for n in "xyz"]
        + [{"name": "w", "meaning": "row of the material", "unit": ""}],
        "xyz: unit normal; w: material",
    )
    maker.add_pass("caster_exit_map[sun]", "Where light can leave the casters", light=0, milliseconds=1.1)
    leaves = maker.write(
        "caster_exit_position[sun]",
        "position",
        size,
        [v for way in order for v in ((*way[1], 1) if way else (0, 0, 0, 0))],
        XYZ + [COVERED],
        "xyz: position, metres; w: 1 a back face",
    )
    maker.add_pass(
        "landing[sun]",
        "Bends the light of each grid vertex and finds where it lands",
        light=0,
        reads=["caster_position[sun]", "caster_normal[sun]", "caster_exit_position[sun]"],
        milliseconds=6.2,
        uniforms=[
            {"name": "search.iterations", "value": 5, "meaning": ""},
            {"name": "light.direction", "value": list(ball.LIGHT), "meaning": "the way of its light"},
        ],
    )
    landings = [v for way in order for v in landing_texel(way)]
    if wrong:
        landings[4 * (12 * ball.GRID + 10)] += 0.25
    landing = maker.write(
        "landing[sun]",
        "status",
        size,
        landings,
        [{"name": n, "meaning": "where the light lands", "unit": "metres"} for n in "xyz"]
        + [{"name": "w", "meaning": "status", "unit": ""}],
        "xyz: where the light lands, metres, scene space; w: status",
        codes={"3": STATUS},
    )
    flux = [v for way in order for v in ([ball.CELL_SIDE**2 * 0.92] * 3 + [1e-5] if way else [0, 0, 0, 0])]
    # Three NaN and one infinity, which a page must show.
    for at in (4 * 45, 4 * 45 + 1, 4 * 700 + 2):
        flux[at] = math.nan
    flux[4 * 801] = math.inf
    maker.write(
        "landing_flux[sun]",
        "flux",
        size,
        flux,
        FLUX + [{"name": "w", "meaning": "gap at the end", "unit": "metres"}],
        "rgb: flux that is left; w: gap between ray and surface at the end, metres",
    )
    return ways, {"name": "", "landing": [landing], "entry": entry, "exit": leaves}


def landing_texel(way):
    if way is None:
        return (0, 0, 0, 0)
    return (*way[2], 1) if way[2] else (0, 0, 0, 4)


def map_events(ways):
    """Each cell's flux over the rectangle around its landings, evenly."""
    events = {}
    for j in range(ball.GRID - 1):
        for i in range(ball.GRID - 1):
            corners = [ways[i, j], ways[i + 1, j], ways[i, j + 1], ways[i + 1, j + 1]]
            if any(way is None or way[2] is None for way in corners):
                continue
            columns = [(way[2][0] - MAP_LEFT) / MAP_TEXEL for way in corners]
            rows = [(way[2][2] - MAP_LOW) / MAP_TEXEL for way in corners]
            lay_rectangle(
                events, j * (ball.GRID - 1) + i, (min(columns), min(rows), max(columns), max(rows))
            )
    return events


def lay_rectangle(events, cell, box):
    x0, y0, x1, y1 = box
    density = ball.CELL_SIDE**2 * 0.92 / max((x1 - x0) * (y1 - y0), 1e-9)
    for y in range(max(0, math.floor(y0)), min(MAP, math.floor(y1) + 1)):
        for x in range(max(0, math.floor(x0)), min(MAP, math.floor(x1) + 1)):
            area = (min(x1, x + 1) - max(x0, x)) * (min(y1, y + 1) - max(y0, y))
            if area > 0:
                events.setdefault(y * MAP + x, []).append((0, cell, 0, 0, [density * area]))


def sun_map(maker, ways):
    events = map_events(ways)
    maker.add_pass(
        "caustic_cells[sun]",
        "Lays each cell into the caustic map",
        light=0,
        reads=["landing[sun]"],
        milliseconds=4.4,
        state={"topology": "rectangles", "blend": "add"},
        draws=[{"mesh": None, "material": None}],
    )
    sums = [ball.total(event[4][0] for event in events.get(texel, [])) for texel in range(MAP * MAP)]
    identity = maker.write(
        "caustic_map[sun]",
        "flux",
        (MAP, MAP),
        sums,
        [{"name": "r", "meaning": "flux in the texel", "unit": "m2"}],
        "r: flux in the texel, relative to the light's intensity",
    )
    history = maker.write_history((MAP, MAP), events, [0.0], 1, "cell")
    return sums, {"attachment": identity, "histories": [history]}


def map_places():
    """By pixel: its corners in texels of the map, or None where it reads nothing there."""
    places = []
    for x, y in pixels():
        left = (LEFT + x * PIXEL - MAP_LEFT) / MAP_TEXEL
        low = (LOW + y * PIXEL - MAP_LOW) / MAP_TEXEL
        side = PIXEL / MAP_TEXEL
        inside = left >= 0 and low >= 0 and left + side <= MAP and low + side <= MAP and not sees_ball(x, y)
        places.append((left, low, left + side, low + side) if inside else None)
    return places


def sun_pixels(maker, places, direct, caustic):
    looks = [[((p[0] + p[2]) / 2 / MAP, (p[1] + p[3]) / 2 / MAP)] if p else [] for p in places]
    return pixel_table(maker.blobs, (WIDTH, HEIGHT), looks, direct, caustic)


def sun_shading(maker, sums, places):
    maker.add_pass(
        "light_shading[sun]",
        "What one light gives to the surfaces that the camera sees",
        light=0,
        reads=["view_position", "view_normal", "shadow_depth[sun]", "caustic_map[sun]"],
        milliseconds=5.0,
        state={"blend": "add"},
    )
    direct, caustic = [], []
    for number, (x, y) in enumerate(pixels()):
        shaded = in_shadow(*floor_of_pixel(x, y)) or sees_ball(x, y)
        direct += [0 if shaded else 43000 * k for k in (1, 0.97, 0.9)] + [0]
        x0, y0, x1, y1 = (round(v) for v in places[number] or (0, 0, 0, 0))
        flux = ball.total(sums[row * MAP + column] for row in range(y0, y1) for column in range(x0, x1))
        lux = 50000 * flux / PIXEL**2 if places[number] else 0
        caustic += [min(60000, lux * k) for k in (1, 0.97, 0.9)] + [0]
    return direct, caustic
