// Errors of 1e-16 made visible: the plane through ray and centre, in ulps around the exact point.
import { LETTER, alike, atEachWidth, brief, disclosure, element, glyph, rangeField, svg, table } from "./dom.js";

const TALLEST = 440; // pixels
const TOGETHER = 10; // pixels: marks nearer than this share a label
const NAMES_SHOWN = 3; // of marks that share a label
const LANE = 16; // pixels: from a label's line to the next
const NARROW = 500; // pixels: has room for three numbers on its axis
const GRID_SPACING = 4; // pixels: a denser grid is not drawn

export function mountMicroscope(root, store) {
  const drawing = element("div", { id: "microscope-view" });
  let zoom = 0;
  let magnified = null;
  let told = null;
  const draw = () => {
    const width = Math.floor(drawing.clientWidth);
    if (magnified !== null && width > 0) drawing.replaceChildren(magnifiedView(magnified, zoom, width, store));
  };
  const show = () => {
    const now = store.panel()?.microscope ?? null;
    if (now !== magnified || store.methodTold() !== told || root.childElementCount === 0) {
      magnified = now;
      told = store.methodTold();
      const heading = element("h2", { id: "microscope-heading" }, "Microscope");
      if (now === null) {
        root.replaceChildren(heading, element("p", {}, "Here is nothing to magnify."));
      } else {
        zoom = firstZoom(now, told);
        const { input, field } = rangeField("zoom", "Window", now.zooms.length - 1,
          (k) => `\u00b1${numberText(now.zooms[k].half)} ulp`, (k) => {
            zoom = k;
            draw();
          });
        const where = now.hit ? "Around the exact hit point, " : "Around the ray's point nearest to the centre, ";
        root.replaceChildren(heading, element("p", {}, where, element("i", { class: "symbol" }, "s"), ` = ${now.s}; 1 ulp = ${now.ulp}`),
          drawing, field, ...tellings(now, store.panel()));
        input.show(zoom);
      }
    }
    draw();
  };
  atEachWidth(drawing, draw);
  store.subscribe(show);
  show();
}

/// The narrowest window that shows the answer of the method told of, or any answer where none is.
function firstZoom({ zooms, marks }, told) {
  const meant = marks.filter((mark) => told === null || mark.name === told);
  return Math.max(0, zooms.findIndex(({ half }) => meant.some((mark) => Math.abs(mark.x) <= half && Math.abs(mark.y) <= half / 2)));
}

function tellings({ marks }, { verdicts }) {
  const rows = marks.map((mark) => [brief(mark.name), mark.x, mark.y, brief(mark.text)]);
  const absent = alike(verdicts.filter((one) => one.intersects && !marks.some((mark) => mark.name === one.name)), (one) => one.text)
    .map((same) => `${same.map((one) => brief(one.name)).join(", ")} (${brief(same[0].text)})`).join("; ");
  return [element("p", { class: "quiet" }, "The plane through the ray and the sphere's centre. Filled marks: s along the ray; "
    + "hollow ones: the point Q that a method gives. Lines: the neighbouring doubles of s."),
    absent === "" ? "" : element("p", { class: "quiet", dir: "auto" }, `Nothing to draw of ${absent}.`),
    disclosure("All answers as a table", table("Answers around the exact point, in ulp",
      ["method", "along the ray", "towards the centre", "answer"], rows))];
}

function magnifiedView({ hit, zooms, marks, region, grid }, zoom, width, store) {
  const half = Number(zooms[zoom].half);
  const curve = zooms[zoom].curve;
  const height = Math.min(TALLEST, Math.round(width * 0.7));
  const x = (ulps) => width / 2 + ulps / half * width / 2;
  const y = (ulps) => height / 2 - ulps / half * width / 2;
  const inside = marks.filter((mark) => Math.abs(mark.x) <= half && y(mark.y) > 8 && y(mark.y) < height - 8);
  const outside = marks.filter((mark) => !inside.includes(mark));
  const free = freePlaces([{ x0: 0, x1: width, y0: 0, y1: 20 }]);
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", class: "instrument",
    "aria-label": `Where answers lie within ${numberText(half)} ulp of the exact point` },
  svg("g", { "aria-hidden": "true" },
    hit ? regionBand(region, half, x, height) : null,
    gridLines(grid, half, x, height),
    svg("polyline", { class: "sphere-curve",
      points: curve.map((point) => `${x(point[0]).toFixed(2)},${y(point[1]).toFixed(2)}`).join(" ") }),
    svg("path", { class: "ray", d: `M0 ${height / 2}H${width - 3}m-8 -4l8 4l-8 4` }),
    (width < NARROW ? [-1, 0, 1] : [-1, -0.5, 0, 0.5, 1]).map((part) => svg("text", { class: "label quiet", x: x(part * half), y: height - 5,
      "text-anchor": part === -1 ? "start" : part === 1 ? "end" : "middle" },
    part === 0 ? "0" : `${part > 0 ? "+" : "\u2212"}${numberText(Math.abs(part * half))}`, part === 1 ? " ulp" : "")),
    svg("circle", { class: "exact", cx: x(0), cy: y(0), r: 9 }),
    edgeArrows(outside, half, width, height, free),
    inside.map((mark) => svg("g", { class: [store.methodShown === null || store.methodShown === mark.name ? "" : "faded",
      mark.kind === "Q" ? "hollow" : ""].join(" ") },
    glyph(store.methodNumber(mark.name), x(mark.x).toFixed(2), y(mark.y).toFixed(2), mark.kind === "Q" ? 7 : 5))),
    markLabels(marksTogether(inside, hit ? "exact" : "nearest to the centre", x, y), width, height, free),
    curveNames(curve, x, y, width, height, free)));
}

function regionBand(region, half, x, height) {
  const to = region === null ? half : Math.min(half, region);
  return [svg("rect", { class: "region", x: x(-to), width: Math.max(1, x(to) - x(-to)), y: 0, height }),
    svg("text", { class: "label", x: x(0), y: 14, "text-anchor": "middle" }, region === null
      ? "rounding the inputs may move s anywhere" : `rounding the inputs moves s by up to ${region} ulp`)];
}

function gridLines(grid, half, x, height) {
  if (grid.length < 2 || x(grid[1]) - x(grid[0]) < GRID_SPACING) return null;
  return grid.filter((at) => Math.abs(at) <= half)
    .map((at) => svg("path", { class: "double", d: `M${x(at).toFixed(2)} 20V${height - 20}` }));
}

/// What lies outside the window, at its edge with its distance; what is equally far shares a line.
function edgeArrows(marks, half, width, height, free) {
  const told = marks.map((mark) => (Math.abs(mark.x) > half
    ? { mark, arrow: mark.x > 0 ? "\u2192" : "\u2190", far: mark.x }
    : { mark, arrow: mark.y > 0 ? "\u2191" : "\u2193", far: mark.y }));
  return alike(told, ({ arrow, far }) => arrow + far).map((same) => {
    const { arrow, far } = same[0];
    const text = `${marksText(same.map(({ mark }) => mark))} ${far} ulp`;
    const atRight = arrow === "\u2192";
    const left = atRight ? width - (text.length + 3) * LETTER : 4;
    const at = free.take([...Array(24).keys()].map((row) => height - 28 - row * LANE), left, text.length + 3);
    return at === undefined ? null : svg("text", { y: at, x: atRight ? width - 4 : 4, "text-anchor": atRight ? "end" : "start",
      class: same.every(({ mark }) => mark.wrong) ? "label wrong" : "label" }, atRight ? `${text} ${arrow}` : `${arrow} ${text}`);
  });
}

/// Marks that lie together share one label; the point in the middle has its own.
function marksTogether(marks, middle, x, y) {
  const found = [];
  for (const mark of [...marks].sort((a, b) => Number(b.wrong) - Number(a.wrong))) {
    const at = { x: x(mark.x), y: y(mark.y) };
    const near = found.find((group) => Math.hypot(group.x - at.x, group.y - at.y) < TOGETHER);
    if (near) near.marks.push(mark);
    else found.push({ ...at, marks: [mark] });
  }
  const exact = { x: x(0), y: y(0), text: middle, wrong: false };
  return [exact, ...found.map((group) => (
    { ...group, text: marksText(group.marks), wrong: group.marks.every((mark) => mark.wrong) }))];
}

function marksText(marks) {
  const names = [...new Set(marks.map((mark) => (mark.wrong ? "\u2717 " : "") + brief(mark.name, 24)))];
  return names.slice(0, NAMES_SHOWN).join(", ") + (names.length > NAMES_SHOWN ? ` and ${names.length - NAMES_SHOWN} more` : "");
}

/// Each label above or below its mark, as near as leaves every other label free.
function markLabels(found, width, height, free) {
  for (const { x, y } of found) free.block({ x0: x - 8, x1: x + 8, y0: y - 8, y1: y + 8 });
  return [...found].sort((a, b) => a.x - b.x).map(({ x, y, text, wrong }) => {
    const length = text.length * LETTER;
    const left = Math.max(2, Math.min(x - length / 2, width - length - 2));
    const lanes = [...Array(24).keys()].map((k) => y + (k % 2 === 0 ? -1 : 1) * (24 + Math.floor(k / 2) * LANE));
    const at = free.take(lanes.filter((lane) => lane > 34 && lane < height - 24), left, text.length);
    if (at === undefined) return null;
    const anchor = Math.min(Math.max(x, left), left + length);
    return [svg("path", { class: "leader", d: `M${anchor} ${at < y ? at + 4 : at - 12}L${x} ${y}` }),
      svg("text", { class: wrong ? "label wrong" : "label", x: left, y: at }, text)];
  });
}

/// "ray" and "sphere", where there is room beside them.
function curveNames(curve, x, y, width, height, free) {
  const beside = curve.map((point) => [x(point[0]) + 6, y(point[1]) + 4])
    .filter(([left, at]) => left > 8 && left < width - 60 && at > 40 && at < height - 30);
  const named = (text, [left, at]) => (free.take([at], left, text.length) === undefined ? null
    : svg("text", { class: "label quiet", x: left, y: at }, text));
  const first = (text, spots) => spots.reduce((found, spot) => found ?? named(text, spot), null);
  return [first("ray", [[width - 40, height / 2 - 8]]), first("sphere", beside)];
}

/// Where labels may still go: take(lines, left, letters) gives the first of these lines that is free, and keeps it.
function freePlaces(taken) {
  const meets = (a, b) => a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
  const boxAt = (at, left, letters) => ({ x0: left, x1: left + letters * LETTER, y0: at - LANE + 4, y1: at + 4 });
  return {
    block: (box) => taken.push(box),
    take(lines, left, letters) {
      const found = lines.find((at) => !taken.some((other) => meets(other, boxAt(at, left, letters))));
      if (found !== undefined) taken.push(boxAt(found, left, letters));
      return found;
    },
  };
}

function numberText(value) {
  return Number(value) < 1e5 ? String(value) : Number(value).toExponential(1);
}
