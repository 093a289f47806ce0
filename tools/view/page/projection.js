// Where things lie on the screen, in doubles. The GPU computes in single precision: it is handed only what is left when
// everything large has been subtracted, rotated and clipped here.

export const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
export const dotProduct = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const crossProduct = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const lengthOf = (a) => Math.hypot(a[0], a[1], a[2]); // neither overflows nor underflows
export const isFinitePoint = (a) => a.every(Number.isFinite);

export function unitOf(a) {
  const length = lengthOf(a);
  return [a[0] / length, a[1] / length, a[2] / length];
}

/// alpha and beta of a pixel; fractions of a pixel, too.
function onPlane(camera, i, j) {
  const share = (k, count) => (camera.samples === "edges" ? k / (count - 1) : (k + 0.5) / count);
  const across = share(i, camera.width);
  const along = share(j, camera.height);
  const [first, last] = camera.rows === "top-first" ? [camera.top, camera.bottom] : [camera.bottom, camera.top];
  return [camera.left + across * (camera.right - camera.left), first + along * (last - first)];
}

export function atPlane(camera, alpha, beta, depth = camera.near) {
  const share = depth / camera.near;
  return plus(times(camera.W, depth), plus(times(camera.U, alpha * share), times(camera.V, beta * share)));
}

/// P of pixel (i, j), eye-relative.
export function pixelPointOf(camera, i, j) {
  return atPlane(camera, ...onPlane(camera, i, j));
}

/// The pixel whose cell holds (alpha, beta) of the image plane; null where there is none.
export function pixelUnder(camera, alpha, beta) {
  const [alpha0, beta0] = onPlane(camera, -0.5, -0.5);
  const [alpha1, beta1] = onPlane(camera, camera.width - 0.5, camera.height - 0.5);
  const i = Math.floor(((alpha - alpha0) / (alpha1 - alpha0)) * camera.width);
  const j = Math.floor(((beta - beta0) / (beta1 - beta0)) * camera.height);
  return i >= 0 && i < camera.width && j >= 0 && j < camera.height ? [i, j] : null;
}

// A viewer: position; axes right, up, forward; window [x0, x1, y0, y1] that fills the screen from left to right and from
// bottom to top, at depth 1 (or, if parallel, at every depth); nearest, the depth below which lines are clipped; start, the
// depth of the plane where sight begins (0: at the position itself).

/// Sees what the camera's picture shows, a whole cell around every sample.
export function eyeViewer(camera) {
  const depth = Math.abs(camera.near);
  const rows = { ...camera, rows: "bottom-first" };
  const [x0, y0] = onPlane(rows, -0.5, -0.5);
  const [x1, y1] = onPlane(rows, camera.width - 0.5, camera.height - 0.5);
  return {
    position: [0, 0, 0], axes: [camera.U, camera.V, times(camera.W, Math.sign(camera.near))],
    window: [x0 / depth, x1 / depth, y0 / depth, y1 / depth],
    nearest: depth / 128, start: camera.origin === "pixel" ? depth : 0, isEye: true,
  };
}

/// The same viewer with a window that has the aspect of the screen and holds the given one in its middle.
export function letterboxed(viewer, aspect, margin = 1) {
  const [x0, x1, y0, y1] = viewer.window;
  const height = margin * Math.max(Math.abs(y1 - y0), Math.abs(x1 - x0) / aspect);
  const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
  const [halfX, halfY] = [(Math.sign(x1 - x0) * height * aspect) / 2, (Math.sign(y1 - y0) * height) / 2];
  return { ...viewer, window: [x - halfX, x + halfX, y - halfY, y + halfY] };
}

const HALF_FIELD = Math.tan(Math.PI / 12);

/// orbit: target, distance, azimuth and elevation about the axes [side, up, back].
export function orbitViewer(orbit, aspect) {
  const [side, up, back] = orbit.axes;
  const level = plus(times(back, Math.cos(orbit.azimuth)), times(side, Math.sin(orbit.azimuth)));
  const outward = plus(times(level, Math.cos(orbit.elevation)), times(up, Math.sin(orbit.elevation)));
  const right = plus(times(side, Math.cos(orbit.azimuth)), times(back, -Math.sin(orbit.azimuth)));
  const half = aspect < 1 ? [HALF_FIELD, HALF_FIELD / aspect] : [HALF_FIELD * aspect, HALF_FIELD];
  return {
    position: plus(orbit.target, times(outward, orbit.distance)), axes: [right, crossProduct(outward, right), times(outward, -1)],
    window: [-half[0], half[0], -half[1], half[1]], nearest: orbit.distance / 4096, start: 0,
  };
}

/// How far away a ball must be to be seen as a whole.
export const distanceToFit = (radius) => radius / Math.sin(Math.atan(HALF_FIELD));

export function parallelViewer(axes, middle, halfWidth, halfHeight) {
  return { position: middle, axes, window: [-halfWidth, halfWidth, -halfHeight, halfHeight], parallel: true, nearest: 0, start: 0 };
}

/// Coordinates along right, up and forward.
export function inView(viewer, point) {
  const from = minus(point, viewer.position);
  return viewer.axes.map((axis) => dotProduct(from, axis));
}

/// [x, y, w]: on the screen at x/w and y/w, each from -1 to 1; w is the depth.
export function homogeneous(viewer, point) {
  const [x0, x1, y0, y1] = viewer.window;
  const [x, y, depth] = inView(viewer, point);
  const w = viewer.parallel ? 1 : depth;
  return [(2 * x - (x0 + x1) * w) / (x1 - x0), (2 * y - (y0 + y1) * w) / (y1 - y0), w];
}

/// Pixels of the screen, from its top left; null where the point is not before the viewer.
export function onScreen(viewer, point, width, height) {
  const [x, y, w] = homogeneous(viewer, point);
  if (!(w > viewer.nearest) || !Number.isFinite(x / w) || !Number.isFinite(y / w)) return null;
  return [((x / w + 1) / 2) * width, ((1 - y / w) / 2) * height];
}

const between = (a, b, t) => a.map((x, k) => x * (1 - t) + b[k] * t);

/// What of a segment of homogeneous points lies on the screen, or a little beside it (Liang and Barsky); null: nothing.
export function clipSegment(a, b, nearest) {
  const beside = 1.25;
  const signed = ([x, y, w]) => [w - nearest, beside * w + x, beside * w - x, beside * w + y, beside * w - y];
  const [fromA, fromB] = [signed(a), signed(b)];
  let [first, last] = [0, 1];
  for (let k = 0; k < fromA.length; ++k) {
    if (fromA[k] < 0 && fromB[k] < 0) return null;
    if (fromA[k] < 0) first = Math.max(first, 1 / (1 - fromB[k] / fromA[k]));
    else if (fromB[k] < 0) last = Math.min(last, 1 / (1 - fromB[k] / fromA[k]));
  }
  return first <= last ? [between(a, b, first), between(a, b, last)] : null;
}

/// A clipped segment in dashes of equal length on the screen.
export function dashed(a, b, width, height) {
  const dash = 5;
  const length = Math.hypot((b[0] / b[2] - a[0] / a[2]) * width, (b[1] / b[2] - a[1] / a[2]) * height) / 2;
  const count = Math.max(1, Math.round(length / dash / 2));
  // A share of the way on the screen is another share of the way in space.
  const inSpace = (share) => (share * a[2]) / (share * a[2] + (1 - share) * b[2]);
  return Array.from({ length: count }, (_, k) => [inSpace(k / count), inSpace((k + 0.5) / count)])
    .map(([from, to]) => [between(a, b, from), between(a, b, to)]);
}

/// The two strokes of an arrow's head at b.
export function arrowHead(a, b, width, height, size = 9) {
  const [dx, dy] = [(b[0] / b[2] - a[0] / a[2]) * width, (b[1] / b[2] - a[1] / a[2]) * height];
  const length = Math.hypot(dx, dy);
  if (!(length > size)) return [];
  return [0.4, -0.4].map((bend) => [b, [
    b[0] - ((2 * size * b[2]) / width) * ((dx - bend * dy) / length), b[1] - ((2 * size * b[2]) / height) * ((dy + bend * dx) / length), b[2],
  ]]);
}

/// The tangents of the directions in which a circle about (across, depth) is seen from the origin; null: not before it.
function seenBetween(across, depth, radius) {
  const distance = Math.hypot(across, depth);
  if (distance <= radius) return [-Infinity, Infinity];
  const [middle, half] = [Math.atan2(across, depth), Math.asin(radius / distance)];
  if (middle - half >= Math.PI / 2 || middle + half <= -Math.PI / 2) return null;
  return [
    middle - half <= -Math.PI / 2 ? -Infinity : Math.tan(middle - half),
    middle + half >= Math.PI / 2 ? Infinity : Math.tan(middle + half),
  ];
}

/// The least window [x0, x1, y0, y1] at depth 1 that holds a sphere, given by its centre in view; null: not before the viewer.
export function sphereWindow([x, y, depth], radius) {
  const across = seenBetween(x, depth, radius);
  const along = across && seenBetween(y, depth, radius);
  return along && [...across, ...along];
}

/// The nearest root of a ray that counts for drawing, from its origin, or null. By the perpendicular T x D: nothing cancels.
export function drawnHit(origin, direction, centre, radius) {
  const T = minus(centre, origin);
  const v = dotProduct(T, direction);
  const miss = lengthOf(crossProduct(T, direction)) / radius;
  if (!(miss <= 1)) return null;
  const d = radius * Math.sqrt((1 - miss) * (1 + miss));
  const s = v - d >= 0 ? v - d : v + d;
  return s >= 0 ? s : null;
}
