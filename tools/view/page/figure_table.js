// Everything that the figure draws, as tables.

import { element, table } from "./dom.js";
import { placeText } from "./store.js";

/// Tables of the named parts, of the chosen ray, and of the spheres, made when they are opened.
export function figureTable(store, list) {
  const body = element("div", {});
  const folded = element("details", { class: "figure-table", toggle: () => fill() }, element("summary", {}, "The figure as a table"), body);
  let shown = list;
  const fill = () => folded.open && body.replaceChildren(partsTable(store, shown), ...rayTables(store), spheresTable(store));
  return { node: folded, update(other) { shown = other; fill(); } };
}

function partsTable(store, { parts }) {
  const { origin_text: origin, scale_exponent: exponent } = store.scene().figure;
  const inScene = (x) => Number((x * 2 ** -exponent).toPrecision(6)).toString();
  return table(`Parts, relative to ${origin}, to six digits`, ["part", "x", "y", "z"], parts.map(({ text, at }) => [text, ...at.map(inScene)]));
}

function rayTables(store) {
  const panels = store.panelsHere();
  if (panels.length === 0) return [];
  const { pixel, ray } = store.selection;
  return [table(`Roots on ${placeText({ pixel, ray, sphere: null })}`, ["sphere", "root", "s", "counts", "is the answer"], panels.flatMap(rootRows))];
}

function rootRows({ sphere, drawing }) {
  if (sphere === null) return [];
  if (drawing.roots.length === 0) return [[`sphere ${sphere}`, "none: a miss", "", "", ""]];
  return drawing.roots.map((root) => [
    `sphere ${sphere}`, drawing.roots.length === 1 ? "double" : root.which, root.s, root.counts ? "yes" : "no", root.chosen ? "yes" : "no",
  ]);
}

function spheresTable(store) {
  const { spheres, spheres_left_out: leftOut } = store.scene().figure;
  const seen = new Map();
  for (const [run, sphere] of store.scene().seen ?? []) seen.set(sphere, (seen.get(sphere) ?? 0) + run);
  const caption = leftOut > 0 ? `Spheres; ${leftOut} more are not in this page` : "Spheres";
  return table(caption, ["sphere", "seen by"], spheres.label.map((text, k) => [text, `${seen.get(k) ?? 0} pixels`]));
}
