// Positions on the screen, in doubles. The GPU computes in single precision, so it gets only the
// numbers that are left after everything large has been subtracted, rotated and clipped here.

export const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
export const dotProduct = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const lengthOf = (a) => Math.hypot(a[0], a[1], a[2]); // neither overflows nor underflows
export const unitOf = (a) => a.map((x) => x / lengthOf(a));
export const crossProduct = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/// P of pixel (i, j), which may be fractional.
export const pixelPointOf = ({ first, column, row }, i, j) => plus(first, plus(times(column, i), times(row, j)));

/// The pixel that is seen from the eye in the direction with these tangents; null if there is none.
export function pixelUnder({ window: [x0, x1, y0, y1], width, height, rows }, x, y) {
  const i = Math.floor(((x - x0) / (x1 - x0)) * width);
  const fromBelow = Math.floor(((y - y0) / (y1 - y0)) * height);
  const isSeen = i >= 0 && i < width && fromBelow >= 0 && fromBelow < height;
  return isSeen ? [i, rows === "top-first" ? height - 1 - fromBelow : fromBelow] : null;
}

// A viewer: position; axes right, up, forward; window [x0, x1, y0, y1], which fills the screen from left to right and
// from bottom to top, at depth 1 (if parallel, at any depth); nearest, the depth below which lines are clipped; start,
// the depth of the plane where sight begins (0: at the position).

/// A viewer that shows the camera's picture, enlarged by a factor, with its surroundings, on a
/// screen of this aspect.
export function eyeViewer({ U, V, W, near, window: [x0, x1, y0, y1], origin }, aspect = 0, enlarged = 1) {
  const depth = Math.abs(near);
  const wider = aspect / Math.abs((x1 - x0) / (y1 - y0)) || 1; // than the picture
  const wide = (low, high, by) => [(low + high - by * (high - low)) / 2, (low + high + by * (high - low)) / 2];
  return {
    isEye: true, position: [0, 0, 0], axes: [U, V, times(W, Math.sign(near))], nearest: depth / 128,
    window: [...wide(x0, x1, enlarged * Math.max(wider, 1)), ...wide(y0, y1, enlarged * Math.max(1 / wider, 1))],
    start: origin === "pixel" ? depth : 0,
  };
}

/// The share of the screen that these places fill, from its middle; at least 1 if a place is
/// outside.
export function shareSeen(viewer, places) {
  return Math.max(...places.map((place) => homogeneous(viewer, place))
    .map(([x, y, w]) => (w > 0 ? Math.max(Math.abs(x), Math.abs(y)) / w : 1)));
}

/// Coordinates along right, up and forward.
export function inView(viewer, point) {
  const from = minus(point, viewer.position);
  return viewer.axes.map((axis) => dotProduct(from, axis));
}

/// [x, y, w]: on the screen at x/w and y/w, each from -1 to 1; w is the depth, in units of the nearest.
export function homogeneous(viewer, point) {
  const [x0, x1, y0, y1] = viewer.window;
  const [x, y, depth] = inView(viewer, point).map((length) => length / (viewer.nearest || 1));
  const w = viewer.isParallel ? 1 : depth;
  return [(2 * x - (x0 + x1) * w) / (x1 - x0), (2 * y - (y0 + y1) * w) / (y1 - y0), w];
}

/// Pixels of a screen, from its top left, for a homogeneous point.
export function pixelsOf([x, y, w], { width, height }) {
  return [((x / w + 1) / 2) * width, ((1 - y / w) / 2) * height];
}

/// Where a pane {viewer, width, height} shows a point; null if it does not.
export function onPane(pane, point) {
  const place = homogeneous(pane.viewer, point);
  const [x, y] = pixelsOf(place, pane);
  return place[2] >= 1 && x >= 0 && y >= 0 && x <= pane.width && y <= pane.height ? [x, y] : null;
}

const between = (a, b, t) => a.map((x, k) => x * (1 - t) + b[k] * t);

/// The part of a segment on a pane, or a little beside it, as homogeneous points (Liang and
/// Barsky); null if there is none.
export function clippedSegment({ viewer }, from, to) {
  const beside = 1.25;
  const [a, b] = [homogeneous(viewer, from), homogeneous(viewer, to)];
  const inside = ([x, y, w]) => [w - 1, beside * w + x, beside * w - x, beside * w + y, beside * w - y];
  const [insideA, insideB] = [inside(a), inside(b)];
  let [first, last] = [0, 1];
  for (let k = 0; k < insideA.length; ++k) {
    if (!(insideA[k] >= 0 || insideB[k] >= 0)) return null;
    const crossing = 1 / (1 - insideB[k] / insideA[k]);
    if (insideA[k] < 0) first = Math.max(first, crossing);
    else if (insideB[k] < 0) last = Math.min(last, crossing);
  }
  return first <= last ? [first > 0 ? between(a, b, first) : a, last < 1 ? between(a, b, last) : b] : null;
}

/// The strokes that show a segment {from, to, dashed, arrow} on a pane, as pairs of homogeneous points.
export function strokesOf(pane, segment) {
  const clipped = clippedSegment(pane, segment.from, segment.to);
  if (clipped === null) return [];
  const [a, b] = clipped;
  const [[ax, ay], [bx, by]] = [pixelsOf(a, pane), pixelsOf(b, pane)];
  const length = Math.hypot(bx - ax, by - ay);
  if (!(length > 0.05)) return [];
  const strokes = segment.dashed ? dashes(a, b, Math.max(1, Math.round(length / 10))) : [clipped];
  if (!segment.arrow || length < 9) return strokes;
  return [...strokes, ...arrowHead(b, (bx - ax) / length, (by - ay) / length, pane)];
}

function dashes(a, b, count) {
  // A fraction of the distance on the screen is a different fraction in space.
  const inSpace = (share) => (share * a[2]) / (share * a[2] + (1 - share) * b[2]);
  const at = (k) => between(a, b, inSpace(k / count));
  return Array.from({ length: count }, (_, k) => [at(k), at(k + 0.5)]);
}

function arrowHead(tip, x, y, { width, height }) {
  const long = 9; // pixels
  const [perX, perY] = [(2 * long * tip[2]) / width, (2 * long * tip[2]) / height];
  return [0.4, -0.4].map((bend) => [tip, [tip[0] - perX * (x - bend * y), tip[1] + perY * (y + bend * x), tip[2]]]);
}

/// The smallest window [x0, x1, y0, y1] at depth 1 around a sphere whose centre is in view; null if
/// it is behind.
export function sphereWindow([x, y, depth], radius) {
  const across = seenBetween(x, depth, radius);
  const along = across && seenBetween(y, depth, radius);
  return along && [...across, ...along];
}

/// The tangents of the directions in which a circle about (across, depth) is seen from the origin.
function seenBetween(across, depth, radius) {
  const distance = Math.hypot(across, depth);
  if (distance <= radius) return [-Infinity, Infinity];
  const [middle, half] = [Math.atan2(across, depth), Math.asin(radius / distance)];
  const [low, high] = [middle - half, middle + half];
  if (low >= Math.PI / 2 || high <= -Math.PI / 2) return null;
  return [low <= -Math.PI / 2 ? -Infinity : Math.tan(low), high >= Math.PI / 2 ? Infinity : Math.tan(high)];
}

/// The nearest root >= 0 of a ray, for drawing, or null. Computed from the perpendicular T x D, so
/// that nothing cancels.
export function drawnRoot(origin, direction, centre, radius) {
  const T = minus(centre, origin);
  const v = dotProduct(T, direction);
  const off = lengthOf(crossProduct(T, direction)) / radius;
  const d = radius * Math.sqrt((1 - off) * (1 + off));
  const s = v - d >= 0 ? v - d : v + d;
  return s >= 0 ? s : null;
}
