// What the figure holds, as segments, points, spheres and names in eye-relative doubles.
import { dotProduct, drawnRoot, lengthOf, minus, pixelPointOf, plus, seenThrough, times, unitOf } from "./projection.js";

/// The layers that can be switched, with their names.
export const LAYERS = {
  frustum: "frustum", axes: "axes", pixels: "pixels", spheres: "spheres", hits: "hit points",
  roots: "T, v, d, roots", names: "names",
};
const MOST_PIXELS_ACROSS = 96; // more are thinned, and the figure says so
const MOST_RAYS_ACROSS = 24;
const ORDINARY = 50; // what reaches farther than so many sizes of the frustum is left out of views of the whole
const MOST_NAMED_SPHERES = 24;

/// layers.rays: "none", "pixel", "row" or "all". The list's `whole` are points that a view of the whole shows, its
/// `notes` sentences about what is not drawn as it is; a thing that has `select` is chosen by a click.
export function drawList(scene, selection, panel, layers, palette) {
  const { camera, rays } = scene.figure;
  const list = {
    scene, selection, layers, palette, camera, size: sizeOf(scene.figure), isOutOfScale: false,
    axes: camera ? [camera.U, camera.V, camera.W] : [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    whole: camera ? [] : rays.map((ray) => ray.origin), segments: [], points: [], spheres: [], names: [], notes: [],
  };
  if (camera) addCamera(list);
  addSpheres(list);
  list.reach = Math.max(...list.whole.map(lengthOf)) || list.size;
  if (camera && layers.pixels) addPixels(list);
  for (const ray of raysShown(list)) addRay(list, ray);
  if (layers.roots && panel) addDrawing(list, panel.drawing, scene.figure.spheres.centre[panel.sphere]);
  return withoutInfinities(list);
}

function sizeOf({ camera, rays, spheres }) {
  if (camera) return Math.max(...cornersAt(camera, camera.far ?? camera.near).map(lengthOf));
  const places = [...rays.map((ray) => ray.origin), ...spheres.centre.slice(0, 1)];
  return Math.max(...places.map(lengthOf), ...spheres.radius.slice(0, 1)) || 1;
}

/// The frustum's corners at a depth, enlarged about its middle.
function cornersAt(camera, depth, enlarged = 1) {
  const at = (low, high, sign) => (low + high + sign * enlarged * (high - low)) / 2;
  return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) =>
    seenThrough(camera, at(camera.left, camera.right, x), at(camera.bottom, camera.top, y), depth));
}

const isOrdinary = (list, centre, radius) => lengthOf(centre) + radius <= ORDINARY * list.size;

/// style: isThick, isDashed, hasArrow, select.
function addLine(list, from, to, colour, style = {}) {
  list.segments.push({ from, to, colour, ...style });
}

function addOutline(list, corners, colour, style) {
  corners.forEach((corner, k) => addLine(list, corner, corners[(k + 1) % corners.length], colour, style));
}

function addPoint(list, at, colour, shape, size, select = null) {
  list.points.push({ at, colour, shape, size, select });
}

function addName(list, at, text, colour = list.palette.ink, sphere = null) {
  list.names.push({ at, text, colour, sphere });
}

function addCamera(list) {
  const { camera, palette } = list;
  const near = cornersAt(camera, camera.near);
  list.whole.push([0, 0, 0], ...near, ...(isOrdinary(list, camera.look_at, 0) ? [camera.look_at] : []));
  if (camera.far !== null) list.whole.push(...cornersAt(camera, camera.far));
  if (lengthOf(minus(near[0], near[2])) < lengthOf(near[0]) / ORDINARY) {
    list.isOutOfScale = true;
    list.notes.push("From outside the image plane is next to a point, so narrow it is; the view from the eye shows it.");
  }
  if (list.layers.frustum) addFrustum(list, near);
  if (list.layers.axes) {
    const long = 0.4 * Math.abs(camera.near);
    addAxis(list, times(camera.U, long), "U", palette.orange);
    addAxis(list, times(camera.V, long), "V", palette.green);
    addAxis(list, times(camera.W, long), "W (view-plane normal)", palette.blue);
    addAxis(list, times(unitOf(camera.up), 1.35 * long), "up vector", palette.gold, { isDashed: true });
  }
}

function addAxis(list, tip, text, colour, style = { isThick: true }) {
  list.whole.push(tip);
  addLine(list, [0, 0, 0], tip, colour, { hasArrow: true, ...style });
  addName(list, tip, text, colour);
}

function addFrustum(list, near) {
  const { camera, palette } = list;
  addPoint(list, [0, 0, 0], palette.ink, "disc", 11);
  addName(list, [0, 0, 0], "eye E");
  addName(list, [0, 0, 0], "focal point (the eye)");
  near.forEach((corner) => addLine(list, [0, 0, 0], corner, palette.faint));
  addOutline(list, near, palette.blue, { isThick: true });
  addName(list, near[3], "near clipping plane", palette.blue);
  addName(list, near[1], "bounded image plane", palette.blue);
  const plane = cornersAt(camera, camera.near, 1.5);
  addOutline(list, plane, palette.blue, { isDashed: true });
  addName(list, plane[2], "view plane", palette.blue);
  addLine(list, [0, 0, 0], camera.look_at, palette.faint, { isDashed: true });
  addPoint(list, camera.look_at, palette.ink, "cross", 12);
  addName(list, camera.look_at, "look-at point A");
  if (camera.far === null) return;
  const far = cornersAt(camera, camera.far);
  near.forEach((corner, k) => addLine(list, corner, far[k], palette.faint));
  addOutline(list, far, palette.purple, { isThick: true });
  addName(list, plus(times(far[2], 0.75), times(far[3], 0.25)), "far clipping plane", palette.purple);
}

function addSpheres(list) {
  const { spheres, spheres_left_out: leftOut } = list.scene.figure;
  const count = spheres.centre.length;
  let beyond = 0;
  spheres.centre.forEach((centre, index) => {
    const [radius, isChosen] = [spheres.radius[index], list.selection.sphere === index];
    const surroundsEye = lengthOf(centre) < radius;
    if (!isOrdinary(list, centre, radius)) beyond += 1;
    else if (!surroundsEye) {
      list.whole.push(...list.axes.flatMap((axis) => [1, -1].map((sign) => plus(centre, times(axis, sign * radius)))));
    }
    if (!list.layers.spheres) return;
    list.spheres.push({ index, centre, radius, colour: rgbOf(spheres.colour[index]), surroundsEye });
    if (count <= MOST_NAMED_SPHERES || isChosen) addName(list, centre, `sphere ${index}`, list.palette.ink, index);
    if (surroundsEye) list.notes.push(`Sphere ${index} surrounds the eye; from outside only its far half is drawn.`);
  });
  if (beyond > 0) {
    list.notes.push(`${beyond} of ${count} spheres reach so far that no view holds all to scale; go to one of them.`);
  }
  if (leftOut > 0) list.notes.push(`${leftOut} more spheres are not in this page.`);
  list.isOutOfScale ||= beyond > 0 && beyond === count;
}

/// Red, green and blue, from 0 to 1, of "#rrggbb".
export function rgbOf(hex) {
  return [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16) / 255);
}

/// From red, the first, to magenta, the last, as the lecture has it.
function rainbow(k, count) {
  const hue = (5 * k) / Math.max(count - 1, 1);
  return [0, 4, 2].map((turn) => Math.min(Math.max(Math.abs(((hue + turn) % 6) - 3) - 1, 0), 1));
}

/// Indices below count, every so manieth, at most `most`; what is left out is told.
function thinned(list, count, most, things) {
  const step = Math.ceil(count / most);
  if (step > 1) list.notes.push(`Of ${count} ${things} every ${step}th is drawn.`);
  return Array.from({ length: Math.ceil(count / step) }, (_, k) => k * step);
}

function addPixels(list) {
  const { camera, palette, selection } = list;
  const columns = thinned(list, camera.width, MOST_PIXELS_ACROSS, "columns of pixels");
  const rows = thinned(list, camera.height, MOST_PIXELS_ACROSS, "rows of pixels");
  const size = Math.min(9, Math.max(3, 240 / Math.max(columns.length, rows.length)));
  for (const { at, colour, select } of rows.flatMap((j) => columns.map((i) => pixelOf(camera, i, j)))) {
    addPoint(list, at, colour, "disc", size, select);
  }
  addName(list, pixelPointOf(camera, 0, 0), "pixel (0, 0)");
  if (selection.pixel === null) return;
  const [i, j] = selection.pixel;
  const cell = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]].map(([x, y]) => pixelPointOf(camera, i + x, j + y));
  addOutline(list, cell, palette.ink, { isThick: true });
  if (i + j > 0) addName(list, pixelPointOf(camera, i, j), `pixel (${i}, ${j})`);
}

function pixelOf(camera, i, j) {
  const index = j * camera.width + i;
  const colour = rainbow(index, camera.width * camera.height);
  return { index, at: pixelPointOf(camera, i, j), colour, select: { pixel: [i, j] } };
}

/// The rays to draw: {origin, direction, colour, select, index}.
function raysShown(list) {
  const { camera, selection, layers, scene } = list;
  if (layers.rays === "none") return [];
  if (!camera) {
    const { rays } = scene.figure;
    return rays.map((ray, index) => ({ ...ray, index, colour: rainbow(index, rays.length), select: { ray: index } }))
      .filter(({ index }) => layers.rays === "all" || index === selection.ray);
  }
  const [chosenI, chosenJ] = selection.pixel ?? [0, 0];
  const columns = layers.rays === "pixel" ? [chosenI] : thinned(list, camera.width, MOST_RAYS_ACROSS, "columns of rays");
  const rows = layers.rays === "all" ? thinned(list, camera.height, MOST_RAYS_ACROSS, "rows of rays") : [chosenJ];
  return rows.flatMap((j) => columns.map((i) => pixelOf(camera, i, j))).map((pixel) =>
    ({ ...pixel, origin: camera.origin === "pixel" ? pixel.at : [0, 0, 0], direction: unitOf(pixel.at) }));
}

/// An arrow to where the document says that the ray meets a sphere, or out of the figure.
function addRay(list, { origin, direction, colour, select, index }) {
  const hit = list.camera ? hitOfPixel(list, origin, direction, index) : hitOfGiven(list, origin, direction, index);
  const end = hit ?? plus(origin, times(direction, list.reach));
  addLine(list, origin, end, colour, { hasArrow: true });
  if (!list.camera) addPoint(list, origin, colour, "disc", 8, select);
  if (hit && list.layers.hits) addPoint(list, hit, colour, "diamond", 10, select);
}

/// Where a pixel's ray meets the sphere that the pixel sees; null where it sees none, or this is not told.
function hitOfPixel({ scene }, origin, direction, index) {
  let until = 0;
  const seen = scene.seen?.find(([run]) => (until += run) > index)?.[1];
  const { centre, radius } = scene.figure.spheres;
  const s = centre[seen] ? drawnRoot(origin, direction, centre[seen], radius[seen]) : null;
  return s === null ? null : plus(origin, times(direction, s));
}

/// The nearest of the hit points in a given ray's panels; null: none.
function hitOfGiven({ scene }, origin, direction, index) {
  const along = (point) => dotProduct(minus(point, origin), direction);
  return scene.panels.filter((panel) => panel.ray === index)
    .flatMap((panel) => panel.drawing.roots.filter((root) => root.chosen).map((root) => root.Q))
    .reduce((nearest, Q) => (nearest && along(nearest) <= along(Q) ? nearest : Q), null);
}

/// T, v, d and the roots of the panel's ray and its sphere, C, if any.
function addDrawing(list, { L, P, D, foot, roots }, C) {
  const { palette } = list;
  const middle = (a, b) => times(plus(a, b), 0.5);
  const along = (point) => dotProduct(minus(point, L), D);
  const places = [L, ...(foot ? [foot] : []), ...roots.map((root) => root.Q)].sort((a, b) => along(a) - along(b));
  if (P) addLine(list, [0, 0, 0], P, palette.ink, { isDashed: true });
  if (places[0] !== L) {
    addLine(list, L, places[0], palette.ink, { isThick: true, isDashed: true });
    addName(list, places[0], "behind the origin");
  }
  const last = places[places.length - 1];
  addLine(list, L, plus(last, times(D, 0.2 * list.reach)), palette.ink, { isThick: true, hasArrow: true });
  addPoint(list, L, palette.ink, "square", 9);
  addName(list, L, "L, the ray's origin");
  if (!C || !foot) return;
  addLine(list, L, C, palette.purple, { isThick: true, hasArrow: true });
  addName(list, middle(L, C), "T", palette.purple);
  addPoint(list, C, palette.purple, "cross", 9);
  addLine(list, L, foot, palette.blue, { isThick: true });
  addName(list, middle(L, foot), "v", palette.blue);
  addPoint(list, foot, palette.blue, "ring", 9);
  addName(list, foot, "foot, L + v D", palette.blue);
  addLine(list, C, foot, palette.faint, { isDashed: true });
  for (const { which, Q, s, counts, chosen } of roots) {
    const isNear = which === "smaller";
    const colour = isNear ? palette.orange : palette.blue;
    const name = roots.length === 1 ? "double root" : isNear ? "near root" : "far root";
    addLine(list, C, Q, palette.faint);
    addLine(list, foot, Q, palette.gold, { isThick: true });
    if (isNear && roots.length > 1) addName(list, middle(foot, Q), "d", palette.gold);
    addPoint(list, Q, colour, isNear ? "diamond" : "square", chosen ? 15 : 10);
    addName(list, Q, `${name}, s = ${Number(Number(s).toPrecision(6))}${counts ? "" : ", does not count"}`, colour);
  }
}

function withoutInfinities(list) {
  const numbers = ({ at, from, to, centre, radius }) => [at, from, to, centre, radius].flat().filter((x) => x !== undefined);
  let dropped = 0;
  for (const kind of ["segments", "points", "names", "spheres"]) {
    const kept = list[kind].filter((item) => numbers(item).every(Number.isFinite));
    dropped += list[kind].length - kept.length;
    list[kind] = kept;
  }
  list.whole = list.whole.filter((place) => place.every(Number.isFinite));
  if (dropped > 0) list.notes.push(`${dropped} things are so far away that no double holds where: they are not drawn.`);
  return list;
}
