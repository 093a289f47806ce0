// The dial of a stress family: its severities, and each method's error along them.
import { LETTER, atEachWidth, brief, disclosure, element, glyph, svg, table } from "./dom.js";

const CHART_HEIGHT = 300;       // pixels
const LABEL_LINE = 15;     // pixels: from a label's line to the next
const LONGEST_LABEL = 34;  // letters
const CHART_MARGIN = { left: 56, top: 14, bottom: 44 };

export function mountDial(root, store) {
  const { dial } = store.document;
  if (dial === null) return;
  root.hidden = false;
  const told = (k) => `severity ${dial.severities[k]}`;
  const position = () => Math.max(0, dial.scenes.indexOf(store.scenesIndex));
  const output = element("output", { for: "severity" });
  const input = element("input", { id: "severity", type: "range", min: 0, step: 1,
    max: dial.severities.length - 1, input: () =>
      store.set({ scenesIndex: dial.scenes[input.valueAsNumber] }) });
  const drawing = element("div", { id: "dial-view" });
  root.append(element("h2", { id: "dial-heading" }, `Dial: ${dial.family}`),
    element("p", {}, brief(dial.sentence)),
    element("label", { for: "severity", class: "field" }, element("span", {}, "Severity"), input, output),
    drawing, disclosure("The curves as a table", table(`Largest error, in ${dial.unit}`,
      ["method", ...dial.severities.map(String)],
      dial.curves.map((curve) => [brief(curve.name), ...curve.points.map(pointText)]))));
  const draw = () => {
    if (drawing.clientWidth > 0) {
      drawing.replaceChildren(dialChart(dial, position(), drawing.clientWidth, store));
    }
  };
  const show = () => {
    input.value = position();
    input.setAttribute("aria-valuetext", told(position()));
    output.replaceChildren(told(position()));
    draw();
  };
  atEachWidth(drawing, draw);
  store.subscribe(show);
  show();
}

function pointText({ error, wrong }) {
  return (error ?? "-") + (wrong === "0" ? "" : `, ${wrong} wrong`);
}

function dialChart(dial, position, width, store) {
  const groups = curvesAlike(dial.curves);
  const longest = Math.max(...groups.map((group) => group.text.length));
  const right = width - 24 - longest * LETTER;
  const bottom = CHART_HEIGHT - CHART_MARGIN.bottom;
  const logs = dial.curves.flatMap((curve) => curve.points.map((point) => logarithm(point.error)))
    .filter(Number.isFinite);
  const low = Math.floor(Math.min(0, ...logs));
  const high = Math.ceil(Math.max(1, ...logs));
  const last = Math.max(1, dial.severities.length - 1);
  const x = (k) => CHART_MARGIN.left + k / last * (right - CHART_MARGIN.left);
  const y = (value) => bottom - (Math.max(value, low) - low) / (high - low) * (bottom - CHART_MARGIN.top);
  const every = Math.ceil((high - low) / 6);
  const powers = [];
  for (let power = low; power <= high; power += every) powers.push(power);
  return svg("svg", { viewBox: `0 0 ${width} ${CHART_HEIGHT}`, class: "instrument", role: "img",
    "aria-label": `Largest error of each method against severity; ${dial.severities[position]} is shown` },
  svg("g", { "aria-hidden": "true" },
    powers.map((power) => [svg("path", { class: "gridline", d: `M${CHART_MARGIN.left} ${y(power)}H${right}` }),
      svg("text", { class: "label quiet", x: CHART_MARGIN.left - 8, y: y(power) + 4, "text-anchor": "end" },
        power === 0 ? "1" : ["10", svg("tspan", { dy: -5, "font-size": 9 }, power)])]),
    svg("text", { class: "label quiet", x: 4, y: 11 }, dial.unit),
    dial.severities.map((severity, k) => svg("text", { class: "label quiet", x: x(k), y: bottom + 17,
      "text-anchor": "middle" }, severity)),
    svg("text", { class: "label quiet", x: CHART_MARGIN.left, y: CHART_HEIGHT - 6 }, brief(dial.label)),
    svg("path", { class: "current", d: `M${x(position)} ${CHART_MARGIN.top - 8}V${bottom}` }),
    groups.map((group) => curveLine(group, x, y, store)),
    endLabels(groups, x(last), y, bottom, store),
    dial.severities.map((_, k) => svg("rect", { class: "touch", y: 0, height: CHART_HEIGHT,
      x: x(k) - (x(1) - x(0)) / 2, width: x(1) - x(0),
      click: () => store.set({ scenesIndex: dial.scenes[k] }) }))));
}

/// Curves that agree in every point are one, with all their names.
function curvesAlike(curves) {
  const found = new Map();
  for (const curve of curves) {
    const key = JSON.stringify(curve.points);
    found.set(key, [...(found.get(key) ?? []), curve]);
  }
  return [...found.values()].map((group) => {
    const text = group.map((curve) => curve.name).join(", ");
    const short = text.length > LONGEST_LABEL
      ? `${group[0].name.slice(0, LONGEST_LABEL - 12)} and ${group.length - 1} more` : text;
    return { curves: group, points: group[0].points, shape: group[0].shape, text: short };
  });
}

function curveClass(group, store) {
  return store.methodShown !== null && !group.curves.some((curve) => curve.name === store.methodShown);
}

function curveLine(group, x, y, store) {
  const at = group.points.map((point, k) => [x(k), y(logarithm(point.error)), point])
    .filter(([, , point]) => point.error !== null);
  return svg("g", { class: curveClass(group, store) ? "faded" : null },
    svg("polyline", { class: `curve line-${group.shape % 7}`,
      points: at.map(([px, py]) => `${px.toFixed(1)},${py.toFixed(1)}`).join(" ") }),
    at.map(([px, py, point]) => [glyph(group.shape, px.toFixed(1), py.toFixed(1), 3.5),
      point.wrong === "0" ? null
        : svg("path", { class: "cross", d: `M${px - 5} ${py - 5}l10 10m0 -10l-10 10` })]));
}

/// Names at the curves' ends, pushed apart.
function endLabels(groups, end, y, bottom, store) {
  const ends = groups.map((group) => ({ group, at: y(logarithm(lastError(group))) }))
    .sort((a, b) => a.at - b.at);
  let floor = CHART_MARGIN.top - LABEL_LINE;
  const spread = ends.map(({ group, at }) => {
    floor = Math.max(at, floor + LABEL_LINE);
    return { group, at, place: floor };
  });
  let ceiling = bottom + LABEL_LINE;
  for (const label of spread.reverse()) {
    ceiling = Math.min(label.place, ceiling - LABEL_LINE);
    label.place = ceiling;
  }
  return spread.map(({ group, at, place }) => svg("g", { class: curveClass(group, store) ? "faded" : null },
    svg("path", { class: "leader", d: `M${end + 6} ${at}L${end + 16} ${place}` }),
    svg("text", { class: "label", x: end + 20, y: place + 4 }, group.text)));
}

function lastError(group) {
  return group.points.filter((point) => point.error !== null).at(-1)?.error ?? "0";
}

function logarithm(error) {
  return error === null ? NaN : Math.log10(Number(error));
}
