// The contents of the figure, as segments, points, spheres and names in the document's lengths.
import { seenAt } from "./picture.js";
import { drawnRoot, pixelPointOf, plus, times, unitOf } from "./projection.js";

const MOST_NAMED_SPHERES = 8; // if there are more, only the chosen sphere is named
const CELL = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];

/// The things to draw for a store's scene and selection; layers.rays is "none", "pixel", "row" or
/// "all". Colours are CSS colours, those of names are names in the palette. A thing with `select`
/// can be clicked; `whole` are the points that a view of the whole shows.
export function drawList(store, layers, palette) {
  const { figure, seen } = store.scene();
  const { camera, spheres, apart } = figure;
  const axes = camera ? [camera.U, camera.V, camera.W] : [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const known = spheres.centre.map((centre, index) =>
    ({ index, centre, radius: spheres.radius[index], colour: spheres.colour[index] }));
  const leftOut = new Set(apart);
  const list = {
    figure, camera, seen, selection: store.selection, layers, palette, axes, segments: [], points: [], names: [],
    spheres: layers.spheres ? known.filter(({ centre }) => centre !== null) : [],
    whole: [...figure.whole, ...known.filter(({ index }) => !leftOut.has(index))
      .flatMap((sphere) => extremesOf(sphere, axes))],
  };
  addParts(list, store.document.parts, store.panel());
  if (camera && layers.pixels) addPixels(list);
  for (const ray of raysShown(list)) addRay(list, ray);
  for (const { index, centre } of list.spheres) {
    if (spheres.centre.length > MOST_NAMED_SPHERES && index !== store.selection.sphere) continue;
    list.names.push({ at: centre, text: `sphere ${index}`, colour: "ink", sphere: index });
  }
  return list;
}

/// The ends of a sphere's diameters along axes.
export function extremesOf({ centre, radius }, axes) {
  return axes.flatMap((axis) => [plus(centre, times(axis, radius)), plus(centre, times(axis, -radius))]);
}

/// Adds the document's parts between, at and beside places of the figure and of the panel's ray and sphere.
function addParts({ figure, layers, palette, segments, points, names }, parts, panel) {
  const drawing = panel?.drawing;
  const places = { ...figure.places, ...drawing?.places, C: figure.spheres.centre[panel?.sphere] };
  if (places.L) places.end = plus(places.L, times(drawing.D, drawing.until));
  for (const { path, colour, ...line } of parts.lines.filter(({ layer }) => layers[layer])) {
    path.slice(1).forEach((name, k) => {
      const [from, to] = [places[path[k]], places[name]];
      if (from && to) segments.push({ ...line, from, to, colour: palette[colour] });
    });
  }
  for (const { at, colour, ...mark } of parts.marks.filter((one) => layers[one.layer] && places[one.at])) {
    points.push({ ...mark, at: places[at], colour: palette[colour] });
  }
  for (const { at: [first, second = first], text, colour } of parts.names.filter(({ layer }) => layers[layer])) {
    if (!places[first] || !places[second]) continue;
    const at = times(plus(places[first], places[second]), 0.5);
    names.push({ at, text: drawing?.names[first] ?? text, colour });
  }
}

/// A colour from red for the first to magenta for the last, as in the lecture.
const rainbow = (k, count) => `hsl(${((300 * k) / Math.max(count - 1, 1)).toFixed(1)}, 100%, 50%)`;

const everyNth = (count, step) => Array.from({ length: Math.ceil(count / step) }, (_, k) => k * step);

function pixelsAt(camera, columns, rows) {
  return rows.flatMap((j) => columns.map((i) => {
    const index = j * camera.width + i;
    const colour = rainbow(index, camera.width * camera.height);
    return { index, at: pixelPointOf(camera, i, j), colour, select: { pixel: [i, j] } };
  }));
}

function addPixels({ camera, palette, selection, segments, points, names }) {
  const [columns, rows] = [camera.width, camera.height].map((count, k) => everyNth(count, camera.pixel_steps[k]));
  const size = Math.min(9, Math.max(3, 240 / Math.max(columns.length, rows.length)));
  points.push(...pixelsAt(camera, columns, rows).map((pixel) => ({ ...pixel, shape: "disc", size })));
  if (selection.pixel === null) return;
  const [i, j] = selection.pixel;
  const cell = CELL.map(([x, y]) => pixelPointOf(camera, i + x, j + y));
  cell.forEach((from, k) => segments.push({ from, to: cell[(k + 1) % 4], colour: palette.ink, thick: true }));
  names.unshift({ at: pixelPointOf(camera, i, j), text: `pixel (${i}, ${j}), chosen`, colour: "ink" });
}

/// The rays to draw: {origin, direction, colour, select, index or hit}.
function raysShown({ camera, selection, layers, figure: { rays } }) {
  if (layers.rays === "none") return [];
  if (!camera) {
    return rays.map((ray, index) => ({ ...ray, colour: rainbow(index, rays.length), select: { ray: index } }))
      .filter(({ origin, select }) => origin !== null && (layers.rays === "all" || select.ray === selection.ray));
  }
  const [i, j] = selection.pixel ?? [0, 0];
  const columns = layers.rays === "pixel" ? [i] : everyNth(camera.width, camera.ray_steps[0]);
  const rows = layers.rays === "all" ? everyNth(camera.height, camera.ray_steps[1]) : [j];
  return pixelsAt(camera, columns, rows).map((pixel) =>
    ({ ...pixel, origin: camera.origin === "pixel" ? pixel.at : [0, 0, 0], direction: unitOf(pixel.at) }));
}

/// Adds an arrow to the point where, by the document, the ray meets a sphere, or out of the figure.
function addRay(list, ray) {
  const { origin, direction, colour, select } = ray;
  const hit = list.camera ? hitOfPixel(list, ray) : ray.hit;
  const to = hit ?? plus(origin, times(direction, list.figure.reach));
  list.segments.push({ from: origin, to, colour, arrow: true });
  if (!list.camera) list.points.push({ at: origin, colour, shape: "disc", size: 8, select });
  if (hit && list.layers.hits) list.points.push({ at: hit, colour, shape: "diamond", size: 10, select });
}

/// Where a pixel's ray meets its nearest sphere; null if it meets no sphere, or that is unknown.
function hitOfPixel({ seen, figure: { spheres } }, { origin, direction, index }) {
  const sphere = seenAt(seen ?? [], index);
  const centre = spheres.centre[sphere];
  const s = centre ? drawnRoot(origin, direction, centre, spheres.radius[sphere]) : null;
  return s === null ? null : plus(origin, times(direction, s));
}
