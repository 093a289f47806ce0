// Error against run time, or against severity: every method a point or a curve, every family at once.
import { alike, atEachWidth, brief, briefSentence, choice, disclosure, element, rangeField, refill, svg, table } from "./dom.js";
import { methodMark } from "./marks.js";
import { plot } from "./plot.js";

const TALL = { wide: 520, narrow: 400, small: 170, name: 15 }; // pixels
const NARROW = 600;
const SMALL_WIDTH = 240;
const LONGEST_NAMES = 30; // letters of methods whose curves are the same
const ALL = -1; // severities together

const isTimed = (facet) => facet.baseline !== "";
const ofKey = (standing, number = 6) => svg("svg", { class: "chip-mark", viewBox: "0 0 16 16", "aria-hidden": "true" },
  methodMark(number, standing, 8, 8, 5.5));

/// What is looked at: a facet (a stage's methods on a family), one of its quantities, a quantile, a severity. A dial's
/// severity is the store's scene.
export function mountChart(root, { chart, dial }, store) {
  root.hidden = false;
  const state = { facet: chart.facets[0], quantity: 0, share: chart.share, severity: ALL };
  const heading = element("h2", { id: `${root.id}-heading` });
  const part = (id) => element("div", { id: `chart-${id}` });
  const [controls, drawing, chips, multiples] = [part("controls"), part("drawing"), part("methods"), part("multiples")];
  const readout = element("p", { id: "chart-readout", role: "status" });
  const absent = element("p", { id: "chart-absent", class: "quiet" });
  const figures = element("div", {});
  const folded = disclosure("All figures as a table", figures);
  const marksKey = element("p", { class: "marks quiet" });
  controls.className = "fields";
  root.append(heading, controls, drawing, readout, absent, marksKey, chips, folded, multiples);

  const highlight = (number) => {
    for (const node of drawing.parentNode.querySelectorAll("g[data-method]")) {
      node.classList.toggle("faded", number !== null && !node.dataset.method.split(" ").includes(number));
    }
    const one = state.facet.series.find((each) => String(each.number) === number);
    readout.replaceChildren(...(one === undefined ? ["Point at a method, or choose one below, for its figures."]
      : [element("strong", {}, brief(one.name)), `: ${briefSentence(figuresText(one, state, chart))}`]));
  };
  const draw = () => {
    const width = Math.floor(drawing.clientWidth);
    if (width === 0) return;
    drawing.replaceChildren(facetPlot(state, chart, dial, width));
    const others = chart.facets.filter(({ stage }) => stage === state.facet.stage);
    multiples.replaceChildren(...others.map((facet) => element("button",
      { type: "button", class: "multiple", "aria-current": String(facet === state.facet), click: () => set({ facet }, true) },
      element("span", {}, brief(facet.subject)),
      facetPlot({ ...state, facet, severity: ALL }, chart, null, SMALL_WIDTH, others))).slice(others.length < 2 ? 1 : 0));
    highlight(null);
  };
  const show = () => {
    const { facet } = state;
    heading.replaceChildren(titleOf(state, chart));
    draw();
    const drawn = tracesOf(state).flatMap(({ methods }) => methods.split(" ").map(Number));
    const missing = facet.series.filter(({ number }) => !drawn.includes(number));
    absent.replaceChildren(missing.length === 0 ? "" : `Not drawn: ${missing.map(({ name, text }) => `${brief(name)}${
      text === "" ? "" : ` (${text})`}`).join(", ")}.`);
    marksKey.replaceChildren(...chart.key.map(({ standing, text }) => element("span", {}, ofKey(standing), text)),
      element("span", {}, facet.key));
    chips.replaceChildren(...facet.series.map(({ number, name }) => element("button",
      { type: "button", class: "chip", "data-method": number }, ofKey("right", number), brief(name))));
    if (folded.open) figures.replaceChildren(figuresTable(state, chart));
  };
  const showControls = () => {
    const { facet } = state;
    const stops = dial === null ? ["all", ...facet.severities] : facet.severities;
    const before = dial === null ? 1 : 0;
    const severity = rangeField("severity", "Severity", stops.length - 1, (k) => stops[k], (k) => (dial === null
      ? set({ severity: k - before }) : store.set({ scenesIndex: dial.scenes[k] })));
    state.showSeverity = () => severity.show(state.severity + before);
    refill(controls,
      chart.facets.length === 1 ? null : choice("chart-facet", "Show", chart.facets.map(({ title }, k) => [k, title]),
        chart.facets.indexOf(facet), (k) => set({ facet: chart.facets[k] }, true)),
      choice("chart-quantity", "Error of", facet.quantities.map(({ name }, k) => [k, name]), state.quantity,
        (k) => set({ quantity: Number(k) })),
      choice("chart-quantile", "Quantile", chart.shares.map((text, k) => [k, text]), state.share,
        (k) => set({ share: Number(k) })),
      dial !== null || (isTimed(facet) && facet.severities.length > 0) ? severity : null);
  };
  const set = (partial, isOther = false) => {
    Object.assign(state, isOther ? { quantity: 0, severity: ALL } : {}, partial);
    if (isOther) showControls();
    state.showSeverity();
    show();
  };
  folded.addEventListener("toggle", show);
  for (const [name, isHere] of [["pointerover", true], ["focusin", true], ["pointerleave", false], ["focusout", false]]) {
    for (const place of [drawing, multiples, chips]) {
      place.addEventListener(name, ({ target }) =>
        highlight((isHere && target.closest("[data-method]")?.dataset.method.split(" ")[0]) || null));
    }
  }
  atEachWidth(drawing, draw);
  set({}, true);
  if (dial !== null) {
    root.insertBefore(element("p", {}, briefSentence(dial.sentence)), controls);
    store.subscribe(() => set({ severity: Math.max(0, dial.scenes.indexOf(store.scenesIndex)) }));
  }
}

function titleOf({ facet, quantity, share, severity }, chart) {
  const where = severity === ALL ? "" : ` at severity ${facet.severities[severity]}`;
  const against = isTimed(facet) ? "run time" : "severity";
  return `${facet.title}${isTimed(facet) ? where : ""}: ${chart.shares[share]} ${facet.quantities[quantity].error} against ${against}`;
}

/// What is drawn of a facet: of every method that has something to draw a trace; those that are the same share one.
function tracesOf({ facet, quantity, share, severity }) {
  const placeOf = (x, point) => ({ x, y: point?.errors[quantity].at[share] ?? null, standing: point?.standing });
  const traces = facet.series.filter(({ time }) => time !== null || !isTimed(facet)).map(({ time, whole, points, ...one }) => {
    const point = severity === ALL ? whole : points[severity];
    if (!isTimed(facet)) return { ...one, places: points.map((each, k) => placeOf(k, each)) };
    return { ...one, isFront: point?.errors[quantity].front[share], spread: [time.low, time.high],
      places: [placeOf(time.ratio, point)] };
  });
  const there = traces.filter(({ places }) => places.some(({ y }) => y !== null));
  return alike(there, ({ places }) => JSON.stringify(places)).map((same) => ({ ...same[0], name: namesText(same),
    methods: same.map(({ number }) => number).join(" ") }));
}

function namesText(same) {
  const all = same.map(({ name }) => name).join(", ");
  if (all.length <= LONGEST_NAMES) return all;
  return brief(same[0].name, LONGEST_NAMES - 12) + (same.length > 1 ? ` and ${same.length - 1} more` : "");
}

/// A facet as a plot; small, with the axes of `others`, where those are given.
function facetPlot(state, chart, dial, width, others) {
  const { facet, quantity, share, severity } = state;
  const isSmall = others !== undefined;
  const traces = tracesOf(state);
  const shared = (others ?? [facet]).map((each) => (each === facet ? traces : tracesOf({ ...state, facet: each })));
  const conditions = facet.severities.map((_, k) => ({ x: k, y: facet.series.map(({ points }) =>
    points[k]?.errors[quantity].condition[share] ?? null).find((value) => value !== null) ?? null }));
  if (!isTimed(facet) && !isSmall) traces.push({ number: null, methods: "", name: "kappa of the problem", places: conditions });
  const spans = (others ?? [facet]).flatMap(({ series }) => series.filter(({ time }) => time !== null));
  const errors = [...shared.flat(), ...traces].flatMap(({ places }) => places.map(({ y }) => y)).filter((y) => y !== null);
  const tall = isSmall ? TALL.small : Math.max(width < NARROW ? TALL.narrow : TALL.wide, TALL.name * traces.length + 80);
  return plot({ traces, errors, width, tall, isSmall, severities: isTimed(facet) ? null : facet.severities,
    runTimes: spans.flatMap(({ time }) => [time.low, time.high]), current: dial === null ? null : severity,
    unit: `${chart.shares[share]} error, ${facet.quantities[quantity].unit}`, under: facet.under,
    title: dial === null ? titleOf(state, chart) : `${titleOf(state, chart)}; severity ${facet.severities[severity]} is shown` });
}

/// What a method's mark says, in a sentence.
function figuresText({ text, whole, points }, { facet, quantity, share, severity }, chart) {
  const { unit, error } = facet.quantities[quantity];
  const told = (point) => point?.errors[quantity].told[share] ?? "-";
  const point = severity === ALL ? whole : points[severity];
  if (!isTimed(facet)) {
    const all = points.map((each, k) => `${facet.severities[k]}: ${told(each)}`).join(", ");
    return `${chart.shares[share]} ${error} in ${unit} by severity: ${all}`;
  }
  const errors = point === null ? "nothing was compared"
    : `${chart.shares[share]} ${error} ${told(point)} ${unit}, of ${point.errors[quantity].compared}; ${point.text}`;
  return text === "" ? errors : `${text}; ${errors}`;
}

/// Every method of the facet, every severity, every quantile of the quantity.
function figuresTable({ facet, quantity }, chart) {
  const { name, unit } = facet.quantities[quantity];
  const rows = facet.series.flatMap((one) => [["all", one.whole], ...one.points.map((point, k) => [facet.severities[k], point])]
    .filter(([, point]) => point).map(([severity, { errors, decisions, wrong, defects }]) => [brief(one.name),
      one.time?.told ?? "-", severity, ...errors[quantity].told, errors[quantity].compared, decisions, wrong, defects]));
  return table(`${facet.title}: ${name} errors in ${unit}; ${facet.under}`, ["method", "run time", "severity",
    ...chart.shares, "compared", "decisions", "wrong", "without an excuse"], rows);
}
