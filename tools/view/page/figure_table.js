// Everything that the figure draws, as a table.
import { disclosure, table } from "./dom.js";

/// A table of what is named in the figure and of the spheres, made while it is open.
export function figureTable(store, listNow) {
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
