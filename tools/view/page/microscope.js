// Makes errors of 1e-16 visible: shows the plane through ray and centre, in ulps around the exact
// point.
import { atEachWidth, brief, briefSentence, element, rangeField, refill, svg, table } from "./dom.js";
import { aroundPlace, glyph, writeLabel } from "./marks.js";

const TALLEST = 440; // pixels
const TOGETHER = 10; // pixels: marks nearer than this share a label
const NAMES_SHOWN = 3; // of marks that share a label
const EDGE = 8; // pixels: from the window's edge to what lies beyond it
const GRID_SPACING = 4; // pixels: a denser grid is not drawn
const LABELS = aroundPlace([2, 6, 1, 3, 7, 5, 0, 4]); // above and below their marks first

export function mountMicroscope(root, store) {
  const [told, seen, drawing, zoom, answers] = ["told", "shown", "view", "zoom", "answers"]
    .map((id) => root.querySelector(`#microscope-${id}`));
  let shown = {}; // the magnified point, the method in question, the window
  const draw = () => {
    const width = Math.floor(drawing.clientWidth);
    if (shown.now && width > 0) drawing.replaceChildren(magnifiedView(shown.now, shown.zoom, width, store));
  };
  const setZoom = (k) => {
    shown.zoom = k;
    draw();
  };
  atEachWidth(drawing, draw);
  store.subscribe(() => {
    const now = store.panel()?.microscope ?? null;
    const method = store.methodTold();
    if (now !== shown.now || method !== shown.method) shown = { now, method, zoom: now && firstZoom(now, method) };
    const sentences = now?.sentences ?? ["There is nothing to magnify here."];
    told.replaceChildren(...sentences.map((sentence) => element("p", {}, briefSentence(sentence))));
    seen.hidden = now === null;
    if (now === null) return;
    const { zooms, marks } = now;
    const tell = (k) => `\u00b1${zooms[k].half} ulp`;
    refill(zoom, rangeField("zoom", "Window", zooms.length - 1, tell, setZoom, shown.zoom));
    answers.replaceChildren(table("Answers around the exact point, in ulp", ["method", "along the ray",
      "towards the centre", "answer"], marks.map(({ name, x, y, text }) => [brief(name), x, y, brief(text)])));
    draw();
  });
}

/// The narrowest window that shows the answer of the method in question or, if there is no such
/// method, any answer.
function firstZoom({ marks }, told) {
  const meant = marks.filter(({ name }) => told === null || name === told);
  return meant.length === 0 ? 0 : Math.min(...meant.map(({ window: narrowest }) => narrowest));
}

function magnifiedView({ hit, zooms, marks, region, grid }, zoom, width, store) {
  const { half } = zooms[zoom];
  const height = Math.min(TALLEST, Math.round(width * 0.7));
  const x = (ulps) => width / 2 + ulps / half * width / 2;
  const y = (ulps) => height / 2 - ulps / half * width / 2;
  const reach = hit ? Math.min(half, region ?? half) : 0; // the extent of the effect of rounding the inputs
  const lines = x(grid[1]) - x(grid[0]) < GRID_SPACING ? [] : grid.filter((at) => Math.abs(at) <= half);
  const pane = { x: 2, y: 20, width: width - 4, height: height - 40 };
  const placed = marks.map((mark) => placedMark(mark, [x(mark.x), y(mark.y)], width, height));
  const taken = [...placed, { at: [x(0), y(0)] }].map(({ at }) => ({ x: at[0] - 8, y: at[1] - 8, width: 16 }));
  const curve = zooms[zoom].curve.map((point) => [x(point[0]), y(point[1])]);
  const inside = curve.filter((at) => at[0] > 0 && at[0] < width - 60 && at[1] > 40 && at[1] < height - 30);
  const labels = [{ at: [x(0), y(0)], text: hit ? "exact" : "nearest to the centre" },
    ...marksTogether(placed, store.methodTold()), { at: [width - 20, height / 2], text: "ray" },
    ...inside.slice(0, 1).map((at) => ({ at, text: "sphere" }))];
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", class: "instrument",
    "aria-label": `Where answers lie within ${half} ulp of the exact point` },
  svg("g", { "aria-hidden": "true" },
    svg("rect", { class: "region", x: x(-reach), width: 2 * Math.max(0.5, x(reach) - x(0)), y: 0, height }),
    lines.map((at) => svg("path", { class: "double", d: `M${x(at).toFixed(2)} 20V${height - 20}` })),
    svg("polyline", { class: "sphere-curve", points: curve.map((at) => at.map((one) => one.toFixed(2))).join(" ") }),
    svg("path", { class: "ray", d: `M0 ${height / 2}H${width - 3}m-8 -4l8 4l-8 4` }),
    [["start", -half, "\u2212"], ["middle", 0, ""], ["end", half, "+"]].map(([anchor, ulps, sign]) => svg("text",
      { class: "label quiet", x: x(ulps), y: height - 5, "text-anchor": anchor }, sign, ulps && half, " ulp")),
    svg("circle", { class: "exact", cx: x(0), cy: y(0), r: 9 }),
    placed.filter(({ beyond }) => beyond === "").map(({ name, number, kind, at }) => svg("g",
      { class: `${[null, name].includes(store.methodShown) ? "" : "faded"} ${kind === "Q" ? "hollow" : ""}` },
      glyph(number, at[0].toFixed(2), at[1].toFixed(2), kind === "Q" ? 7 : 5))),
    labels.map(({ at, text, look }) => writeLabel(text, at, look ?? "quiet", pane, taken, LABELS))));
}

/// A mark at its position; marks outside the window are put at its edge, with their distance.
function placedMark(mark, [x, y], width, height) {
  const at = [Math.min(Math.max(x, EDGE), width - EDGE), Math.min(Math.max(y, EDGE), height - EDGE)];
  const beyond = x < 0 ? `\u2190 ${mark.x} ulp` : x > width ? `\u2192 ${mark.x} ulp`
    : y <= EDGE ? `\u2191 ${mark.y} ulp` : y >= height - EDGE ? `\u2193 ${mark.y} ulp` : "";
  return { ...mark, at: beyond === "" ? [x, y] : at, beyond };
}

/// Marks that lie together, or equally far outside, share a label. The method in question comes
/// first, then wrong methods.
function marksTogether(placed, told) {
  const rank = ({ name, wrong }) => (name === told ? 2 : Number(wrong));
  const groups = [];
  for (const mark of [...placed].sort((a, b) => rank(b) - rank(a))) {
    const near = groups.find(({ at, beyond }) => beyond === mark.beyond
      && Math.hypot(at[0] - mark.at[0], at[1] - mark.at[1]) < TOGETHER);
    if (near) near.marks.push(mark);
    else groups.push({ ...mark, marks: [mark] });
  }
  return groups.map(({ at, beyond, marks }) => {
    const names = [...new Set(marks.map(({ wrong, name }) => (wrong ? "\u2717 " : "") + brief(name, 24)))];
    const more = names.length > NAMES_SHOWN ? ` and ${names.length - NAMES_SHOWN} more` : "";
    return { at, text: `${names.slice(0, NAMES_SHOWN).join(", ")}${more} ${beyond}`.trim(),
      look: marks.every(({ wrong }) => wrong) ? "wrong" : "" };
  });
}
