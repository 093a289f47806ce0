// The figure: camera, pixels, rays and spheres in space, with its controls, its names and its table.

import { element, svg } from "./dom.js";
import { drawList, LAYERS } from "./draw_list.js";
import { figureTable } from "./figure_table.js";
import { flatPanes, paintFlat } from "./flat.js";
import { writeNames } from "./names.js";
import { orbitByPointer, pickedAt } from "./pointer.js";
import { distanceToFit, eyeViewer, lengthOf, letterboxed, minus, onScreen, orbitViewer, plus, times } from "./projection.js";
import { placeText, walkByKeys } from "./store.js";
import { eyePicture, webglPainter } from "./webgl.js";

const VIEWS = {
  corner: { name: "from a corner", azimuth: 0.9, elevation: 0.45 },
  eye: { name: "from the eye" },
  side: { name: "from the side", azimuth: Math.PI / 2, elevation: 0 },
  top: { name: "from above", azimuth: Math.PI / 2, elevation: Math.PI / 2 },
  axis: { name: "along W", azimuth: 0, elevation: 0 },
  flat: { name: "flat, side and above" },
};
const RAYS = { none: "no rays", pixel: "the chosen ray", row: "a row of rays", all: "all rays" };
const HINT = "Arrow keys go to the next pixel; w a s d or dragging turn; + and - go nearer and farther; 0 shows the whole; a click chooses.";

// Okabe and Ito's colours, for light and for dark ground.
const LIGHT = paletteOf({
  ink: "#222222", faint: "#8a8f98", rim: "#222222", near: "#0072b2", far: "#a3527f", U: "#d55e00", V: "#00795a", W: "#0072b2", up: "#a86f00",
  chosen: "#000000", ray: "#222222", T: "#a3527f", v: "#0072b2", d: "#c77700", nearRoot: "#d55e00", farRoot: "#0072b2",
});
const DARK = paletteOf({
  ink: "#e8e8e8", faint: "#7d828c", rim: "#15171b", near: "#56b4e9", far: "#d98fb8", U: "#ff8a3c", V: "#2fc79a", W: "#56b4e9", up: "#e69f00",
  chosen: "#ffffff", ray: "#e8e8e8", T: "#d98fb8", v: "#56b4e9", d: "#f0c040", nearRoot: "#ff8a3c", farRoot: "#56b4e9",
});

function paletteOf(colours) {
  const share = (hex, k) => parseInt(hex.slice(k, k + 2), 16) / 255;
  return Object.fromEntries(Object.entries(colours).map(([name, hex]) => [name, [1, 3, 5].map((k) => share(hex, k))]));
}

export function mountFigure(root, store) {
  const parts = {
    canvas: element("canvas", { class: "figure-canvas" }), flat: svg("svg", { class: "figure-flat" }), names: svg("svg", { class: "figure-names" }),
    notes: element("p", { class: "figure-notes", "aria-live": "polite" }), hint: element("p", { class: "figure-hint", id: "figure-hint" }, HINT),
  };
  const stage = element("div", { class: "figure-stage", tabindex: "0", role: "img", "aria-describedby": "figure-hint" }, parts.canvas, parts.flat, parts.names);
  const figure = { store, parts, stage, painter: webglPainter(parts.canvas), view: "corner", orbit: null, zoom: 1, isPrinting: false };
  if (!figure.painter) figure.lost = "This browser has no WebGL 2: the figure is flat.";
  build(figure);
  startView(figure);
  const controls = element("div", { class: "figure-controls", role: "group", "aria-label": "what the figure shows" });
  const table = figureTable(store, figure.list);
  root.append(controls, stage, parts.notes, parts.hint, table.node);
  fillControls(figure, controls);

  const redraw = () => redrawSoon(figure);
  store.subscribe((_, changed) => {
    build(figure);
    if (changed.includes("scenesIndex")) {
      startView(figure);
      fillControls(figure, controls);
    }
    table.update(figure.list);
    redraw();
  });
  walkByKeys(stage, store);
  stage.addEventListener("keydown", (event) => turnByKey(figure, event));
  orbitByPointer(stage, { turn: (x, y) => turn(figure, x, y), zoom: (by) => zoom(figure, by), pan: (x, y) => pan(figure, x, y), pick: (x, y) => pick(figure, x, y) });
  parts.canvas.addEventListener("webglcontextlost", () => {
    figure.painter = null;
    figure.lost = "The browser took WebGL away: the figure is flat.";
    redraw();
  });
  const repaint = (isPrinting) => () => {
    figure.isPrinting = isPrinting;
    build(figure);
    draw(figure);
  };
  addEventListener("beforeprint", repaint(true));
  addEventListener("afterprint", repaint(false));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", repaint(false));
  new ResizeObserver(redraw).observe(stage);
  window.raycheckPage = Object.assign(window.raycheckPage ?? {}, { eyePicture: (width, height) => eyePicture(store, width, height) });
  redraw();
}

function layersOf({ store }) {
  const shown = Object.fromEntries(Object.keys(LAYERS).map((name) => [name, store.layers[name] ?? true]));
  return { ...shown, rays: store.layers.rays ?? (store.scene().figure.camera ? "pixel" : "all") };
}

function build(figure) {
  const { store } = figure;
  const isDark = !figure.isPrinting && matchMedia("(prefers-color-scheme: dark)").matches;
  const layers = layersOf(figure);
  figure.list = drawList(store.scene(), store.selection, store.panel(), layers, layers.rays, isDark ? DARK : LIGHT);
}

/// What does not fit into one view to scale starts where it is seen.
function startView(figure) {
  figure.view = figure.list.camera && figure.list.isOutOfScale ? "eye" : "corner";
  lookAtAll(figure);
}

function lookAtAll(figure) {
  const { frame, size, axes } = figure.list;
  const extremes = [0, 1, 2].map((k) => [Math.min(...frame.map((p) => p[k])), Math.max(...frame.map((p) => p[k]))]);
  const target = extremes.map(([low, high]) => (low + high) / 2);
  const radius = Math.max(...frame.map((point) => lengthOf(minus(point, target)))) || size;
  const { azimuth, elevation } = VIEWS[figure.view].azimuth === undefined ? VIEWS.corner : VIEWS[figure.view];
  figure.orbit = { target, axes, azimuth, elevation, distance: distanceToFit(radius) };
  figure.zoom = 1;
  figure.gone = null;
}

function goToSphere(figure, index) {
  const { centre: centres, radius: radii } = figure.store.scene().figure.spheres;
  const [centre, radius] = [centres[index], radii[index]];
  if (figure.view === "eye" || figure.view === "flat") figure.view = "corner";
  // Doubles near a centre are |C| 2^-52 apart: of a smaller sphere nothing can be drawn.
  const least = lengthOf(centre) * 2 ** -40;
  const shown = Math.max(radius, least, Number.MIN_VALUE);
  figure.orbit = { ...figure.orbit, target: centre, distance: 1.4 * distanceToFit(shown) };
  figure.gone = radius < least ? `Sphere ${index} is too small beside its distance from the origin to be drawn at all.` : null;
  figure.store.set({ selection: { sphere: index } });
  fillControls(figure, figure.stage.previousElementSibling);
}

function fillControls(figure, controls) {
  const { store, list } = figure;
  const views = Object.entries(VIEWS).filter(([key]) => (key === "flat" || figure.painter) && (key !== "eye" || list.camera));
  const chooser = (name, options, chosen, choose) => element("label", {}, name, element("select", { change: (event) => choose(event.target.value) },
    options.map(([value, text]) => element("option", { value, selected: value === chosen }, text))));
  const layers = layersOf(figure);
  const last = store.scene().figure.spheres.centre.length - 1;
  const number = element("input", { type: "number", min: "0", max: String(last), value: String(store.selection.sphere ?? 0), "aria-label": "sphere to go to" });
  const go = () => goToSphere(figure, Math.min(Math.max(Math.trunc(Number(number.value)), 0), last));
  controls.replaceChildren(
    chooser("View ", views.map(([key, { name }]) => [key, name]), figure.painter ? figure.view : "flat", (view) => {
      figure.view = view;
      lookAtAll(figure);
      redrawSoon(figure);
    }),
    chooser("Rays ", Object.entries(RAYS), layers.rays, (rays) => store.set({ layers: { rays } })),
    ...(last >= 0 && figure.painter ? [element("span", {}, number, element("button", { type: "button", click: go }, "Go to sphere"))] : []),
    element("fieldset", {}, element("legend", {}, "Layers"), Object.entries(LAYERS).map(([key, name]) => element("label", {},
      element("input", { type: "checkbox", checked: layers[key], change: (event) => store.set({ layers: { [key]: event.target.checked } }) }), name))),
  );
}

function redrawSoon(figure) {
  if (figure.isDue) return;
  figure.isDue = true;
  requestAnimationFrame(() => {
    figure.isDue = false;
    draw(figure);
  });
}

function draw(figure) {
  const { store, stage, parts, list, painter } = figure;
  const [width, height] = [stage.clientWidth, stage.clientHeight];
  if (width === 0 || height === 0) return;
  const isFlat = !painter || figure.view === "flat";
  parts.canvas.style.display = isFlat ? "none" : "";
  parts.flat.style.display = isFlat ? "" : "none";
  const notes = [...(figure.lost ? [figure.lost] : []), ...list.notes, ...(figure.gone ? [figure.gone] : [])];
  if (isFlat) {
    figure.panes = flatPanes(list, width, height);
    notes.push(...paintFlat(parts.flat, list, figure.panes));
  } else {
    const viewer = figure.view === "eye" ? letterboxed(eyeViewer(list.camera), width / height, figure.zoom) : orbitViewer(figure.orbit, width / height);
    figure.panes = [{ viewer, x: 0, y: 0, width, height }];
    figure.painted = painter.paint(list, viewer, width, height, Math.min(devicePixelRatio, 2));
    notes.push(...figure.painted.notes, ...smallNotes(figure.painted.small));
  }
  const small = new Set(isFlat ? [] : figure.painted.small.map(({ index }) => index));
  const labels = list.labels.map((label) => (small.has(label.sphere) ? { ...label, text: `${label.text}, too small to see here` } : label));
  const missing = writeNames(parts.names, labels, figure.panes);
  if (figure.view === "eye" && !isFlat) parts.names.prepend(besidePicture(list, figure.panes[0]));
  if (missing > 0) notes.push(`${missing} names have no room here.`);
  parts.notes.textContent = notes.join(" ");
  const { camera, spheres } = store.scene().figure;
  const what = camera ? `camera, ${camera.width} x ${camera.height} pixels` : `${store.scene().figure.rays.length} rays`;
  stage.setAttribute("aria-label", `Figure ${isFlat ? VIEWS.flat.name : VIEWS[figure.view].name}: ${what}, ${spheres.centre.length} spheres; chosen: ${placeText(store.selection) || "nothing"}`);
}

function smallNotes(small) {
  if (small.length === 0) return [];
  const named = small.length <= 5 ? `Sphere ${small.map(({ index }) => index).join(", ")}` : `${small.length} spheres`;
  return [`${named}: too small to see here, marked by a ring.`];
}

/// Dims what is on the screen, but not in the picture.
function besidePicture(list, { viewer, width, height }) {
  const [x0, x1, y0, y1] = eyeViewer(list.camera).window;
  const forward = viewer.axes[2];
  const corner = (x, y) => onScreen(viewer, plus(times(forward, 1), plus(times(viewer.axes[0], x), times(viewer.axes[1], y))), width, height);
  const [[left, top], [right, bottom]] = [corner(x0, y1), corner(x1, y0)];
  return svg("path", { class: "figure-beside", "fill-rule": "evenodd", d: `M0 0H${width}V${height}H0ZM${left} ${top}H${right}V${bottom}H${left}Z` });
}

function turn(figure, x, y) {
  if (figure.view === "flat") return;
  if (figure.view === "eye") {
    figure.view = "corner";
    lookAtAll(figure);
    figure.stage.previousElementSibling.querySelector("select").value = "corner";
  }
  const { orbit } = figure;
  orbit.azimuth -= x;
  orbit.elevation = Math.min(Math.max(orbit.elevation + y, -Math.PI / 2), Math.PI / 2);
  redrawSoon(figure);
}

function zoom(figure, by) {
  figure.zoom *= by;
  figure.orbit.distance *= by;
  redrawSoon(figure);
}

/// Moves by a share of the height of the screen.
function pan(figure, x, y) {
  if (figure.view === "eye" || figure.view === "flat") return;
  const { axes, window } = orbitViewer(figure.orbit, 1);
  const step = figure.orbit.distance * (window[3] - window[2]);
  figure.orbit.target = plus(figure.orbit.target, plus(times(axes[0], -x * step), times(axes[1], y * step)));
  redrawSoon(figure);
}

function turnByKey(figure, event) {
  if (event.altKey || event.ctrlKey || event.metaKey) return;
  const actions = {
    a: () => turn(figure, -0.1, 0), d: () => turn(figure, 0.1, 0), w: () => turn(figure, 0, 0.1), s: () => turn(figure, 0, -0.1),
    "+": () => zoom(figure, 0.8), "=": () => zoom(figure, 0.8), "-": () => zoom(figure, 1.25),
    0: () => { lookAtAll(figure); redrawSoon(figure); },
  };
  if (!actions[event.key]) return;
  event.preventDefault();
  actions[event.key]();
}

function pick(figure, x, y) {
  const pane = figure.panes.find((one) => x >= one.x && y >= one.y && x < one.x + one.width && y < one.y + one.height);
  const selection = pane && pickedAt(figure.list, pane, x - pane.x, y - pane.y, layersOf(figure));
  if (selection) figure.store.set({ selection });
}
