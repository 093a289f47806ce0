// Everything that the figure draws, as tables.
import { disclosure, element, table } from "./dom.js";
import { placeText } from "./store.js";

/// Tables of what is named in the figure, of the chosen ray and of the spheres, made while they are open.
export function figureTable(store, listNow) {
  const body = element("div", {});
  const folded = disclosure("The figure as a table", body);
  let spheres = { scene: null, table: null }; // as long as they are the same: there may be many
  const fill = () => {
    if (!folded.open) return;
    if (spheres.scene !== store.scene()) spheres = { scene: store.scene(), table: spheresTable(store) };
    body.replaceChildren(namesTable(store, listNow()), ...rootsTable(store), spheres.table);
  };
  folded.addEventListener("toggle", fill);
  store.subscribe(fill);
  return folded;
}

function namesTable(store, { names }) {
  const { origin_text: origin, scale_exponent: exponent } = store.scene().figure;
  const inScene = (x) => Number((x * 2 ** -exponent).toPrecision(6)).toString();
  return table(`What is drawn, relative to ${origin}, to six digits`, ["name", "x", "y", "z"],
    names.map(({ text, at }) => [text, ...at.map(inScene)]));
}

function rootsTable(store) {
  const panels = store.panelsHere().filter((panel) => panel.sphere !== null);
  const rows = panels.flatMap(({ sphere, drawing: { roots } }) => (roots.length === 0
    ? [[`sphere ${sphere}`, "none: a miss", "", "", ""]]
    : roots.map(({ which, s, counts, chosen }) => [
      `sphere ${sphere}`, roots.length === 1 ? "double" : which, s, counts ? "yes" : "no", chosen ? "yes" : "no",
    ])));
  const place = placeText({ ...store.selection, sphere: null });
  if (rows.length === 0) return [];
  return [table(`Roots on the ray of ${place}`, ["sphere", "root", "s", "counts", "is the answer"], rows)];
}

function spheresTable(store) {
  const { figure: { camera, spheres, spheres_left_out: leftOut }, seen } = store.scene();
  const counts = new Map();
  for (const [run, sphere] of seen ?? []) counts.set(sphere, (counts.get(sphere) ?? 0) + run);
  const told = (k) => (seen ? `${counts.get(k) ?? 0} ${camera ? "pixels" : "rays"}` : "not told");
  return table(leftOut > 0 ? `Spheres; ${leftOut} more are not in this page` : "Spheres", ["sphere", "seen by"],
    spheres.label.map((text, k) => [text, told(k)]));
}
