// Error against run time, or against severity: a point or a curve for every method, on all sources
// at once.
import { atEachWidth, brief, briefSentence, choice, disclosure, element } from "./dom.js";
import { rangeField, refill, svg, table } from "./dom.js";
import { methodMark } from "./marks.js";
import { plot } from "./plot.js";

const TALL = { wide: 520, narrow: 400, small: 170, name: 15, rest: 80 }; // pixels
const NARROW = 600;
const SMALL_WIDTH = 240;
const LONGEST_NAMES = 30; // letters in the joined names of methods whose curves are the same
const ALL = 0; // all severities together, if there are run times

const isTimed = (facet) => facet.baseline !== "";

/// The chart's selection: a facet (the methods of a stage on a source), one of its quantities, a
/// quantile, a severity. A dial's severity follows the store's scene.
export function mountChart(root, { chart, dial }, store) {
  const state = { facet: chart.facets[0], quantity: 0, share: chart.share, severity: ALL };
  const [heading, controls] = [element("h2", { id: `${root.id}-heading` }), element("div", { class: "fields" })];
  const [body, figures] = [element("div", { id: "chart-body" }), element("div", {})];
  const folded = disclosure("All figures as a table", figures);
  const readout = element("p", { id: "chart-readout", role: "status" });
  root.hidden = false;
  root.append(heading, dial === null ? "" : element("p", {}, briefSentence(dial.sentence)), controls, body);

  const highlight = (number) => {
    for (const { classList, dataset } of body.querySelectorAll("g[data-method]")) {
      classList.toggle("faded", number !== undefined && !dataset.method.split(" ").includes(number));
    }
    const one = state.facet.series.find((each) => String(each.number) === number);
    readout.replaceChildren(...(one === undefined ? ["Point at a method, or choose one below, for its figures."]
      : [element("strong", {}, brief(one.name)), `: ${briefSentence(figuresText(one, state, chart))}`]));
  };
  const show = () => {
    heading.replaceChildren(titleOf(state, chart));
    const width = Math.floor(body.clientWidth);
    if (width === 0) return;
    refill(body, element("div", { id: "chart-drawing" }, facetPlot(state, chart, dial, width)), readout,
      legendOf(state, chart), folded, smallCharts(state, chart, set));
    if (folded.open) figures.replaceChildren(figuresTable(state, chart));
    highlight();
  };
  const set = (partial) => {
    Object.assign(state, "facet" in partial ? { quantity: 0, severity: ALL } : {}, partial);
    if (state.shown !== state.facet) fillChoices(state, controls, chart, dial, store, set);
    state.slider.show(state.severity);
    show();
  };
  folded.addEventListener("toggle", show);
  for (const name of ["pointerover", "pointerleave", "focusin", "focusout"]) {
    body.addEventListener(name, ({ target }) => highlight(/over|in/.test(name)
      ? target.closest("[data-method]")?.dataset.method.split(" ")[0] : undefined));
  }
  set({});
  if (dial !== null) store.subscribe(() => set({ severity: Math.max(0, dial.scenes.indexOf(store.scenesIndex)) }));
  atEachWidth(body, show);
}

/// Fills in a facet's choices.
function fillChoices(state, controls, chart, dial, store, set) {
  const { facet } = state;
  const stops = facet.severities;
  const numbered = (names) => names.map((name, k) => [k, name]);
  state.slider = rangeField("severity", "Severity", stops.length - 1, (k) => stops[k],
    (k) => (dial === null ? set({ severity: k }) : store.set({ scenesIndex: dial.scenes[k] })));
  state.shown = facet;
  refill(controls,
    chart.facets.length === 1 ? null : choice("chart-facet", "Show", numbered(chart.facets.map(({ title }) => title)),
      chart.facets.indexOf(facet), (k) => set({ facet: chart.facets[k] })),
    choice("chart-quantity", "Error of", numbered(facet.quantities.map(({ name }) => name)), state.quantity,
      (k) => set({ quantity: Number(k) })),
    choice("chart-quantile", "Quantile", numbered(chart.shares), state.share, (k) => set({ share: Number(k) })),
    dial !== null || (isTimed(facet) && stops.length > 1) ? state.slider : null);
}

/// Sentences on the meaning of marks and lines and on methods that are not drawn, and the list of
/// all methods.
function legendOf(state, { key }) {
  const { facet: { series, key: lines } } = state;
  const entry = (number, standing, text) => [svg("svg", { class: "chip-mark", viewBox: "0 0 16 16",
    "aria-hidden": "true" }, methodMark(number, standing, 8, 8, 5.5)), text];
  const drawn = tracesOf(state).flatMap(({ methods }) => methods.split(" ").map(Number));
  const missing = series.filter(({ number }) => !drawn.includes(number))
    .map(({ name, text }) => brief(name) + (text === "" ? "" : ` (${text})`)).join(", ");
  return [missing === "" ? null : element("p", { id: "chart-absent", class: "quiet" }, `Not drawn: ${missing}.`),
    element("p", { class: "marks quiet" },
      [...key.map(({ standing, text }) => entry(6, standing, text)), lines].map((one) => element("span", {}, one))),
    element("div", { id: "chart-methods" }, series.map(({ number, name }) => element("button",
      { type: "button", class: "chip", "data-method": number }, entry(number, "right", brief(name)))))];
}

/// All sources of the stage, if there are several; each links to its own chart.
function smallCharts(state, chart, set) {
  const facets = chart.facets.filter(({ stage }) => stage === state.facet.stage);
  if (facets.length === 1) return [];
  return element("div", { id: "chart-multiples" }, facets.map((facet, k) => element("button",
    { type: "button", class: "multiple", id: `facet-${k}`, "aria-current": String(facet === state.facet),
      click: () => set({ facet }) },
    element("span", {}, brief(facet.subject)),
    facetPlot({ ...state, facet, severity: ALL }, chart, null, SMALL_WIDTH, facets))));
}

function titleOf({ facet, quantity, share, severity }, chart) {
  const where = isTimed(facet) && severity !== ALL ? ` at severity ${facet.severities[severity]}` : "";
  const error = `${chart.shares[share]} ${facet.quantities[quantity].error}`;
  return `${facet.title}${where}: ${error} against ${isTimed(facet) ? "run time" : "severity"}`;
}

/// A trace for every method of a facet that has something to draw; equal methods share one.
function tracesOf({ facet, quantity, share, severity }) {
  const placeOf = (x, point) => ({ x, y: point?.errors[quantity].at[share] ?? null, standing: point?.standing });
  const traces = facet.series.map(({ name, number, time, points }) => (isTimed(facet)
    ? { name, number, spread: [time?.low, time?.high], isFront: points[severity]?.errors[quantity].front[share],
      places: time === null ? [] : [placeOf(time.ratio, points[severity])] }
    : { name, number, places: points.map((point, k) => placeOf(k, point)) }))
    .filter(({ places }) => places.some(({ y }) => y !== null));
  return [...Map.groupBy(traces, ({ places }) => JSON.stringify(places)).values()].map((same) => {
    const all = same.map(({ name }) => name).join(", ");
    const more = same.length > 1 ? ` and ${same.length - 1} more` : "";
    const name = all.length <= LONGEST_NAMES ? all : brief(same[0].name, LONGEST_NAMES - 12) + more;
    return { ...same[0], name, methods: same.map(({ number }) => number).join(" ") };
  });
}

/// A facet as a plot. If `others` are given, it is small and has their axes.
function facetPlot(state, chart, dial, width, others) {
  const { facet, quantity, share, severity } = state;
  const isSmall = others !== undefined;
  const traces = tracesOf(state);
  const condition = facet.condition[quantity][share].map((y, x) => ({ x, y }));
  if (!isTimed(facet) && !isSmall && condition.some(({ y }) => y !== null)) {
    traces.push({ number: null, name: "kappa of the problem", places: condition });
  }
  const shared = [...traces, ...(others ?? []).flatMap((each) => tracesOf({ ...state, facet: each }))];
  const spans = (others ?? [facet]).flatMap(({ series }) => series.flatMap(({ time }) => time ?? []));
  const title = titleOf(state, chart) + (dial === null ? "" : `; severity ${facet.severities[severity]} is shown`);
  const least = width < NARROW ? TALL.narrow : TALL.wide;
  return plot({ traces, width, isSmall, title, severities: isTimed(facet) ? null : facet.severities,
    errors: shared.flatMap(({ places }) => places.map(({ y }) => y)).filter((y) => y !== null),
    tall: isSmall ? TALL.small : Math.max(least, TALL.name * traces.length + TALL.rest),
    runTimes: spans.flatMap(({ low, high }) => [low, high]), current: dial === null ? null : severity,
    unit: `${chart.shares[share]} error, ${facet.quantities[quantity].unit}`, under: facet.under });
}

/// A sentence on the meaning of a method's mark.
function figuresText({ text, points }, { facet, quantity, share, severity }, chart) {
  const { unit, error } = facet.quantities[quantity];
  const told = (point) => point?.errors[quantity].told[share] ?? "-";
  const all = points.map((point, k) => `${facet.severities[k]}: ${told(point)}`).join(", ");
  if (!isTimed(facet)) return `${chart.shares[share]} ${error} in ${unit} by severity: ${all}`;
  const point = points[severity];
  const judged = point === null ? "" : `, of ${point.errors[quantity].compared}; ${point.text}`;
  return `${text}; ${chart.shares[share]} ${error} ${told(point)} ${unit}${judged}`;
}

/// A table of every method of the facet, every severity and every quantile of the quantity.
function figuresTable({ facet, quantity }, chart) {
  const { name, unit } = facet.quantities[quantity];
  const row = (one, point, severity) => (point === null ? [] : [[brief(one.name), one.time?.told ?? "-", severity,
    ...point.errors[quantity].told, point.errors[quantity].compared, point.decisions, point.wrong, point.defects]]);
  return table(`${facet.title}: ${name} errors in ${unit}; ${facet.under}`,
    ["method", "run time", "severity", ...chart.shares, "compared", "decisions", "wrong", "without an excuse"],
    facet.series.flatMap((one) => one.points.flatMap((point, k) => row(one, point, facet.severities[k]))));
}
