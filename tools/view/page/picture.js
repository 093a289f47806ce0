// The scene's pictures, two at a time with a divider between them, and the chosen pixel.
import { brief, choice, element, svg } from "./dom.js";
import { placeText, walkByKeys } from "./store.js";

const SMALLEST_RING = 1 / 40;  // of the picture's width: the chosen pixel of a large picture

export function mountPicture(root, store) {
  if (store.document.scenes.every((scene) => scene.pictures.length === 0)) return;
  const shown = { left: 0, right: 0, divider: 50 };
  const line = svg("line", { class: "divider", y1: 0, y2: "100%" });
  const rings = svg("g", {});
  const overlay = svg("svg", { "aria-hidden": "true" }, line, rings);
  const images = [element("img", {}), element("img", {})];
  const view = element("div", { id: "picture-view", tabindex: "0", role: "application",
    "aria-describedby": "picture-place", click: (event) => clicked(event, view, store) },
  images, overlay);
  const place = element("p", { id: "picture-place", class: "quiet" });
  const choices = element("div", { class: "fields" });
  const legends = element("div", { id: "legends" });
  const divider = element("input", { id: "divider", type: "range", min: 0, max: 100, step: 1,
    value: shown.divider, input: (event) => {
      shown.divider = event.target.valueAsNumber;
      divide();
    } });
  root.append(element("h2", { id: "picture-heading" }, "Picture"), choices, view,
    element("label", { for: "divider", class: "field" }, element("span", {}, "Divider"), divider),
    place, legends);
  walkByKeys(view, store);

  /// The right picture begins at the divider.
  const divide = () => {
    images[1].style.clipPath = `inset(0 0 0 ${shown.divider}%)`;
    line.setAttribute("x1", `${shown.divider}%`);
    line.setAttribute("x2", `${shown.divider}%`);
  };
  const showScene = () => {
    const { pictures, figure: { camera } } = store.scene();
    root.hidden = pictures.length === 0;
    if (root.hidden) return;
    view.setAttribute("aria-label",
      `Picture, ${camera.width} by ${camera.height} pixels; arrow keys choose one`);
    view.style.aspectRatio = `${camera.width} / ${camera.height}`;
    overlay.setAttribute("viewBox", `0 0 ${camera.width} ${camera.height}`);
    const options = pictures.map((picture, k) => [k, picture.name]);
    const pick = (side, label) => choice(`picture-${side}`, label, options, shown[side], (value) => {
      shown[side] = Number(value);
      showPictures();
    });
    choices.replaceChildren(pick("left", "Left"), pick("right", "Right"));
    showPictures();
  };
  const showPictures = () => {
    const { pictures } = store.scene();
    const both = [pictures[shown.left], pictures[shown.right]];
    both.forEach((picture, k) => {
      images[k].src = picture.png;
      images[k].alt = brief(picture.name);
    });
    divide();
    legends.replaceChildren(...[...new Set(both)].map(legend));
  };
  const startScene = () => {
    shown.left = 0;
    shown.right = Math.max(0, store.scene().pictures.findIndex(({ name }) => name.startsWith("error")));
    showScene();
  };
  const showPixel = () => {
    const { figure: { camera }, seen } = store.scene();
    const { pixel } = store.selection;
    rings.replaceChildren(...(pixel && camera ? ring(pixel, camera) : []));
    const sees = pixel && camera && seen ? seenBy(seen, pixel[1] * camera.width + pixel[0]) : null;
    place.replaceChildren(pixel ? placeText({ ...store.selection, sphere: null }) : "no pixel",
      sees === null ? "" : sees < 0 ? " sees no sphere" : ` sees sphere ${sees}`);
  };
  let scene = -1;
  const show = () => {
    if (scene !== store.scenesIndex) startScene();
    scene = store.scenesIndex;
    showPixel();
  };
  store.subscribe(show);
  show();
}

function clicked(event, view, store) {
  const { camera } = store.scene().figure;
  const box = view.getBoundingClientRect();
  const i = Math.floor((event.clientX - box.left) / box.width * camera.width);
  const row = Math.floor((event.clientY - box.top) / box.height * camera.height);
  if (i < 0 || i >= camera.width || row < 0 || row >= camera.height) return;
  store.set({ selection: { pixel: [i, camera.rows === "top-first" ? row : camera.height - 1 - row] } });
}

function ring([i, j], { width, height, rows }) {
  const size = Math.max(1, width * SMALLEST_RING);
  const x = i + 0.5 - size / 2;
  const y = (rows === "top-first" ? j : height - 1 - j) + 0.5 - size / 2;
  return ["ring-under", "ring"].map((kind) =>
    svg("rect", { class: kind, x, y, width: size, height: size }));
}

function seenBy(runs, index) {
  for (const [length, sphere] of runs) {
    if (index < length) return sphere;
    index -= length;
  }
  return null;
}

function legend({ name, caption, legend: entries }) {
  return element("figure", { class: "legend" },
    element("figcaption", {}, element("strong", { dir: "auto" }, brief(name)), " ", brief(caption)),
    element("ul", {}, entries.filter((entry) => entry.count !== "0").map((entry) => element("li", {},
      swatch(entry.colour), ` ${brief(entry.text)} `, element("span", { class: "number" }, entry.count)))));
}

function swatch(colour) {
  return svg("svg", { class: "swatch", viewBox: "0 0 1 1", "aria-hidden": "true" },
    svg("rect", { width: 1, height: 1, fill: colour }));
}
