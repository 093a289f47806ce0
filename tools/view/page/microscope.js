// Errors of 1e-16 made visible: the plane through ray and centre, in ulps around the exact point.
import { LETTER, atEachWidth, brief, disclosure, element, glyph, svg, table } from "./dom.js";

const TALLEST = 440;      // pixels
const TOGETHER = 10;      // pixels: marks nearer than this share a label
const NAMES_SHOWN = 3;    // of marks that share a label
const LANE = 16;          // pixels: from a label's line to the next
const GRID_SPACING = 4;   // pixels: a denser grid is not drawn

export function mountMicroscope(root, store) {
  const drawing = element("div", { id: "microscope-view" });
  let zoom = 0;
  let magnified = null;
  const draw = () => {
    const width = drawing.clientWidth;
    if (magnified !== null && width > 0) drawing.replaceChildren(magnifiedView(magnified, zoom, width, store));
  };
  const show = () => {
    const now = store.panel()?.microscope ?? null;
    if (now !== magnified || root.childElementCount === 0) {
      magnified = now;
      zoom = now === null ? 0 : firstZoom(now);
      const heading = element("h2", { id: "microscope-heading" }, "Microscope");
      if (now === null) {
        root.replaceChildren(heading, element("p", {}, "There is no exact hit here to magnify."));
      } else {
        root.replaceChildren(heading, element("p", {}, `${now.what}; 1 ulp = ${now.ulp}`), drawing,
          zoomField(now, zoom, (chosen) => {
            zoom = chosen;
            draw();
          }),
          ...tellings(now));
      }
    }
    draw();
  };
  atEachWidth(drawing, draw);
  store.subscribe(show);
  show();
}

/// The narrowest window that shows every wrong answer, or any answer where none is wrong.
function firstZoom({ zooms, marks }) {
  const inside = (mark, { half }) => Math.abs(mark.x) <= half && Math.abs(mark.y) <= half;
  const wrong = marks.filter((mark) => mark.wrong);
  const fits = zooms.findIndex((zoom) => (wrong.length > 0
    ? wrong.every((mark) => inside(mark, zoom)) : marks.some((mark) => inside(mark, zoom))));
  return fits < 0 ? zooms.length - 1 : fits;
}

function zoomField({ zooms }, first, onChange) {
  const told = (k) => `\u00b1${numberText(zooms[k].half)} ulp`;
  const output = element("output", { for: "zoom" }, told(first));
  const input = element("input", { id: "zoom", type: "range", min: 0, max: zooms.length - 1, step: 1,
    value: first, "aria-valuetext": told(first), input: () => {
      output.replaceChildren(told(input.valueAsNumber));
      input.setAttribute("aria-valuetext", told(input.valueAsNumber));
      onChange(input.valueAsNumber);
    } });
  return element("label", { for: "zoom", class: "field" }, element("span", {}, "Window"), input, output);
}

function tellings({ caption, marks, missing }) {
  const rows = marks.map((mark) => [brief(mark.name), mark.x, mark.y, brief(mark.text)]);
  return [element("p", { class: "quiet", dir: "auto" }, brief(caption)),
    missing.length === 0 ? "" : element("p", {}, "Nothing to draw: ",
      missing.map((one) => `${brief(one.name)} (${brief(one.text)})`).join(", ")),
    disclosure("All answers as a table", table("Answers around the exact point, in ulp",
      ["method", "along the ray", "towards the centre", "answer"], rows))];
}

function magnifiedView(now, zoom, width, store) {
  const { half, curve } = now.zooms[zoom];
  const height = Math.min(TALLEST, Math.round(width * 0.7));
  const scale = width / 2 / half;
  const x = (ulps) => width / 2 + ulps * scale;
  const y = (ulps) => height / 2 - ulps * scale;
  const lines = curve.map((points) => svg("polyline", { class: "sphere-curve",
    points: points.map((point) => `${x(point[0]).toFixed(2)},${y(point[1]).toFixed(2)}`).join(" ") }));
  const inside = now.marks.filter((mark) =>
    Math.abs(mark.x) <= half && Math.abs(y(mark.y) - height / 2) <= height / 2 - 8);
  const outside = now.marks.filter((mark) => !inside.includes(mark));
  const taken = [];
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", class: "instrument",
    "aria-label": `Where answers lie within ${numberText(half)} ulp of the exact point` },
  svg("g", { "aria-hidden": "true" },
    regionBand(now.region, half, x, height),
    gridLines(now.grid, half, scale, x, height, taken),
    lines,
    svg("path", { class: "ray", d: `M0 ${height / 2}H${width - 3}m-8 -4l8 4l-8 4` }),
    ulpTicks(half, x, height),
    svg("circle", { class: "exact", cx: width / 2, cy: height / 2, r: 9 }),
    edgeArrows(outside, half, width, height, taken),
    inside.map((mark) => svg("g", { class: markClass(mark, store) },
      glyph(mark.shape, x(mark.x).toFixed(2), y(mark.y).toFixed(2)))),
    markLabels(marksTogether(inside, x, y, width, height), width, height, taken),
    curveNames(curve, x, y, width, height, taken)));
}

function markClass(mark, store) {
  return store.methodShown !== null && store.methodShown !== mark.name ? "faded" : null;
}

function regionBand(region, half, x, height) {
  const from = region === null ? -half : Math.max(-half, Number(region[0]));
  const to = region === null ? half : Math.min(half, Number(region[1]));
  const told = region === null ? "rounding the inputs may move s anywhere"
    : `rounding the inputs moves s by up to ${region[1]} ulp`;
  return [svg("rect", { class: "region", x: x(from), width: Math.max(1, x(to) - x(from)), y: 0, height }),
    svg("text", { class: "label region-label", x: x(0), y: 14, "text-anchor": "middle" }, told)];
}

function gridLines(grid, half, scale, x, height, taken) {
  if (grid.length < 2 || Math.abs(grid[1] - grid[0]) * scale < GRID_SPACING) return null;
  taken.push({ x0: x(0) - 150, x1: x(0) + 150, y0: 0, y1: 18 });
  return grid.filter((at) => Math.abs(at) <= half).map((at) =>
    svg("path", { class: "double", d: `M${x(at).toFixed(2)} 22V${height - 22}` }));
}

function ulpTicks(half, x, height) {
  return [-1, -0.5, 0, 0.5, 1].map((part) => svg("text", { class: "label quiet", y: height - 5,
    x: x(part * half), "text-anchor": part === -1 ? "start" : part === 1 ? "end" : "middle" },
  part === 0 ? "0" : `${part > 0 ? "+" : "\u2212"}${numberText(Math.abs(part * half))}`
    + (part === 1 ? " ulp" : "")));
}

/// What lies outside the window, at its edge with its distance.
function edgeArrows(marks, half, width, height, taken) {
  const sides = new Map();
  for (const mark of marks) {
    const side = Math.abs(mark.x) <= half ? (mark.y > 0 ? "up" : "down") : mark.x > 0 ? "right" : "left";
    const told = side === "up" || side === "down" ? mark.y : mark.x;
    const key = `${side} ${told}`;
    const alike = sides.get(key) ?? { side, told, marks: [] };
    alike.marks.push(mark);
    sides.set(key, alike);
  }
  const arrows = { left: "\u2190", right: "\u2192", up: "\u2191", down: "\u2193" };
  let rows = { left: 0, right: 0 };
  return [...sides.values()].map(({ side, told, marks: alike }) => {
    const atRight = side === "right";
    const row = rows[atRight ? "right" : "left"]++;
    const y = height - 30 - row * LANE;
    const text = `${nameList(alike)} ${told} ulp`;
    const length = (text.length + 3) * LETTER;
    taken.push({ x0: atRight ? width - length : 0, x1: atRight ? width : length, y0: y - LANE, y1: y + 4 });
    return svg("text", { class: alike.some((mark) => mark.wrong) ? "label wrong" : "label",
      x: atRight ? width - 4 : 4, y, "text-anchor": atRight ? "end" : "start" },
    atRight ? `${text} ${arrows[side]}` : `${arrows[side]} ${text}`);
  });
}

/// Marks that lie together share one label; the exact point is one of them.
function marksTogether(marks, x, y, width, height) {
  const found = [{ x: width / 2, y: height / 2, marks: [], text: "exact" }];
  for (const mark of [...marks].sort((a, b) => Number(b.wrong) - Number(a.wrong))) {
    const at = { x: x(mark.x), y: y(mark.y) };
    const near = found.find((cluster) => cluster.marks.length > 0
      && Math.hypot(cluster.x - at.x, cluster.y - at.y) < TOGETHER);
    if (near) near.marks.push(mark);
    else found.push({ ...at, marks: [mark] });
  }
  return found.map((cluster) => ({ ...cluster,
    wrong: cluster.marks.some((mark) => mark.wrong), text: cluster.text ?? nameList(cluster.marks) }));
}

function nameList(marks) {
  const wrong = marks.some((mark) => mark.wrong) ? "\u2717 " : "";
  const named = marks.slice(0, NAMES_SHOWN).map((mark) => brief(mark.name).slice(0, 24)).join(", ");
  return wrong + named + (marks.length > NAMES_SHOWN ? ` and ${marks.length - NAMES_SHOWN} more` : "");
}

/// Each label above or below its mark, as near as leaves every other label free.
function markLabels(found, width, height, taken) {
  for (const { x, y } of found) taken.push({ x0: x - 8, x1: x + 8, y0: y - 8, y1: y + 8 });
  return [...found].sort((a, b) => a.x - b.x).map((cluster) => {
    const length = cluster.text.length * LETTER;
    const left = Math.min(Math.max(cluster.x - length / 2, 2), Math.max(2, width - length - 2));
    const lanes = [...Array(24).keys()].map((k) =>
      cluster.y + (k % 2 === 0 ? -1 : 1) * (24 + Math.floor(k / 2) * LANE));
    const box = (at) => ({ x0: left, x1: left + length, y0: at - LANE + 4, y1: at + 4 });
    const free = lanes.find((at) => at > 34 && at < height - 24
      && !taken.some((other) => overlaps(other, box(at))));
    if (free === undefined) return null;
    taken.push(box(free));
    const end = free < cluster.y ? free + 4 : free - 12;
    const anchor = Math.min(Math.max(cluster.x, left), left + length);
    return [svg("path", { class: "leader", d: `M${anchor} ${end}L${cluster.x} ${cluster.y}` }),
      svg("text", { class: cluster.wrong ? "label wrong" : "label", x: left, y: free,
        textLength: null }, cluster.text)];
  });
}

/// "ray" and "sphere", where there is room beside them.
function curveNames(curve, x, y, width, height, taken) {
  const points = curve.flat().map((point) => [x(point[0]), y(point[1])])
    .filter(([px, py]) => px > 4 && px < width - 60 && py > 40 && py < height - 30);
  const spots = [[width - 40, height / 2 - 8, "ray"],
    ...points.map(([px, py]) => [px + 6, py + 4, "sphere"])];
  const said = new Set();
  return spots.map(([left, at, text]) => {
    const box = { x0: left, x1: left + text.length * LETTER, y0: at - LANE + 4, y1: at + 4 };
    if (said.has(text) || taken.some((other) => overlaps(other, box))) return null;
    said.add(text);
    taken.push(box);
    return svg("text", { class: "label quiet", x: left, y: at }, text);
  });
}

function overlaps(a, b) {
  return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

function numberText(value) {
  return value < 1e5 ? String(value) : value.toExponential(1);
}
