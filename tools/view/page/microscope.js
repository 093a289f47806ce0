// Errors of 1e-16 made visible: the plane through ray and centre, in ulps around the exact point.
import { atEachWidth, brief, briefSentence, disclosure, element, rangeField, refill, svg, table } from "./dom.js";
import { around, glyph, label } from "./marks.js";

const TALLEST = 440; // pixels
const TOGETHER = 10; // pixels: marks nearer than this share a label
const NAMES_SHOWN = 3; // of marks that share a label
const EDGE = 8; // pixels: from the window's edge to what lies beyond it
const GRID_SPACING = 4; // pixels: a denser grid is not drawn
const LABELS = around([2, 6, 1, 3, 7, 5, 0, 4]); // above and below their marks first

export function mountMicroscope(root, store) {
  const drawing = element("div", { id: "microscope-view" });
  let shown = {}; // what is magnified, the method told of, the window
  const draw = () => {
    const width = Math.floor(drawing.clientWidth);
    if (shown.now && width > 0) drawing.replaceChildren(magnifiedView(shown.now, shown.zoom, width, store.methodShown));
  };
  atEachWidth(drawing, draw);
  store.subscribe(() => {
    const now = store.panel()?.microscope ?? null;
    const told = store.methodTold();
    if (now !== shown.now || told !== shown.told) shown = { now, told, zoom: now === null ? 0 : firstZoom(now, told) };
    const heading = element("h2", { id: "microscope-heading" }, "Microscope");
    if (now === null) {
      root.replaceChildren(heading, element("p", {}, "Here is nothing to magnify."));
      return;
    }
    const zoom = rangeField("zoom", "Window", now.zooms.length - 1, (k) => `\u00b1${numberText(now.zooms[k].half)} ulp`, (k) => {
      shown.zoom = k;
      zoom.show(k);
      draw();
    });
    zoom.show(shown.zoom);
    const rows = now.marks.map(({ name, x, y, text }) => [brief(name), x, y, brief(text)]);
    refill(root, heading, now.sentences.map((sentence) => element("p", {}, briefSentence(sentence))), drawing, zoom,
      element("p", { class: "quiet" }, "The plane through the ray and the sphere's centre. Filled marks: s along the ray; "
        + "hollow ones: the point Q that a method gives. Lines: the neighbouring doubles of s."),
      disclosure("All answers as a table", table("Answers around the exact point, in ulp",
        ["method", "along the ray", "towards the centre", "answer"], rows)));
    draw();
  });
}

/// The narrowest window that shows the answer of the method told of, or any answer where none is.
function firstZoom({ zooms, marks }, told) {
  const meant = marks.filter(({ name }) => told === null || name === told);
  return Math.max(0, zooms.findIndex(({ half }) => meant.some(({ x, y }) => Math.abs(x) <= half && Math.abs(y) <= half / 2)));
}

function magnifiedView({ hit, zooms, marks, region, grid }, zoom, width, methodShown) {
  const half = Number(zooms[zoom].half);
  const height = Math.min(TALLEST, Math.round(width * 0.7));
  const x = (ulps) => width / 2 + ulps / half * width / 2;
  const y = (ulps) => height / 2 - ulps / half * width / 2;
  const pane = { x: 2, y: 20, width: width - 4, height: height - 40 };
  const placed = marks.map((mark) => placedMark(mark, [x(mark.x), y(mark.y)], width, height));
  const taken = [...placed, { at: [x(0), y(0)] }].map(({ at }) => ({ x: at[0] - 8, y: at[1] - 8, width: 16 }));
  const curve = zooms[zoom].curve.map((point) => [x(point[0]), y(point[1])]);
  const inside = curve.filter((at) => at[0] > 0 && at[0] < width - 60 && at[1] > 40 && at[1] < height - 30);
  const labels = [{ at: [x(0), y(0)], text: hit ? "exact" : "nearest to the centre", look: "" }, ...marksTogether(placed),
    { at: [width - 20, height / 2], text: "ray", look: "quiet" },
    ...inside.slice(0, 1).map((at) => ({ at, text: "sphere", look: "quiet" }))];
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", class: "instrument",
    "aria-label": `Where answers lie within ${numberText(half)} ulp of the exact point` },
  svg("g", { "aria-hidden": "true" },
    hit ? regionBand(region, half, x, height) : null, gridLines(grid, half, x, height),
    svg("polyline", { class: "sphere-curve", points: curve.map((at) => at.map((part) => part.toFixed(2))).join(" ") }),
    svg("path", { class: "ray", d: `M0 ${height / 2}H${width - 3}m-8 -4l8 4l-8 4` }),
    [["start", -1], ["middle", 0], ["end", 1]].map(([anchor, part]) => svg("text",
      { class: "label quiet", x: x(part * half), y: height - 5, "text-anchor": anchor }, `${numberText(part * half)} ulp`)),
    svg("circle", { class: "exact", cx: x(0), cy: y(0), r: 9 }),
    placed.filter(({ beyond }) => beyond === "").map(({ name, number, kind, at }) => svg("g",
      { class: `${[null, name].includes(methodShown) ? "" : "faded"} ${kind === "Q" ? "hollow" : ""}` },
      glyph(number, at[0].toFixed(2), at[1].toFixed(2), kind === "Q" ? 7 : 5))),
    labels.map(({ at, text, look }) => label(text, at, look, pane, taken, LABELS))));
}

/// A mark where it is drawn; what lies beyond the window is told at its edge, with its distance.
function placedMark(mark, [x, y], width, height) {
  const at = [Math.min(Math.max(x, EDGE), width - EDGE), Math.min(Math.max(y, EDGE), height - EDGE)];
  const beyond = x < 0 ? `\u2190 ${mark.x} ulp` : x > width ? `\u2192 ${mark.x} ulp`
    : y <= EDGE ? `\u2191 ${mark.y} ulp` : y >= height - EDGE ? `\u2193 ${mark.y} ulp` : "";
  return { ...mark, at: beyond === "" ? [x, y] : at, beyond };
}

/// What lies together, or equally far away, shares a label; what is wrong comes first.
function marksTogether(placed) {
  const groups = [];
  for (const mark of [...placed].sort((a, b) => Number(b.wrong) - Number(a.wrong))) {
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

function regionBand(region, half, x, height) {
  const to = Math.min(half, region ?? half);
  return [svg("rect", { class: "region", x: x(-to), width: Math.max(1, x(to) - x(-to)), y: 0, height }),
    svg("text", { class: "label", x: x(0), y: 14, "text-anchor": "middle" }, region === null
      ? "rounding the inputs may move s anywhere" : `rounding the inputs moves s by up to ${region} ulp`)];
}

function gridLines(grid, half, x, height) {
  if (grid.length < 2 || x(grid[1]) - x(grid[0]) < GRID_SPACING) return null;
  return grid.filter((at) => Math.abs(at) <= half)
    .map((at) => svg("path", { class: "double", d: `M${x(at).toFixed(2)} 20V${height - 20}` }));
}

function numberText(value) {
  const size = Math.abs(value);
  return `${value < 0 ? "\u2212" : ""}${size < 1e5 ? size : size.toExponential(1)}`;
}
