// What the figure holds, as segments, points, spheres and labels in eye-relative doubles; webgl.js and flat.js draw it.

import { atPlane, dotProduct, drawnHit, isFinitePoint, lengthOf, minus, pixelPointOf, plus, times, unitOf } from "./projection.js";

/// The layers that can be switched, with their names.
export const LAYERS = {
  frustum: "Frustum", axes: "Axes", pixels: "Pixels", spheres: "Spheres", hits: "Hit points", lengths: "T, v, d, roots", labels: "Names",
};

const MOST_PIXELS_ACROSS = 96; // points and rays beyond are thinned, and the figure says so
const MOST_RAYS_ACROSS = 24;
const ORDINARY = 50; // spheres within so many sizes of the frustum are framed

/// list.parts are the named places, for the table; list.frame the points that a view of the whole shows.
export function drawList(scene, selection, panel, layers, raysShown, palette) {
  const list = {
    scene, camera: scene.figure.camera, palette, axes: axesOf(scene.figure), segments: [], points: [], spheres: [], labels: [],
    parts: [], notes: [], frame: [], size: 1,
  };
  list.size = sizeOf(scene.figure);
  list.isOrdinary = (centre, radius) => lengthOf(centre) + radius <= ORDINARY * list.size;
  if (list.camera) addCamera(list, layers);
  else list.frame.push(...scene.figure.rays.map((ray) => ray.origin));
  addSpheres(list, selection, layers);
  list.reach = Math.max(...list.frame.map(lengthOf)) || list.size;
  if (list.camera && layers.pixels) addPixels(list, selection);
  addRays(list, raysShown, selection, layers);
  if (layers.lengths && panel) addLengths(list, panel.drawing);
  if (!layers.labels) list.labels = [];
  dropWhatIsNotFinite(list);
  return list;
}

/// The axes [side, up, back] that a figure is looked at by.
function axesOf({ camera }) {
  return camera ? [camera.U, camera.V, camera.W] : [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
}

function sizeOf({ camera, rays, spheres }) {
  if (camera) return Math.max(...cornersAt(camera, camera.far ?? camera.near).map(lengthOf));
  return Math.max(...rays.map((ray) => lengthOf(ray.origin)), ...spheres.centre.slice(0, 1).map(lengthOf)) || 1;
}

/// Corners of the frustum at a depth, enlarged about its middle.
function cornersAt(camera, depth, enlarged = 1) {
  const [alpha, beta] = [(camera.left + camera.right) / 2, (camera.bottom + camera.top) / 2];
  const [halfAlpha, halfBeta] = [(enlarged * (camera.right - camera.left)) / 2, (enlarged * (camera.top - camera.bottom)) / 2];
  return [[-1, -1], [1, -1], [1, 1], [-1, 1]]
    .map(([x, y]) => atPlane(camera, alpha + x * halfAlpha, beta + y * halfBeta, depth));
}

function line(list, from, to, colour, style = {}) {
  list.segments.push({ from, to, colour, ...style });
}

function outline(list, corners, colour, style) {
  corners.forEach((corner, k) => line(list, corner, corners[(k + 1) % corners.length], colour, style));
}

function label(list, at, text, colour = list.palette.ink, sphere = null) {
  list.labels.push({ at, text, colour, sphere });
}

/// A place with a name: in the figure's words, and in the table's.
function part(list, at, text, colour) {
  list.parts.push({ at, text });
  label(list, at, text, colour);
}

function addCamera(list, layers) {
  const { camera, palette } = list;
  const near = cornersAt(camera, camera.near);
  const middle = (a, b, share = 0.5) => plus(times(a, 1 - share), times(b, share));
  list.frame.push([0, 0, 0], ...near);
  if (lengthOf(minus(near[0], near[2])) < lengthOf(near[0]) / 50) {
    list.isOutOfScale = true;
    list.notes.push("The image plane is less than a fiftieth as wide as it is far: from outside it is next to a point; the view from the eye shows it.");
  }
  if (list.isOrdinary(camera.look_at, 0)) list.frame.push(camera.look_at);
  if (layers.frustum) {
    part(list, [0, 0, 0], "eye E", palette.ink);
    part(list, [0, 0, 0], "focal point (the eye)", palette.ink);
    list.points.push({ at: [0, 0, 0], colour: palette.ink, shape: "disc", size: 11 });
    near.forEach((corner) => line(list, [0, 0, 0], corner, palette.faint));
    outline(list, near, palette.near, { thick: true });
    part(list, near[3], "near clipping plane", palette.near);
    part(list, near[1], "bounded image plane", palette.near);
    const plane = cornersAt(camera, camera.near, 1.5);
    outline(list, plane, palette.near, { isDashed: true });
    part(list, plane[2], "view plane", palette.near);
    line(list, [0, 0, 0], camera.look_at, palette.faint, { isDashed: true });
    part(list, camera.look_at, "look-at point A", palette.ink);
    list.points.push({ at: camera.look_at, colour: palette.ink, shape: "cross", size: 12 });
  }
  if (layers.frustum && camera.far !== null) {
    const far = cornersAt(camera, camera.far);
    list.frame.push(...far);
    near.forEach((corner, k) => line(list, corner, far[k], palette.faint));
    outline(list, far, palette.far, { thick: true });
    part(list, middle(far[2], far[3], 0.25), "far clipping plane", palette.far);
  }
  if (layers.axes) {
    const long = 0.4 * Math.abs(camera.near);
    const axes = { U: [camera.U, "U"], V: [camera.V, "V"], W: [camera.W, "W (view-plane normal)"] };
    for (const [name, [axis, text]] of Object.entries(axes)) {
      line(list, [0, 0, 0], times(axis, long), palette[name], { thick: true, hasArrow: true });
      part(list, times(axis, long), text, palette[name]);
    }
    const up = times(unitOf(camera.up), 1.35 * long);
    line(list, [0, 0, 0], up, palette.up, { isDashed: true, hasArrow: true });
    part(list, up, "up vector", palette.up);
  }
}

/// Every so manieth index, so that at most `most` are left.
function thinned(count, most) {
  const step = Math.ceil(count / most);
  return Array.from({ length: Math.ceil(count / step) }, (_, k) => k * step);
}

/// From red, the first pixel, to magenta, the last, as the lecture has it.
function rainbow(share) {
  const hue = 5 * share;
  return [0, 4, 2].map((turn) => Math.min(Math.max(Math.abs(((hue + turn) % 6) - 3) - 1, 0), 1));
}

function pixelColour({ width, height }, i, j) {
  return rainbow((j * width + i) / Math.max(width * height - 1, 1));
}

function addPixels(list, selection) {
  const { camera, palette } = list;
  const columns = thinned(camera.width, MOST_PIXELS_ACROSS);
  const rows = thinned(camera.height, MOST_PIXELS_ACROSS);
  const size = Math.min(9, Math.max(3, 240 / Math.max(columns.length, rows.length)));
  for (const j of rows) {
    for (const i of columns) {
      const select = { pixel: [i, j] };
      list.points.push({ at: pixelPointOf(camera, i, j), colour: pixelColour(camera, i, j), shape: "disc", size, select });
    }
  }
  if (columns.length < camera.width || rows.length < camera.height) {
    list.notes.push(`Of ${camera.width} x ${camera.height} pixels every ${columns[1] ?? 1}th across and every ${rows[1] ?? 1}th down is a point.`);
  }
  label(list, pixelPointOf(camera, 0, 0), "pixel (0, 0)");
  if (selection.pixel === null) return;
  const [i, j] = selection.pixel;
  const cell = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]].map(([x, y]) => pixelPointOf(camera, i + x, j + y));
  outline(list, cell, palette.chosen, { thick: true });
  list.points.push({ at: pixelPointOf(camera, i, j), colour: pixelColour(camera, i, j), shape: "square", size: 11 });
  if (i !== 0 || j !== 0) label(list, pixelPointOf(camera, i, j), `pixel (${i}, ${j})`, palette.chosen);
}

function addSpheres(list, selection, layers) {
  const { spheres, spheres_left_out: leftOut } = list.scene.figure;
  spheres.centre.forEach((centre, index) => {
    const radius = spheres.radius[index];
    const surroundsEye = lengthOf(centre) < radius;
    if (list.isOrdinary(centre, radius) && !surroundsEye) {
      for (const axis of list.axes) list.frame.push(plus(centre, times(axis, radius)), minus(centre, times(axis, radius)));
    }
    if (!layers.spheres) return;
    const isChosen = selection.sphere === index;
    list.spheres.push({ index, centre, radius, colour: rgbOf(spheres.colour[index]), surroundsEye, isChosen });
    if (spheres.centre.length <= 24 || isChosen) label(list, centre, `sphere ${index}`, list.palette.ink, index);
    if (surroundsEye) list.notes.push(`Sphere ${index} surrounds the eye; from outside, only its far half is drawn.`);
  });
  const beyond = spheres.centre.filter((centre, index) => !list.isOrdinary(centre, spheres.radius[index])).length;
  if (beyond > 0) {
    list.isOutOfScale ||= beyond === spheres.centre.length;
    list.notes.push(`${beyond} of ${spheres.centre.length} spheres reach more than ${ORDINARY} times farther than the rest: no view holds all to scale; go to one of them.`);
  }
  if (leftOut > 0) list.notes.push(`${leftOut} more spheres are not in this page.`);
}

function rgbOf(hex) {
  return [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16) / 255);
}

const seenBySphere = new WeakMap();

/// The sphere that ray number k of a scene meets, -1 for none, undefined where the document does not say.
function sphereSeen(scene, k) {
  if (!scene.seen) return undefined;
  if (!seenBySphere.has(scene)) {
    seenBySphere.set(scene, scene.seen.flatMap(([run, sphere]) => new Array(run).fill(sphere)));
  }
  return seenBySphere.get(scene)[k];
}

/// The rays of a scene that are shown: what selects them, where they start, their direction, and the sphere they meet.
function shownRays(list, raysShown, selection) {
  const { camera, scene } = list;
  if (!camera) {
    return scene.figure.rays
      .map((ray, k) => ({ ...ray, select: { ray: k }, colour: rainbow(k / Math.max(scene.figure.rays.length - 1, 1)), sphere: sphereSeen(scene, k) }))
      .filter((_, k) => raysShown === "all" || k === selection.ray);
  }
  const [chosenI, chosenJ] = selection.pixel ?? [0, 0];
  const most = raysShown === "all" ? MOST_RAYS_ACROSS : MOST_PIXELS_ACROSS;
  const columns = { none: [], pixel: [chosenI] }[raysShown] ?? thinned(camera.width, most);
  const rows = raysShown === "all" ? thinned(camera.height, most) : [chosenJ];
  if (raysShown !== "pixel" && columns.length > 0 && columns.length * rows.length < camera.width * (raysShown === "row" ? 1 : camera.height)) {
    list.notes.push(`Of the rays every ${columns[1] ?? 1}th across and every ${rows[1] ?? 1}th down is drawn.`);
  }
  return rows.flatMap((j) => columns.map((i) => {
    const point = pixelPointOf(camera, i, j);
    return {
      origin: camera.origin === "pixel" ? point : [0, 0, 0], direction: unitOf(point), select: { pixel: [i, j] },
      colour: pixelColour(camera, i, j), sphere: sphereSeen(scene, j * camera.width + i),
    };
  }));
}

function addRays(list, raysShown, selection, layers) {
  const { spheres } = list.scene.figure;
  for (const ray of raysShown === "none" ? [] : shownRays(list, raysShown, selection)) {
    const isMet = ray.sphere >= 0 && ray.sphere < spheres.centre.length;
    const s = isMet ? drawnHit(ray.origin, ray.direction, spheres.centre[ray.sphere], spheres.radius[ray.sphere]) : null;
    const end = plus(ray.origin, times(ray.direction, s ?? list.reach));
    line(list, ray.origin, end, ray.colour, { hasArrow: true, select: ray.select });
    if (ray.select.ray !== undefined) list.points.push({ at: ray.origin, colour: ray.colour, shape: "disc", size: 8, select: ray.select });
    if (s !== null && layers.hits) list.points.push({ at: end, colour: ray.colour, shape: "diamond", size: 10, select: ray.select });
  }
}

/// T, v, d and the roots of the panel's ray and sphere.
function addLengths(list, { L, P, D, C, foot, roots }) {
  const { palette } = list;
  const along = (point) => dotProduct(minus(point, L), D);
  if (list.camera && P) line(list, [0, 0, 0], P, palette.ray, { isDashed: true });
  const ends = [...roots.map((root) => root.Q), ...(foot ? [foot] : [])];
  const last = ends.filter((point) => along(point) > 0).sort((a, b) => along(b) - along(a))[0];
  const behind = ends.filter((point) => along(point) < 0).sort((a, b) => along(a) - along(b))[0];
  line(list, L, plus(last ?? L, times(D, 0.2 * list.reach)), palette.ray, { thick: true, hasArrow: true });
  list.points.push({ at: L, colour: palette.ray, shape: "square", size: 9 });
  label(list, L, "L, the ray's origin", palette.ray);
  if (behind) {
    line(list, L, behind, palette.ray, { thick: true, isDashed: true });
    label(list, behind, "behind the origin", palette.ray);
  }
  if (C) {
    line(list, L, C, palette.T, { thick: true, hasArrow: true });
    label(list, plus(times(L, 0.5), times(C, 0.5)), "T", palette.T);
    list.points.push({ at: C, colour: palette.T, shape: "cross", size: 9 });
  }
  if (C && foot) {
    line(list, C, foot, palette.faint, { isDashed: true });
    list.points.push({ at: foot, colour: palette.v, shape: "ring", size: 9 });
    label(list, plus(times(L, 0.55), times(foot, 0.45)), "v", palette.v);
    label(list, foot, "foot, L + v D", palette.v);
  }
  roots.forEach((root) => addRoot(list, root, C, foot, roots.length));
}

function addRoot(list, { which, Q, s, counts, chosen }, C, foot, roots) {
  const { palette } = list;
  const isNear = which === "smaller";
  const colour = isNear ? palette.nearRoot : palette.farRoot;
  const name = roots === 1 ? "double root" : isNear ? "near root" : "far root";
  list.points.push({ at: Q, colour, shape: isNear ? "diamond" : "square", size: chosen ? 15 : 10 });
  label(list, Q, `${name}, s = ${s}${counts ? "" : " (does not count)"}`, colour);
  if (C) line(list, C, Q, palette.faint);
  if (foot) line(list, foot, Q, palette.d, { thick: true });
  if (foot && isNear && roots > 1) label(list, plus(times(foot, 0.5), times(Q, 0.5)), "d", palette.d);
}

function dropWhatIsNotFinite(list) {
  const places = { segments: ["from", "to"], points: ["at"], labels: ["at"], spheres: ["centre"] };
  let dropped = 0;
  for (const [kind, names] of Object.entries(places)) {
    const kept = list[kind].filter((item) => names.every((name) => isFinitePoint(item[name])) && (item.radius ?? 0) < Infinity);
    dropped += list[kind].length - kept.length;
    list[kind] = kept;
  }
  list.frame = list.frame.filter(isFinitePoint);
  if (dropped > 0) list.notes.push(`${dropped} things are too far away, in the figure's unit, for any double: they are not drawn.`);
}
