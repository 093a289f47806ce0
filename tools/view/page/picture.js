// The scene's pictures, two at a time with a divider between them, and the chosen pixel.
import { brief, choice, element, rangeField, refill, svg } from "./dom.js";
import { placeText, walkByKeys } from "./store.js";

const SMALLEST_RING = 1 / 40; // of the picture's width: the smallest size of the ring

export function mountPicture(root, store) {
  if (store.document.scenes.every((scene) => scene.pictures.length === 0)) {
    root.replaceChildren();
    return;
  }
  const shown = { scene: -1, sides: { left: 0, right: 0 } };
  const parts = ["choices", "view", "place"].map((id) => root.querySelector(`#picture-${id}`));
  const [[choices, view, place], images, line] = [parts, root.querySelectorAll("img"), root.querySelector("line")];
  const divide = (percent) => { // the right picture begins at this percentage
    images[1].style.clipPath = `inset(0 0 0 ${percent}%)`;
    for (const end of ["x1", "x2"]) line.setAttribute(end, `${percent}%`);
  };
  place.before(rangeField("divider", "Divider", 100,
    (percent) => (percent === 0 ? "only right" : percent === 100 ? "only left" : `left ${percent} %`), divide));
  view.addEventListener("click", (event) => choosePixelAt(event, view, store));
  walkByKeys(view, store);
  divide(0);

  const showPictures = () => {
    const { pictures } = store.scene();
    const both = Object.values(shown.sides).map((k) => pictures[k]);
    const sideChoice = (side, label) => choice(`picture-${side}`, label, pictures.map(({ name }, k) => [k, name]),
      shown.sides[side], (value) => {
        shown.sides[side] = Number(value);
        showPictures();
      });
    images.forEach((image, k) => Object.assign(image, { src: both[k].png, alt: brief(both[k].name) }));
    refill(choices, sideChoice("left", "Left"), sideChoice("right", "Right"));
    root.querySelector("#legends").replaceChildren(...[...new Set(both)].map(legend));
  };
  store.subscribe(() => {
    const { pictures, figure: { camera }, seen } = store.scene();
    const { pixel } = store.selection;
    root.hidden = pictures.length === 0;
    if (root.hidden || pixel === null) return;
    if (shown.scene !== store.scenesIndex) {
      const right = Math.max(0, pictures.findIndex(({ kind }) => kind === "error"));
      Object.assign(shown, { scene: store.scenesIndex, sides: { left: 0, right } });
      view.setAttribute("aria-label", `Picture, ${camera.width} by ${camera.height} pixels; arrow keys choose one`);
      view.style.aspectRatio = `${camera.width} / ${camera.height}`;
      view.lastElementChild.setAttribute("viewBox", `0 0 ${camera.width} ${camera.height}`);
      showPictures();
    }
    view.querySelector("g").replaceChildren(...ringAround(pixel, camera));
    const sphere = seen === null ? null : seenAt(seen, pixel[1] * camera.width + pixel[0]);
    place.replaceChildren(placeText({ pixel, ray: null, sphere: null }),
      sphere === null ? "" : sphere < 0 ? ": no sphere" : `: sphere ${sphere}`);
  });
}

function choosePixelAt(event, view, store) {
  const { camera } = store.scene().figure;
  const box = view.getBoundingClientRect();
  const i = Math.floor((event.clientX - box.left) / box.width * camera.width);
  const row = Math.floor((event.clientY - box.top) / box.height * camera.height);
  if (i < 0 || i >= camera.width || row < 0 || row >= camera.height) return;
  store.set({ selection: { pixel: [i, pictureRow(row, camera)] } });
}

/// The picture's row, from the top, of pixels with this j; and vice versa.
const pictureRow = (j, { height, rows }) => rows === "top-first" ? j : height - 1 - j;

function ringAround([i, j], camera) {
  const size = Math.max(1, camera.width * SMALLEST_RING);
  const place = { x: i + 0.5 - size / 2, y: pictureRow(j, camera) + 0.5 - size / 2, width: size, height: size };
  return ["ring-under", "ring"].map((kind) => svg("rect", { class: kind, ...place }));
}

/// The nearest sphere of pixel number `index`, given runs [pixels, sphere].
export function seenAt(runs, index) {
  let left = index;
  return runs.find(([pixels]) => (left -= pixels) < 0)?.[1] ?? null;
}

function legend({ name, legend: entries }) {
  const swatch = (colour) => svg("svg", { class: "swatch", viewBox: "0 0 1 1", "aria-hidden": "true" },
    svg("rect", { width: 1, height: 1, fill: colour }));
  return element("figure", { class: "legend" }, element("figcaption", { dir: "auto" }, brief(name)),
    element("ul", {}, entries.filter(({ pixels }) => pixels !== 0).map(({ colour, text, pixels }) =>
      element("li", {}, swatch(colour), ` ${brief(text)} `, element("span", { class: "number" }, pixels ?? "")))));
}
