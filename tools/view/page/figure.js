// The figure: camera, pixels, rays and spheres in space, with its controls, its names and its table.
import { disclosure, table } from "./dom.js";
import { drawList, extremesOf } from "./draw_list.js";
import { flatPanes, paintFlat } from "./flat.js";
import { aroundPlace, writeLabel } from "./marks.js";
import { createOrbit, followClicks, pickedAt } from "./orbit.js";
import { crossProduct, eyeViewer, lengthOf, onPane } from "./projection.js";
import { placeText, walkByKeys } from "./store.js";
import { webglPainter } from "./webgl.js";

const CORNER = [0.9, 0.45]; // azimuth and elevation about the figure's axes, in radians
const ANGLES = { corner: CORNER, sphere: CORNER, side: [Math.PI / 2, 0], top: [Math.PI / 2, Math.PI / 2] };
const COLOURS = ["ink", "faint", "rim", "blue", "orange", "green", "purple", "gold"]; // --figure-... of the style
const TRIED = aroundPlace([0.5, 7.5, 3.5, 4.5, 1, 3, 2, 5, 6, 7, 0, 4]); // beside a name's place
const LEAST_SHOWN = 2 ** -40; // of the distance of a sphere's centre: doubles near it are 2^-52 apart

export function mountFigure(root, store) {
  const [parts, canvas, stage, look, rays, flat, names, notes] = [
    "#figure-parts", "canvas", ".figure-stage", "#figure-look", "#figure-rays", ".figure-flat", ".figure-names",
    "#figure-notes"].map((selector) => root.querySelector(selector));
  const layers = [...root.querySelectorAll("[type=checkbox]")];
  const figure = { store, canvas, stage, look, rays, flat, names, notes, layers, view: null, lost: "", isDue: false };
  parts.hidden = false;
  figure.painter = webglPainter(canvas);
  if (figure.painter) figure.orbit = createOrbit(stage, () => redrawFigure(figure));
  else figure.lost = "This browser does not support WebGL 2: the figure is flat.";
  listen(figure);
  parts.append(figureTable(store, () => figure.list));
  Object.assign(window.raycheckPage, { figure, webglPainter, eyeViewer }); // for tests of the screen's contents
}

function listen(figure) {
  const { store, stage, look, rays, layers } = figure;
  look.addEventListener("change", () => showView(figure, look.value));
  rays.addEventListener("change", () => store.set({ layers: { rays: rays.value } }));
  for (const box of layers) box.addEventListener("change", () => store.set({ layers: { [box.name]: box.checked } }));
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
    figure.lost = "The browser lost its WebGL context: the figure is flat.";
    redrawFigure(figure);
  });
  for (const [happening, isPrinting] of [["beforeprint", true], ["afterprint", false]]) {
    addEventListener(happening, () => {
      stage.classList.toggle("printed", isPrinting); // light colours on paper
      stage.style.aspectRatio = isPrinting ? `${stage.clientWidth} / ${stage.clientHeight}` : ""; // with the same shape
      rebuildFigure(figure);
      drawFigure(figure);
    });
  }
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => rebuildFigure(figure));
  new ResizeObserver(() => redrawFigure(figure)).observe(stage);
}

function rebuildFigure(figure) {
  const { store, stage, layers } = figure;
  const shown = Object.fromEntries(layers.map(({ name }) => [name, store.layers[name] ?? true]));
  shown.rays = store.layers.rays ?? (store.scene().figure.camera ? "pixel" : "all");
  const style = getComputedStyle(stage);
  const palette = Object.fromEntries(COLOURS.map((name) => [name, style.getPropertyValue(`--figure-${name}`).trim()]));
  figure.rays.value = shown.rays;
  figure.list = drawList(store, shown, palette);
  redrawFigure(figure);
}

/// The view at the start: from the eye if no view from outside shows the scene to scale.
function startView(figure) {
  const { list, look, painter } = figure;
  for (const one of look.options) one.disabled = painter ? one.value === "eye" && !list.camera : one.value !== "flat";
  showView(figure, !painter ? "flat" : list.camera && list.figure.out_of_scale ? "eye" : "corner");
}

/// Shows the whole figure, or the whole subject of the view.
function showView(figure, view) {
  const { whole, axes } = (["across", "sphere"].includes(view) && aroundSphere(figure, view)) || figure.list;
  figure.view = figure.look.value = view;
  figure.orbit?.show(whole, axes, ANGLES[view] ?? [0, 0], aspectOf(figure.stage));
  redrawFigure(figure);
}

const aspectOf = ({ clientWidth, clientHeight }) => clientWidth / clientHeight || 1;

/// The view of the chosen sphere; or, across the ray, with the ray to the right and the centre above it.
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

/// Draws once before the next animation frame, even if it is called several times.
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
  const isFlat = !painter || figure.view === "flat";
  figure.canvas.hidden = isFlat;
  for (const drawing of [figure.flat, figure.names]) drawing.setAttribute("viewBox", `0 0 ${width} ${height}`);
  figure.flat.classList.toggle("absent", !isFlat);
  const viewer = isFlat ? null : figure.view === "eye" ? eyeViewer(list.camera, aspectOf(stage), orbit.zoom())
    : orbit.viewer(aspectOf(stage));
  figure.panes = isFlat ? flatPanes(list, width, height) : [{ x: 0, y: 0, width, height, viewer }];
  const { small, notes } = isFlat ? paintFlat(figure.flat, list, figure.panes) : painter.paint(list, figure.panes[0]);
  const isSmall = new Set(small.map(({ index }) => index));
  const names = (list.layers.names ? list.names : []).map((name) =>
    (isSmall.has(name.sphere) ? { ...name, text: `${name.text}, too small to see here` } : name));
  const missing = writeNames(figure.names, names, figure.panes);
  figure.notes.replaceChildren([
    figure.lost, ...list.figure.notes, ...notes,
    small.length > 0 ? `Spheres too small to see here, each in a ring: ${small.length}.` : "",
    missing > 0 ? `Names that do not fit here, see the table below: ${missing}.` : "",
  ].filter(Boolean).join(" "));
  const { camera, rays, spheres: { label: { length: spheres } } } = list.figure;
  const what = camera ? `camera, ${camera.width} x ${camera.height} pixels` : `${rays.length} rays`;
  const chosen = placeText(store.selection) || "nothing";
  const view = figure.look.selectedOptions[0].text;
  stage.setAttribute("aria-label", `Figure ${view}: ${what}, spheres: ${spheres}; chosen: ${chosen}`);
}

/// Writes names {at, text, colour} over panes, in order; returns how many did not fit.
function writeNames(target, names, panes) {
  const written = panes.flatMap((pane) => {
    const taken = [];
    return names.flatMap(({ at, text, colour }) => {
      const place = onPane(pane, at);
      return place ? [writeLabel(text, [place[0] + pane.x, place[1] + pane.y], colour, pane, taken, TRIED)] : [];
    });
  });
  target.replaceChildren(...written.flat().filter((node) => node !== null));
  return written.filter((nodes) => nodes === null).length;
}

/// A table of the named places and the spheres of the figure. It is made when it is opened.
function figureTable(store, listNow) {
  const folded = disclosure("The figure as a table");
  const fill = () => {
    if (!folded.open) return;
    const { origin_text: origin, scale_exponent: exponent, spheres } = store.scene().figure;
    const inScene = (place) => [0, 1, 2].map((k) =>
      (place === null ? "too far" : String(Number((place[k] * 2 ** -exponent).toPrecision(6)))));
    const named = listNow().names.filter(({ sphere }) => sphere === undefined);
    const all = [...named.map(({ text, at }) => [text, ...inScene(at)]),
      ...spheres.label.map((text, k) => [text, ...inScene(spheres.centre[k])])];
    const caption = `Where each name and centre is drawn, relative to ${origin}, to six digits`;
    folded.replaceChildren(folded.firstChild, table(caption, ["name", "x", "y", "z"], all));
  };
  folded.addEventListener("toggle", fill);
  store.subscribe(fill);
  return folded;
}
