"""A sitting cat as a signed distance."""
import math

from making.vectors import dot, mul, sub


def smooth_min(a, b, k):
    h = max(k - abs(a - b), 0.0) / k
    return min(a, b) - h * h * k / 4


def ellipsoid(p, centre, radii):
    q = sub(p, centre)
    a = math.sqrt(sum((q[k] / radii[k]) ** 2 for k in range(3)))
    b = math.sqrt(sum((q[k] / radii[k] ** 2) ** 2 for k in range(3)))
    return a * (a - 1) / b if b > 1e-9 else -min(radii)


def capsule(p, a, b, ra, rb):
    ab, ap = sub(b, a), sub(p, a)
    t = min(1.0, max(0.0, dot(ap, ab) / dot(ab, ab)))
    d = sub(ap, mul(ab, t))
    return math.sqrt(dot(d, d)) - (ra + (rb - ra) * t)


def sitting_cat(p):
    """Signed distance (nearly) of a sitting cat, 1 m tall, facing +x and a little +z."""
    x, y, z = p
    m = (x, y, abs(z))  # two of each leg and ear
    d = ellipsoid(p, (-0.08, 0.30, 0.0), (0.27, 0.29, 0.24))                       # haunches
    d = smooth_min(d, capsule(p, (0.0, 0.40, 0.0), (0.10, 0.62, 0.0), 0.21, 0.145), 0.12)  # chest
    d = smooth_min(d, ellipsoid(p, (0.17, 0.80, 0.0), (0.165, 0.145, 0.16)), 0.07)  # head
    d = smooth_min(d, ellipsoid(p, (0.315, 0.765, 0.0), (0.06, 0.05, 0.07)), 0.05)  # muzzle
    d = smooth_min(d, capsule(m, (0.14, 0.87, 0.08), (0.13, 0.985, 0.115), 0.075, 0.022), 0.05)  # ears
    d = smooth_min(d, capsule(m, (0.14, 0.42, 0.09), (0.21, 0.06, 0.085), 0.075, 0.052), 0.06)  # forelegs
    d = smooth_min(d, ellipsoid(m, (0.25, 0.045, 0.085), (0.075, 0.045, 0.052)), 0.04)  # forepaws
    d = smooth_min(d, ellipsoid(m, (0.02, 0.16, 0.20), (0.19, 0.15, 0.10)), 0.07)   # thighs
    d = smooth_min(d, ellipsoid(m, (0.16, 0.045, 0.215), (0.10, 0.045, 0.055)), 0.05)  # hind paws
    if y > 0.3:
        return d  # far above the tail
    tail, previous = 1e9, None
    for i in range(13):  # an arc around the haunches, thinning towards its tip
        turn = math.radians(195 - 11 * i)
        point = (-0.08 + 0.40 * math.cos(turn), 0.075 - 0.02 * i / 12, 0.08 + 0.40 * math.sin(turn))
        if previous:
            tail = smooth_min(tail, capsule(p, previous, point, 0.07 - 0.0028 * (i - 1), 0.07 - 0.0028 * i),
                              0.02)
        previous = point
    d = smooth_min(d, tail, 0.06)
    return d
