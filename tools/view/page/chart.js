// Error against run time, or against severity: every method a point or a curve, every family at once.
import { alike, atEachWidth, brief, briefSentence, choice, disclosure, element, rangeField, svg, table } from "./dom.js";
import { curvePlot, methodMark, pointPlot } from "./plot.js";

const CHART_TALL = { wide: 520, narrow: 420, small: 170 }; // pixels
const NARROW_CHART = 600;

/// What is looked at: a facet (a family's stage), one of its quantities, a quantile, a severity
/// (null: all together), against run time or severity.
export function mountChart(root, chart) {
  root.hidden = false;
  const first = chart.facets[0];
  const state = { facet: first, quantity: 0, share: chart.share, severity: null, isTime: hasTimes(first), pinned: null };
  const heading = element("h2", { id: "chart-heading" });
  const [controls, drawing, chips, multiples] = ["controls", "drawing", "methods", "multiples"].map((id) => element("div", { id: `chart-${id}` }));
  const readout = element("p", { id: "chart-readout", role: "status" });
  const figures = element("div", {});
  const folded = disclosure("All figures as a table", figures);
  const marksKey = element("p", { class: "marks quiet" });
  const look = { root, chart, state, heading, marksKey, controls, drawing, chips, multiples, readout };
  const fill = () => folded.open && figures.replaceChildren(figuresTable(look));
  look.set = (partial) => {
    Object.assign(state, partial);
    if ("facet" in partial) Object.assign(state, { severity: null, pinned: null, isTime: state.isTime ? hasTimes(state.facet) : !hasCurves(state.facet) });
    if ("facet" in partial || "isTime" in partial) showControls(look);
    showChosen(look);
    fill();
  };
  controls.className = "fields";
  root.append(heading, controls, drawing, readout, marksKey, chips, folded, multiples);
  folded.addEventListener("toggle", fill);
  for (const part of [drawing, multiples, chips]) listenTo(part, look);
  atEachWidth(drawing, () => showChosen(look));
  showControls(look);
  showChosen(look);
}

const hasTimes = (facet) => facet.series.some((one) => one.time !== null && one.whole !== null);
const hasCurves = (facet) => facet.severities.length > 0;
const pointOf = (one, { severity }) => (severity === null ? one.whole : one.points[severity]);
const errorOf = (point, { quantity, share }) => point?.errors[quantity].at[share] ?? null;
const nameOf = ({ name }) => (name.endsWith("error") ? name : `${name} error`);
const standingOf = (point) => (point.defects > 0 ? "defect" : point.wrong > 0 ? "excused" : "right");

function figureOf(value) {
  if (value === null) return "-";
  if (value === "infinity") return "infinite";
  const isPlain = value === 0 || (value >= 1e-3 && value < 1e6);
  return isPlain ? String(Number(value.toPrecision(3))) : value.toExponential(2);
}

function showControls({ chart, state, controls, set }) {
  const focused = document.activeElement?.id;
  const stages = alike(chart.facets, (facet) => facet.stage).map(([facet]) => facet.stage);
  const facets = chart.facets.filter((facet) => facet.stage === state.facet.stage);
  const find = (stage, subject) => chart.facets.find((facet) => facet.stage === stage && facet.subject === subject) ?? chart.facets.find((facet) => facet.stage === stage);
  const { severities } = state.facet;
  const dial = rangeField("chart-severity", "Severity", severities.length, (k) => (k === 0 ? "all" : severities[k - 1]), (k) => set({ severity: k === 0 ? null : k - 1 }));
  dial.input.show(state.severity === null ? 0 : state.severity + 1);
  const parts = [
    [stages.length > 1, () => choice("chart-stage", "Of", stages.map((text) => [text, text]), state.facet.stage,
      (text) => set({ facet: find(text, state.facet.subject), quantity: 0 }))],
    [facets.length > 1, () => choice("chart-family", "On", facets.map(({ subject }) => [subject, subject]), state.facet.subject,
      (text) => set({ facet: find(state.facet.stage, text) }))],
    [hasTimes(state.facet) && hasCurves(state.facet), () => choice("chart-against", "Against", [["time", "run time"], ["severity", "severity"]],
      state.isTime ? "time" : "severity", (text) => set({ isTime: text === "time", severity: null }))],
    [true, () => choice("chart-quantity", "Error of", state.facet.quantities.map(({ name }, k) => [k, name]), state.quantity, (k) => set({ quantity: Number(k) }))],
    [true, () => choice("chart-quantile", "Quantile", chart.shares.map((text, k) => [k, text]), state.share, (k) => set({ share: Number(k) }))],
    [state.isTime && hasCurves(state.facet), () => dial.field],
  ];
  controls.replaceChildren(...parts.filter(([isThere]) => isThere).map(([, make]) => make()));
  if (focused?.startsWith("chart-")) document.getElementById(focused)?.focus();
}

/// The heading, the large chart, the methods and the small charts, as the state says.
function showChosen(look) {
  const { chart, state, heading, marksKey, drawing, chips, multiples } = look;
  const { facet } = state;
  const quantity = facet.quantities[state.quantity];
  const where = state.severity === null ? "" : ` at severity ${facet.severities[state.severity]}`;
  const text = `${facet.stage} on ${brief(facet.subject)}${where}: ${chart.shares[state.share]} ${nameOf(quantity)} against ${state.isTime ? "run time" : "severity"}`;
  heading.replaceChildren(text[0].toUpperCase() + text.slice(1));
  marksKey.replaceChildren(...marksLegend(state.isTime));
  const width = Math.floor(drawing.clientWidth);
  if (width > 0) drawing.replaceChildren(facetPlot(facet, look, width, width < NARROW_CHART ? CHART_TALL.narrow : CHART_TALL.wide, text));
  chips.replaceChildren(...facet.series.map((one) => {
    const point = state.isTime ? pointOf(one, state) : one.points.find((each) => errorOf(each, state) !== null);
    const isDrawn = errorOf(point, state) !== null && (!state.isTime || one.time !== null);
    return element("button", { type: "button", class: "chip", "data-method": one.number, "aria-pressed": String(state.pinned === one.number), click: () => pin(look, one.number) },
      svg("svg", { class: "chip-mark", viewBox: "0 0 16 16", "aria-hidden": "true" }, methodMark(one.number, "right", 8, 8, 5.5)), brief(one.name), isDrawn ? null : " (not drawn)");
  }));
  const others = chart.facets.filter((other) => other.stage === facet.stage && (state.isTime ? hasTimes(other) : hasCurves(other)));
  multiples.replaceChildren(...(others.length < 2 || width === 0 ? [] : others.map((other) => element("button",
    { type: "button", class: "multiple", "aria-current": String(other === facet), click: () => look.set({ facet: other }) },
    element("span", {}, brief(other.subject)), facetPlot(other, look, 240, CHART_TALL.small, other.subject, others)))));
  highlight(look, state.pinned);
}

/// A facet as a plot; small, with the axes of `others`, where those are given.
function facetPlot(facet, { state, chart }, width, tall, label, others) {
  const here = { ...state, severity: state.severity === null || facet.severities.length === 0 ? null : Math.min(state.severity, facet.severities.length - 1) };
  const isSmall = others !== undefined;
  const shared = others ?? [facet];
  const { unit } = facet.quantities[here.quantity];
  if (here.isTime) {
    const drawn = (one) => one.time !== null && errorOf(pointOf(one, here), here) !== null;
    const points = facet.series.filter(drawn).map((one) => {
      const point = pointOf(one, here);
      return { ...one, error: errorOf(point, here), standing: standingOf(point), isFront: point.errors[here.quantity].front[here.share] };
    });
    const all = isSmall ? shared.flatMap((other) => other.series.map((one) => errorOf(one.whole, here))).filter((error) => error !== null) : points.map(({ error }) => error);
    const runTimes = shared.flatMap((other) => other.series.filter((one) => one.time !== null).flatMap(({ time }) => [time.low, time.ratio, time.high]));
    return pointPlot({ points, runTimes, errors: all, width, tall, isSmall, label,
      unit: isSmall ? "" : `${chart.shares[here.share]} error, ${unit}`, timeText: isSmall ? "" : `run time, times that of ${brief(facet.baseline, 30)}` });
  }
  const curves = facet.series.map((one) => ({ ...one, errors: one.points.map((point) => errorOf(point, here)), standings: one.points.map((point) => point && standingOf(point)) }))
    .filter(({ errors }) => errors.some((error) => error !== null));
  const condition = facet.severities.map((_, k) => facet.series.map((one) => one.points[k]?.errors[here.quantity].condition[here.share] ?? null).find((value) => value !== null) ?? null);
  const all = shared.flatMap((other) => other.series.flatMap((one) => one.points.map((point) => errorOf(point, here)))).filter((error) => error !== null);
  return curvePlot({ curves, condition: isSmall ? null : condition, severities: facet.severities, errors: isSmall ? all : [...all, ...condition.filter((value) => value !== null)], width,
    tall: isSmall ? tall : Math.max(tall, 15 * curves.length + 80), isSmall, label, unit: isSmall ? "" : `${chart.shares[here.share]} error, ${unit}`,
    severityText: isSmall ? "" : `severity: ${facet.meaning}` });
}

/// What a method's mark says, in a sentence.
function figuresText(one, { facet, isTime, quantity, share, ...rest }, chart) {
  const point = isTime ? pointOf(one, rest) : null;
  const time = one.time === null ? one.note : `${figureOf(one.time.ratio)} times the run time of ${facet.baseline} (middle half ${figureOf(one.time.low)} to ${figureOf(one.time.high)}; ${figureOf(one.time.ns)} ns an item)`;
  const { unit } = facet.quantities[quantity];
  const error = `${chart.shares[share]} ${nameOf(facet.quantities[quantity])}`;
  const errors = point === null
    ? `${error} in ${unit} by severity: ${one.points.map((each, k) => `${facet.severities[k]}: ${figureOf(errorOf(each, { quantity, share }))}`).join(", ")}`
    : `${error} ${figureOf(errorOf(point, { quantity, share }))} ${unit}, of ${point.errors[quantity].compared}`;
  const decisions = point === null ? "" : `${point.wrong} of ${point.decisions} decisions wrong${point.wrong > 0 ? `, ${point.defects} of them without an excuse` : ""}`;
  return [time, errors, decisions].filter((text) => text !== "").join("; ");
}

function highlight({ root, state, chart, readout }, number) {
  for (const node of root.querySelectorAll("[data-method]")) {
    const isHere = number === null || node.dataset.method.split(" ").includes(String(number));
    node.classList.toggle("faded", !isHere && node.localName === "g");
  }
  const one = state.facet.series.find((each) => each.number === number);
  readout.replaceChildren(...(one === undefined ? ["Point at a method, or choose one below, for its figures."]
    : [element("strong", {}, brief(one.name)), `: ${briefSentence(figuresText(one, state, chart))}`]));
}

function pin(look, number) {
  look.set({ pinned: look.state.pinned === number ? null : number });
  look.chips.querySelector(`[data-method="${number}"]`)?.focus();
}

function listenTo(part, look) {
  const numberAt = (event) => {
    const found = event.target.closest("[data-method]");
    return found === null ? null : Number(found.dataset.method.split(" ")[0]);
  };
  for (const name of ["pointerover", "focusin"]) part.addEventListener(name, (event) => highlight(look, numberAt(event) ?? look.state.pinned));
  for (const name of ["pointerleave", "focusout"]) part.addEventListener(name, () => highlight(look, look.state.pinned));
}

function marksLegend(isTime) {
  const entry = (standing, text) => element("span", {}, svg("svg", { class: "chip-mark", viewBox: "0 0 16 16", "aria-hidden": "true" }, methodMark(6, standing, 8, 8, 5)), text);
  return [entry("right", "every decision right"), entry("excused", "wrong ones, all within rounding of the inputs"), entry("defect", "wrong without an excuse"),
    element("span", {}, isTime ? "Steps: no method without such defects is as fast and as accurate" : "kappa: how much the problem itself magnifies errors of the inputs")];
}

/// Every method of the facet, every severity, every quantile of the quantity.
function figuresTable({ chart, state: { facet, quantity } }) {
  const { name, unit } = facet.quantities[quantity];
  const rows = facet.series.flatMap((one) => [["all", one.whole], ...one.points.map((point, k) => [facet.severities[k], point])]
    .filter(([, point]) => point).map(([severity, point]) => [brief(one.name), one.time ? figureOf(one.time.ratio) : "-", one.time ? figureOf(one.time.ns) : "-", severity,
      ...point.errors[quantity].at.map(figureOf), point.errors[quantity].compared, point.decisions, point.wrong, point.defects].map(String)));
  return table(`${facet.stage} on ${brief(facet.subject)}: ${name} errors in ${unit}; run time in times that of ${facet.baseline || "nothing: none was taken"}`,
    ["method", "run time", "ns an item", "severity", ...chart.shares, "compared", "decisions", "wrong", "without an excuse"], rows);
}
