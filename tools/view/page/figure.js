// The figure: camera, pixels, rays and spheres in space, with its controls, its names and its table.
import { choice, element, svg } from "./dom.js";
import { LAYERS, drawList, extremesOf } from "./draw_list.js";
import { figureTable } from "./figure_table.js";
import { flatPanes, paintFlat } from "./flat.js";
import { writeNames } from "./names.js";
import { createOrbit, followClicks, pickedAt } from "./orbit.js";
import { crossProduct, eyeViewer, lengthOf, letterboxed } from "./projection.js";
import { placeText, walkByKeys } from "./store.js";
import { webglPainter } from "./webgl.js";

const CORNER = { azimuth: 0.9, elevation: 0.45 };
const VIEWS = {
  corner: { name: "from a corner", ...CORNER },
  eye: { name: "from the eye" },
  side: { name: "from the side", azimuth: Math.PI / 2 },
  top: { name: "from above", azimuth: Math.PI / 2, elevation: Math.PI / 2 },
  along: { name: "along W" },
  across: { name: "across the ray" },
  sphere: { name: "around the sphere", ...CORNER },
  flat: { name: "flat, side and above" },
};
const RAYS = { none: "none", pixel: "the chosen one", row: "a row", all: "all" };
const HINT = "Arrow keys go to the next pixel. Click: choose. Then drag, or w a s d: turn. Shift and drag: move. "
  + "Wheel, two fingers, or + -: nearer, farther. 0: all of it.";
const COLOURS = ["ink", "faint", "rim", "blue", "orange", "green", "purple", "gold"]; // --figure-... of the style
const LEAST_SHOWN = 2 ** -40; // of the way to a sphere's centre: doubles near it are 2^-52 apart

export function mountFigure(root, store) {
  const figure = {
    store, view: null, list: null, panes: [], lost: "", isDue: false,
    canvas: element("canvas", {}),
    flat: svg("svg", { class: "figure-flat" }),
    names: svg("svg", { class: "figure-names" }),
    controls: element("div", { class: "figure-controls", role: "group", "aria-label": "what the figure shows" }),
    notes: element("p", { class: "quiet", role: "status" }),
  };
  figure.stage = element("div",
    { class: "figure-stage", tabindex: "0", role: "img", "aria-describedby": "figure-hint" },
    figure.canvas, figure.flat, figure.names);
  figure.painter = webglPainter(figure.canvas);
  if (figure.painter) figure.orbit = createOrbit(figure.stage, () => redrawFigure(figure));
  else figure.lost = "This browser gives no WebGL 2: the figure is flat.";
  root.append(figure.controls, figure.stage, figure.notes, element("p", { class: "quiet", id: "figure-hint" }, HINT));
  listen(figure);
  root.append(figureTable(store, () => figure.list));
  Object.assign(window.raycheckPage, { webglPainter, eyeViewer }); // for tests of what the GPU makes of spheres
}

function listen(figure) {
  const { store, stage } = figure;
  store.subscribe((_, changed) => {
    rebuildFigure(figure);
    if (figure.view === null || changed.includes("scenesIndex")) startView(figure);
    else if (changed.includes("selection") && ["across", "sphere"].includes(figure.view)) showView(figure, figure.view);
  });
  walkByKeys(stage, store);
  stage.addEventListener("keydown", ({ key }) => { if (key === "0") showView(figure, figure.view); });
  followClicks(stage, (x, y) => {
    const selection = pickedAt(figure.list, figure.panes, x, y);
    if (selection) store.set({ selection });
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

function layersOf({ layers, scene }) {
  const shown = Object.fromEntries(Object.keys(LAYERS).map((name) => [name, layers[name] ?? true]));
  return { ...shown, rays: layers.rays ?? (scene().figure.camera ? "pixel" : "all") };
}

function rebuildFigure(figure) {
  const style = getComputedStyle(figure.stage);
  const palette = Object.fromEntries(COLOURS.map((name) => [name, style.getPropertyValue(`--figure-${name}`).trim()]));
  figure.list = drawList(figure.store, layersOf(figure.store), palette);
  redrawFigure(figure);
}

/// What no view from outside shows to scale is first seen from the eye.
function startView(figure) {
  const { store, list, painter, controls } = figure;
  const layers = layersOf(store);
  const views = Object.entries(VIEWS).filter(([key]) => (painter ? key !== "eye" || list.camera : key === "flat"));
  controls.replaceChildren(
    choice("figure-look", "View", views.map(([key, { name }]) => [key, name]), "", (view) => showView(figure, view)),
    choice("figure-rays", "Rays", Object.entries(RAYS), layers.rays, (rays) => store.set({ layers: { rays } })),
    ...Object.entries(LAYERS).map(([key, name]) => element("label", {}, element("input", {
      type: "checkbox", checked: layers[key], change: (event) => store.set({ layers: { [key]: event.target.checked } }),
    }), ` ${name}`)),
  );
  showView(figure, !painter ? "flat" : list.camera && list.figure.out_of_scale ? "eye" : "corner");
}

/// Shows all of the figure, or of what the view is of.
function showView(figure, view) {
  const { whole, axes } = (["across", "sphere"].includes(view) && aroundSphere(figure, view)) || figure.list;
  figure.view = view;
  figure.controls.querySelector("#figure-look").value = view;
  figure.orbit?.show(whole, axes, view === "eye" ? CORNER : VIEWS[view], aspectOf(figure.stage));
  redrawFigure(figure);
}

const aspectOf = ({ clientWidth, clientHeight }) => clientWidth / clientHeight || 1;

/// The chosen sphere; or, across the ray, the ray too, which goes to the right, the centre above it.
function aroundSphere({ store, list }, view) {
  const panel = store.panel();
  const { centre: { [panel?.sphere]: centre }, radius: { [panel?.sphere]: r } } = list.figure.spheres;
  if (!centre) return null;
  const { D, across, places: { L, foot } } = panel.drawing;
  const radius = Math.max(r, LEAST_SHOWN * lengthOf(centre), Number.MIN_VALUE);
  if (view === "sphere") return { axes: list.axes, whole: extremesOf({ centre, radius }, list.axes) };
  const axes = [D, across, crossProduct(D, across)];
  return { axes, whole: [L, foot, ...extremesOf({ centre, radius }, axes)].filter(Boolean) };
}

/// Draws once before the next picture of the screen, however often it is asked.
function redrawFigure(figure) {
  if (figure.isDue) return;
  figure.isDue = true;
  requestAnimationFrame(() => drawFigure(figure));
}

function drawFigure(figure) {
  const { store, stage, list, painter, orbit } = figure;
  figure.isDue = false;
  const [width, height] = [stage.clientWidth, stage.clientHeight];
  if (width === 0 || height === 0) return;
  const view = painter ? figure.view : "flat";
  const isFlat = view === "flat";
  figure.canvas.hidden = isFlat;
  figure.flat.classList.toggle("absent", !isFlat);
  const viewer = isFlat ? null : view === "eye" ? letterboxed(eyeViewer(list.camera), aspectOf(stage), orbit.zoom())
    : orbit.viewer(aspectOf(stage));
  figure.panes = isFlat ? flatPanes(list, width, height) : [{ x: 0, y: 0, width, height, viewer }];
  const { small, notes } = isFlat ? paintFlat(figure.flat, list, figure.panes) : painter.paint(list, figure.panes[0]);
  const isSmall = new Set(small.map(({ index }) => index));
  const names = (list.layers.names ? list.names : []).map((name) =>
    (isSmall.has(name.sphere) ? { ...name, text: `${name.text}, too small to see here` } : name));
  const missing = writeNames(figure.names, names, figure.panes);
  if (view === "eye") figure.names.prepend(besidePicture(list.camera, figure.panes[0]));
  figure.notes.replaceChildren([
    figure.lost, ...list.figure.notes, ...notes,
    small.length > 0 ? `Spheres too small to see here, each in a ring: ${small.length}.` : "",
    missing > 0 ? `Names without room here, all in the table below: ${missing}.` : "",
  ].filter(Boolean).join(" "));
  const { camera, rays, spheres } = list.figure;
  const what = camera ? `camera, ${camera.width} x ${camera.height} pixels` : `${rays.length} rays`;
  stage.setAttribute("aria-label", `Figure ${VIEWS[view].name}: ${what}, spheres: ${spheres.centre.length}; `
    + `chosen: ${placeText(store.selection) || "nothing"}`);
}

/// Dims what lies on the screen beside the camera's picture, which is in the middle.
function besidePicture(camera, { viewer: { window }, width, height }) {
  const own = eyeViewer(camera).window;
  const share = (k) => (own[k + 1] - own[k]) / (window[k + 1] - window[k]);
  const [across, up] = [share(0) * width, share(2) * height];
  const [x, y] = [(width - across) / 2, (height - up) / 2];
  return svg("path", { class: "figure-beside", d: `M0 0H${width}V${height}H0ZM${x} ${y}v${up}h${across}v${-up}Z` });
}
