// The dial of a stress family: its severities, and each method's error along them.
import { LETTER, alike, atEachWidth, brief, briefSentence, disclosure, element, glyph, rangeField, svg, table } from "./dom.js";

const TALL = 300; // pixels
const LABEL_LINE = 15; // pixels: from a label's line to the next
const LONGEST_LABEL = 30; // letters
const EDGE = { left: 52, top: 14, bottom: 44 }; // pixels
const POWERS = 6; // labels of the error axis, about

export function mountDial(root, store) {
  const { dial } = store.document;
  if (dial === null) return;
  root.hidden = false;
  const position = () => Math.max(0, dial.scenes.indexOf(store.scenesIndex));
  const { input, field } = rangeField("severity", "Severity", dial.severities.length - 1,
    (k) => String(dial.severities[k]), (k) => store.set({ scenesIndex: dial.scenes[k] }));
  const drawing = element("div", { id: "dial-view" });
  const rows = dial.curves.map((curve) => [brief(curve.name), ...curve.points.map((point) =>
    (point.error ?? "-") + (point.wrong === 0 ? "" : `, ${point.wrong} wrong`))]);
  root.append(element("h2", { id: "dial-heading" }, `Dial: ${dial.family}`), element("p", {}, briefSentence(dial.sentence)),
    field, drawing, disclosure("The curves as a table", table(`Largest error, in ${dial.unit}`,
      ["method", ...dial.severities.map(String)], rows)));
  const draw = () => {
    const width = Math.floor(drawing.clientWidth);
    if (width > 0) drawing.replaceChildren(errorCurves(dial, position(), width, store));
  };
  const show = () => {
    input.show(position());
    draw();
  };
  atEachWidth(drawing, draw);
  store.subscribe(show);
  show();
}

function errorCurves(dial, position, width, store) {
  const groups = alike(dial.curves, (curve) => JSON.stringify(curve.points)).map((curves) => ({
    points: curves[0].points, number: store.methodNumber(curves[0].name), text: curvesText(curves),
    class: store.methodShown === null || curves.some((curve) => curve.name === store.methodShown) ? null : "faded",
  }));
  const right = width - 26 - Math.max(...groups.map((group) => group.text.length)) * LETTER;
  const bottom = TALL - EDGE.bottom;
  const logs = groups.flatMap((group) => group.points.map(logarithm)).filter(Number.isFinite);
  const [low, high] = [Math.floor(Math.min(0, ...logs)), Math.ceil(Math.max(1, ...logs))];
  const step = (right - EDGE.left) / Math.max(1, dial.severities.length - 1);
  const x = (k) => EDGE.left + k * step;
  const y = (power) => bottom - (Math.max(power, low) - low) / (high - low) * (bottom - EDGE.top);
  const every = Math.ceil((high - low) / POWERS);
  const powers = [...Array(high - low + 1).keys()].map((k) => low + k).filter((power) => power % every === 0);
  return svg("svg", { viewBox: `0 0 ${width} ${TALL}`, class: "instrument", role: "img",
    "aria-label": `Largest error of each method against severity; severity ${dial.severities[position]} is shown` },
  svg("g", { "aria-hidden": "true" },
    powers.map((power) => [svg("path", { class: "gridline", d: `M${EDGE.left} ${y(power)}H${right}` }),
      svg("text", { class: "label quiet", x: EDGE.left - 8, y: y(power) + 4, "text-anchor": "end" },
        power === 0 ? "1" : ["10", svg("tspan", { dy: -5, "font-size": 9 }, power)])]),
    svg("text", { class: "label quiet", x: 2, y: 11 }, dial.unit),
    dial.severities.map((severity, k) =>
      svg("text", { class: "label quiet", x: x(k), y: bottom + 17, "text-anchor": "middle" }, severity)),
    svg("text", { class: "label quiet", x: EDGE.left, y: TALL - 6 }, "severity"),
    svg("path", { class: "current", d: `M${x(position)} ${EDGE.top - 8}V${bottom}` }),
    groups.map((group) => curveLine(group, x, y)),
    endLabels(groups, right, y, bottom),
    dial.severities.map((_, k) => svg("rect", { class: "touch", x: x(k) - step / 2, y: 0, width: step, height: TALL,
      click: () => store.set({ scenesIndex: dial.scenes[k] }) }))));
}

function curvesText(curves) {
  const all = curves.map((curve) => curve.name).join(", ");
  if (all.length <= LONGEST_LABEL) return all;
  return brief(curves[0].name, LONGEST_LABEL - 12) + (curves.length > 1 ? ` and ${curves.length - 1} more` : "");
}

function curveLine(group, x, y) {
  const at = group.points.map((point, k) => ({ point, x: x(k).toFixed(1), y: y(logarithm(point)).toFixed(1) }))
    .filter(({ point }) => !Number.isNaN(logarithm(point)));
  return svg("g", { class: group.class },
    svg("polyline", { class: `curve line-${group.number % 7}`, points: at.map((one) => `${one.x},${one.y}`).join(" ") }),
    at.map((one) => [glyph(group.number, one.x, one.y, 3.5), one.point.wrong === 0 ? null
      : svg("path", { class: "cross", d: `M${one.x} ${one.y}m-5 -5l10 10m0 -10l-10 10` })]));
}

/// Names beside the curves' ends, pushed apart: first downwards, then up from the axis.
function endLabels(groups, end, y, bottom) {
  const labels = groups.map((group) => {
    const last = group.points.filter((point) => !Number.isNaN(logarithm(point))).at(-1);
    return { group, at: last ? y(logarithm(last)) : bottom };
  }).sort((a, b) => a.at - b.at);
  let last = EDGE.top - LABEL_LINE;
  for (const label of labels) last = label.place = Math.max(label.at, last + LABEL_LINE);
  let next = bottom + LABEL_LINE;
  for (const label of labels.toReversed()) next = label.place = Math.min(label.place, next - LABEL_LINE);
  return labels.map(({ group, at, place }) => svg("g", { class: group.class },
    svg("path", { class: "leader", d: `M${end + 6} ${at}L${end + 16} ${place}` }),
    svg("text", { class: "label", x: end + 20, y: place + 4 }, group.text)));
}

/// Minus infinity of no error; no number where nothing was compared, or the error has no bound.
function logarithm({ error }) {
  return typeof error === "number" ? Math.log10(error) : NaN;
}
