// A plane through the scene, and what it cuts. The plane holds the light's direction where it enters and the point
// where it lands.

class ScenePlane {
  constructor(origin, right, up) {
    Object.assign(this, {origin, right, up, normal: cross(right, up)});
  }

  // [x, y] in metres from the origin.
  coordinates(point) {
    const way = minus(point, this.origin);
    return [dot(way, this.right), dot(way, this.up)];
  }

  // Metres from the plane, with a sign.
  distance(point) {
    return dot(minus(point, this.origin), this.normal);
  }
}

// `points`: a way's points in order, two at least.
function planeOfWay(light, points) {
  const first = points[0], last = points.at(-1);
  const along = unit(light.direction ?? (light.position ? minus(first, light.position) : minus(last, first)));
  let widest = [0, 0, 0];
  for (const point of points) {
    const way = minus(point, first);
    const aside = minus(way, times(along, dot(way, along)));
    if (lengthOf(aside) > lengthOf(widest)) widest = aside;
  }
  // Straight through: every plane along the light holds the way.
  const aside = lengthOf(widest) > 1e-6 * (1 + lengthOf(minus(last, first))) ? unit(widest) : across(along);
  return {along, plane: uprightPlane(first, along, aside)};
}

// What is up in the scene is up in the drawing too, unless the plane lies flat: then light comes from above.
function uprightPlane(origin, along, aside) {
  const normal = cross(aside, times(along, -1));
  const upward = minus([0, 1, 0], times(normal, normal[1]));
  const up = lengthOf(upward) > 0.2 ? unit(upward) : times(along, -1);
  return new ScenePlane(origin, cross(up, normal), up);
}

// The line segments in which a plane cuts triangles, [x0, y0, x1, y1, ...] in the plane's coordinates.
function cutMesh(plane, positions, indices) {
  const {heights, flat} = projected(plane, positions);
  const segments = [];
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const corners = [indices[t], indices[t + 1], indices[t + 2]];
    const ends = [];
    for (let e = 0; e < 3; e++) {
      const a = corners[e], b = corners[(e + 1) % 3];
      // A corner on the plane belongs to the side above, so each triangle has no cut edge or two.
      if ((heights[a] >= 0) === (heights[b] >= 0)) continue;
      const share = heights[a] / (heights[a] - heights[b]);
      ends.push(flat[2 * a] + share * (flat[2 * b] - flat[2 * a]),
        flat[2 * a + 1] + share * (flat[2 * b + 1] - flat[2 * a + 1]));
    }
    if (ends.length === 4) segments.push(...ends);
  }
  return segments;
}

// Of each vertex: its distance from the plane, and its coordinates in it.
function projected(plane, positions) {
  const count = positions.length / 3;
  const heights = new Float64Array(count), flat = new Float64Array(2 * count);
  for (let v = 0; v < count; v++) {
    const point = [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
    heights[v] = plane.distance(point);
    [flat[2 * v], flat[2 * v + 1]] = plane.coordinates(point);
  }
  return {heights, flat};
}
