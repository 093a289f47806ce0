// The figure: camera, pixels, rays and spheres in space, with its controls, its names and its table.
import { choice, element, svg } from "./dom.js";
import { LAYERS, drawList, rgbOf } from "./draw_list.js";
import { figureTable } from "./figure_table.js";
import { flatPanes, paintFlat } from "./flat.js";
import { writeNames } from "./names.js";
import { followPointers, pickedAt } from "./pointer.js";
import { crossProduct, distanceToFit, dotProduct, eyeViewer, homogeneous, letterboxed, orbitViewer, pixelsOf } from "./projection.js";
import { lengthOf, minus, plus, times } from "./projection.js";
import { placeText, walkByKeys } from "./store.js";
import { eyePicture, webglPainter } from "./webgl.js";

const VIEWS = {
  corner: { name: "from a corner", azimuth: 0.9, elevation: 0.45 },
  eye: { name: "from the eye" },
  side: { name: "from the side", azimuth: Math.PI / 2, elevation: 0 },
  top: { name: "from above", azimuth: Math.PI / 2, elevation: Math.PI / 2 },
  along: { name: "along W", azimuth: 0, elevation: 0 },
  across: { name: "across the ray", azimuth: 0, elevation: 0 },
  flat: { name: "flat, side and above" },
};
const RAYS = { none: "none", pixel: "the chosen one", row: "a row", all: "all" };
const HINT = "Arrow keys go to the next pixel. Drag, or w a s d: turn. Shift and drag: move. "
  + "Wheel, two fingers, or + -: nearer, farther. 0: all of it. Click: choose.";
const COLOURS = ["ink", "faint", "rim", "blue", "orange", "green", "purple", "gold"]; // --figure-... of the style

export function mountFigure(root, store) {
  const figure = {
    store, view: "corner", zoom: 1, orbit: null, list: null, panes: [], lost: "", gone: "", isDue: false,
    canvas: element("canvas", {}),
    flat: svg("svg", { class: "figure-flat" }),
    names: svg("svg", { class: "figure-names" }),
    controls: element("div", { class: "figure-controls", role: "group", "aria-label": "what the figure shows" }),
    notes: element("p", { class: "quiet", role: "status" }),
  };
  figure.stage = element("div", { class: "figure-stage", tabindex: "0", role: "img", "aria-describedby": "figure-hint" },
    figure.canvas, figure.flat, figure.names);
  figure.painter = webglPainter(figure.canvas);
  if (!figure.painter) figure.lost = "This browser gives no WebGL 2: the figure is flat.";
  root.append(figure.controls, figure.stage, figure.notes, element("p", { class: "quiet", id: "figure-hint" }, HINT));
  rebuildFigure(figure);
  startView(figure);
  root.append(figureTable(store, () => figure.list));
  listen(figure);
  const tried = { eyePicture: (width, height) => eyePicture(store, width, height) };
  window.raycheckPage = Object.assign(window.raycheckPage ?? {}, tried);
}

function listen(figure) {
  const { store, stage } = figure;
  store.subscribe((_, changed) => {
    rebuildFigure(figure);
    if (changed.includes("scenesIndex")) startView(figure);
    else if (figure.view === "across" && changed.includes("selection")) showView(figure, "across");
  });
  walkByKeys(stage, store);
  stage.addEventListener("keydown", (event) => actByKey(figure, event));
  followPointers(stage, {
    turn: (x, y) => turnFigure(figure, x, y), move: (x, y) => moveFigure(figure, x, y), zoom: (by) => zoomFigure(figure, by),
    pick: (x, y) => {
      const selection = pickedAt(figure.list, figure.panes, x, y);
      if (selection) store.set({ selection });
    },
  });
  figure.canvas.addEventListener("webglcontextlost", () => {
    figure.painter = null;
    figure.lost = "The browser took WebGL away: the figure is flat.";
    redrawFigure(figure);
  });
  for (const [happening, isPrinting] of [["beforeprint", true], ["afterprint", false]]) {
    addEventListener(happening, () => {
      stage.classList.toggle("printed", isPrinting); // on paper its colours are the light ones
      rebuildFigure(figure);
      drawFigure(figure);
    });
  }
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => rebuildFigure(figure));
  new ResizeObserver(() => redrawFigure(figure)).observe(stage);
}

function layersOf({ store }) {
  const shown = Object.fromEntries(Object.keys(LAYERS).map((name) => [name, store.layers[name] ?? true]));
  return { ...shown, rays: store.layers.rays ?? (store.scene().figure.camera ? "pixel" : "all") };
}

function rebuildFigure(figure) {
  const { store } = figure;
  const style = getComputedStyle(figure.stage);
  const colour = (name) => rgbOf(style.getPropertyValue(`--figure-${name}`).trim());
  const palette = Object.fromEntries(COLOURS.map((name) => [name, colour(name)]));
  figure.list = drawList(store.scene(), store.selection, store.panel(), layersOf(figure), palette);
  redrawFigure(figure);
}

/// What no view from outside shows to scale is first seen from the eye.
function startView(figure) {
  showView(figure, figure.list.camera && figure.list.isOutOfScale ? "eye" : "corner");
}

/// Shows all of the figure in a view.
function showView(figure, view) {
  const { whole, axes } = (view === "across" && acrossRay(figure)) || figure.list;
  const middle = (places) => (Math.min(...places) + Math.max(...places)) / 2;
  const target = [0, 1, 2].map((k) => middle(whole.map((place) => place[k])));
  const radius = Math.max(...whole.map((place) => lengthOf(minus(place, target)))) || figure.list.size;
  const { azimuth, elevation } = { ...VIEWS.corner, ...VIEWS[view] };
  const orbit = { target, axes, azimuth, elevation, distance: distanceToFit(radius) };
  // Then as much nearer as what is seen leaves room, and a little less; what is near grows faster than what is far.
  const aspect = figure.stage.clientWidth / figure.stage.clientHeight || 1;
  for (let k = 0; k < 4; ++k) orbit.distance *= shareSeen(orbitViewer(orbit, aspect), whole) + 0.12;
  Object.assign(figure, { view, zoom: 1, gone: "", orbit });
  fillControls(figure);
  redrawFigure(figure);
}

/// The plane of the chosen ray and sphere, seen at a right angle: the ray goes to the right, the centre lies above it.
function acrossRay({ store, list }) {
  const panel = store.panel();
  const { centre, radius } = store.scene().figure.spheres;
  const [C, r] = [centre[panel?.sphere], radius[panel?.sphere]];
  if (!C || !panel.drawing.foot) return null;
  const { L, D, foot } = panel.drawing;
  const square = (way) => minus(way, times(D, dotProduct(way, D)));
  const up = [minus(C, foot), ...list.axes].map(square).find((way) => lengthOf(way) > 1e-9 * lengthOf(minus(C, L)));
  if (!up) return null;
  const axes = [D, unitOf(up), crossProduct(D, unitOf(up))];
  return { axes, whole: [L, foot, ...axes.flatMap((axis) => [plus(C, times(axis, r)), minus(C, times(axis, r))])] };
}

/// How much of the screen places fill, from its middle; 1 and more where one is outside.
function shareSeen(viewer, places) {
  return Math.max(...places.map((place) => homogeneous(viewer, place)).map(([x, y, w]) => (w > 0 ? Math.max(Math.abs(x), Math.abs(y)) / w : 1)));
}

function goToSphere(figure, index) {
  const { centre, radius } = figure.store.scene().figure.spheres;
  // Doubles near a centre are |C| 2^-52 apart: of a smaller sphere nothing could be drawn.
  const least = lengthOf(centre[index]) * 2 ** -40;
  showView(figure, "corner");
  figure.orbit.target = centre[index];
  figure.orbit.distance = 1.4 * distanceToFit(Math.max(radius[index], least, Number.MIN_VALUE));
  if (radius[index] < least) figure.gone = `Sphere ${index} is too small, so far from the origin, to be drawn at any scale.`;
  figure.store.set({ selection: { sphere: index } });
  fillControls(figure);
}

function fillControls(figure) {
  const { store, list, painter } = figure;
  const layers = layersOf(figure);
  const views = Object.entries(VIEWS).filter(([key]) => (painter ? key !== "eye" || list.camera : key === "flat"));
  const last = store.scene().figure.spheres.centre.length - 1;
  const number = element("input", {
    type: "number", min: 0, max: last, value: store.selection.sphere ?? 0, "aria-label": "number of a sphere",
  });
  const go = () => goToSphere(figure, Math.min(Math.max(Math.trunc(number.valueAsNumber) || 0, 0), last));
  figure.controls.replaceChildren(
    choice("figure-look", "View", views.map(([key, { name }]) => [key, name]), figure.view, (view) => showView(figure, view)),
    choice("figure-rays", "Rays", Object.entries(RAYS), layers.rays, (rays) => store.set({ layers: { rays } })),
    element("span", { hidden: last < 0 || !painter }, number, " ",
      element("button", { type: "button", click: go }, "Go to sphere")),
    ...Object.entries(LAYERS).map(([key, name]) => element("label", {}, element("input", {
      type: "checkbox", checked: layers[key], change: (event) => store.set({ layers: { [key]: event.target.checked } }),
    }), ` ${name}`)),
  );
}

/// Draws once before the next picture of the screen, however often it is asked.
function redrawFigure(figure) {
  if (figure.isDue) return;
  figure.isDue = true;
  requestAnimationFrame(() => drawFigure(figure));
}

function drawFigure(figure) {
  const { store, stage, list, painter, view } = figure;
  figure.isDue = false;
  const [width, height] = [stage.clientWidth, stage.clientHeight];
  if (width === 0 || height === 0) return;
  const isFlat = !painter || view === "flat";
  figure.canvas.hidden = isFlat;
  figure.flat.classList.toggle("absent", !isFlat);
  figure.panes = isFlat
    ? flatPanes(list, width, height)
    : [{ x: 0, y: 0, width, height, viewer: viewerOf(figure, width / height) }];
  const painted = isFlat
    ? { small: [], notes: paintFlat(figure.flat, list, figure.panes) }
    : painter.paint(list, figure.panes[0]);
  const small = new Set(painted.small.map(({ index }) => index));
  const shown = list.layers.names ? list.names : [];
  const names = shown.map((name) =>
    (small.has(name.sphere) ? { ...name, text: `${name.text}, too small to see here` } : name));
  const missing = writeNames(figure.names, names, figure.panes);
  if (figure.panes[0].viewer.isEye) figure.names.prepend(besidePicture(list.camera, figure.panes[0]));
  figure.notes.replaceChildren([
    figure.lost, figure.gone, ...list.notes, ...painted.notes,
    small.size > 0 ? `Spheres too small to see here, each in a ring: ${small.size}.` : "",
    missing > 0 ? `Names without room here: ${missing}.` : "",
  ].join(" ").trim());
  const { camera, rays, spheres } = store.scene().figure;
  const what = camera ? `camera, ${camera.width} x ${camera.height} pixels` : `${rays.length} rays`;
  stage.setAttribute("aria-label", `Figure ${VIEWS[isFlat ? "flat" : view].name}: ${what}, spheres: `
    + `${spheres.centre.length}; chosen: ${placeText(store.selection) || "nothing"}`);
}

function viewerOf({ view, list, orbit, zoom: enlarged }, aspect) {
  return view === "eye" ? letterboxed(eyeViewer(list.camera), aspect, enlarged) : orbitViewer(orbit, aspect);
}

/// Dims what lies on the screen beside the camera's picture.
function besidePicture(camera, pane) {
  const [x0, x1, y0, y1] = eyeViewer(camera).window;
  const [left, right, bottom, top] = pane.viewer.window;
  const onScreen = (x, y) =>
    pixelsOf([(2 * x - left - right) / (right - left), (2 * y - bottom - top) / (top - bottom), 1], pane);
  const [[fromX, fromY], [toX, toY]] = [onScreen(x0, y1), onScreen(x1, y0)];
  const d = `M0 0H${pane.width}V${pane.height}H0ZM${fromX} ${fromY}V${toY}H${toX}V${fromY}Z`;
  return svg("path", { class: "figure-beside", d });
}

function turnFigure(figure, x, y) {
  if (figure.view === "flat" || !figure.painter) return;
  if (figure.view === "eye") showView(figure, "corner");
  const { orbit } = figure;
  orbit.azimuth -= x;
  orbit.elevation = Math.min(Math.max(orbit.elevation + y, -Math.PI / 2), Math.PI / 2);
  redrawFigure(figure);
}

function moveFigure(figure, x, y) {
  if (figure.view === "eye" || figure.view === "flat") return;
  const { orbit } = figure;
  const { axes, window: [, , low, high] } = orbitViewer(orbit, 1);
  orbit.target = plus(orbit.target, times(plus(times(axes[0], -x), times(axes[1], y)), orbit.distance * (high - low)));
  redrawFigure(figure);
}

function zoomFigure(figure, by) {
  figure.zoom *= by;
  figure.orbit.distance *= by;
  redrawFigure(figure);
}

function actByKey(figure, event) {
  if (event.altKey || event.ctrlKey || event.metaKey) return;
  const act = {
    a: () => turnFigure(figure, -0.1, 0), d: () => turnFigure(figure, 0.1, 0),
    w: () => turnFigure(figure, 0, 0.1), s: () => turnFigure(figure, 0, -0.1),
    "+": () => zoomFigure(figure, 0.8), "=": () => zoomFigure(figure, 0.8), "-": () => zoomFigure(figure, 1.25),
    0: () => showView(figure, figure.view),
  }[event.key];
  if (!act) return;
  event.preventDefault();
  act();
}
