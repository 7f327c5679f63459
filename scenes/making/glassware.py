"""Vessels of glass, as curves for making.revolved: the y axis is theirs, lengths in metres."""
from making.revolved import arc, line


def tumbler(foot, radius=0.30, height=0.75, wall=0.03, base=0.07):
    rim, top = 0.5 * wall, foot + height
    return [line((0.0, foot), (radius, foot), 4),
            line((radius, foot), (radius, top - rim), 8) +
            arc((radius - rim, top - rim), rim, 0, 180, 8)[1:] +
            line((radius - wall, top - rim), (radius - wall, foot + base), 8)[1:],
            line((radius - wall, foot + base), (0.0, foot + base), 4)]


def wine_glass(foot, wall=0.022):
    """A foot, a stem, a round bowl that is open above."""
    bowl, radius = foot + 0.72, 0.30
    outer = arc((0.0, bowl), radius, -84, 50, 28)
    inner = arc((0.0, bowl), radius - wall, 50, -90, 28)
    return [line((0.0, foot), (0.22, foot), 4),
            line((0.22, foot), (0.22, foot + 0.012)) +
            line((0.22, foot + 0.012), (0.03, foot + 0.06), 6)[1:] +
            line((0.03, foot + 0.06), (0.03, foot + 0.40), 6)[1:] + outer,
            line(outer[-1], inner[0]),
            inner]


def bowl(foot, radius=0.42, wall=0.03):
    """Half a shell, open above."""
    centre = foot + radius
    outer, inner = arc((0.0, centre), radius, -90, 0, 24), arc((0.0, centre), radius - wall, 0, -90, 24)
    return [outer, line(outer[-1], inner[0]), inner]


def bottle(foot, wall=0.025, level=0.62):
    """The glass, and the liquid in it up to `level`, which begins within the glass: liquid and glass overlap,
    and the body that was entered last counts."""
    radius, shoulder, neck, top = 0.22, foot + 0.62, 0.08, foot + 1.0
    inside = radius - wall
    outer = (line((radius, foot), (radius, shoulder), 8) +
             line((radius, shoulder), (neck, foot + 0.80), 8)[1:] +
             line((neck, foot + 0.80), (neck, top), 3)[1:])
    inner = (line((neck - wall, top), (neck - wall, foot + 0.80), 3) +
             line((neck - wall, foot + 0.80), (inside, shoulder), 8)[1:] +
             line((inside, shoulder), (inside, foot + 0.06), 8)[1:])
    glass = [line((0.0, foot), (radius, foot), 4), outer, line(outer[-1], inner[0]), inner,
             line((inside, foot + 0.06), (0.0, foot + 0.06), 4)]
    within, surface = inside + 0.3 * wall, foot + level
    liquid = [line((0.0, foot + 0.05), (within, foot + 0.05), 4),
              line((within, foot + 0.05), (within, surface), 8), line((within, surface), (0.0, surface), 4)]
    return glass, liquid
