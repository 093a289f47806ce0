// Errors as points or curves, with their names beside them. Error and time axes are logarithmic; 0
// and infinity have separate rows, and empty stretches may be cut out.
import { svg } from "./dom.js";
import { LABEL_LINE, LETTER, aroundPlace, inColumn, writeLabel, methodMark } from "./marks.js";

const ROW = 24; // pixels: of zeros, of infinities
const WIDEST_GAP = 2.5; // empty decades that are not cut out
const CUT = 16; // pixels that stand for the decades that are cut out
const LEAST_STRETCH = 0.8; // decades
const PADDING = 0.12; // decades beyond the first and the last point
const TICKS_APART = 34; // pixels, at least
const LEAST_APART = 9; // pixels: the marks of a curve
const BESIDE = aroundPlace([0, 4, 0.5, 3.5, 7.5, 4.5, 1, 3, 7, 5, 2, 6]);
const DASHES = ["none", "7 3", "2 2.5", "9 3 2 3", "4 2 1 2 1 2"];

/// Places of numbers and "infinity" between pixels `from` (the least) and `to`: place(value), and the axis's marks.
export function powerAxis(values, from, to, mayCut = false) {
  const logs = values.filter((value) => value > 0).map(Math.log10).sort((a, b) => a - b);
  const stretches = [];
  for (const log of logs.length > 0 ? logs : [0]) {
    const last = stretches.at(-1);
    if (last && !(mayCut && log - last.high > WIDEST_GAP)) last.high = log;
    else stretches.push({ low: log, high: log });
  }
  let decades = 0;
  for (const one of stretches) {
    const room = Math.max(PADDING, (LEAST_STRETCH - one.high + one.low) / 2);
    Object.assign(one, { low: one.low - room, high: one.high + room, before: decades });
    decades += one.high - one.low;
  }
  const [zero, infinite] = [0, "infinity"].map((value) => (values.includes(value) ? ROW : 0));
  const way = Math.sign(to - from);
  const scale = (Math.abs(to - from) - zero - infinite - CUT * (stretches.length - 1)) / decades;
  const ofLog = (log) => {
    const k = Math.max(0, stretches.findLastIndex(({ low }) => low <= log));
    return from + way * (zero + CUT * k + (stretches[k].before + log - stretches[k].low) * scale);
  };
  const place = (value) => (value === 0 ? from + way * zero / 2
    : value === "infinity" ? to - way * infinite / 2 : ofLog(Math.log10(value)));
  const rows = [[zero, 0, "0"], [infinite, "infinity", "\u221e"]].filter(([size]) => size > 0)
    .map(([, value, text]) => ({ at: place(value), text, isRow: true }));
  const every = Math.ceil(TICKS_APART / scale); // powers
  const mantissas = scale > 3 * TICKS_APART ? [1, 2, 5] : [1];
  const ticks = stretches.flatMap(({ low, high }) => [...Array(Math.ceil(high - low) + 1).keys()]
    .map((k) => Math.floor(low) + k).filter((power) => power % every === 0)
    .flatMap((power) => mantissas.map((one) => ({ log: Math.log10(one) + power, text: tickText(one, power) })))
    .filter(({ log }) => log >= low && log <= high)).map(({ log, text }) => ({ at: ofLog(log), text }))
    .filter(({ at }) => rows.every((row) => Math.abs(row.at - at) > LABEL_LINE));
  const cuts = stretches.slice(1).map(({ before }, k) => from + way * (zero + CUT * (k + 0.5) + before * scale));
  return { place, ticks: [...rows, ...ticks], cuts };
}

function tickText(mantissa, power) {
  if (Math.abs(power) <= 3) return String(Number((mantissa * 10 ** power).toPrecision(1)));
  return [mantissa === 1 ? "10" : `${mantissa}\u00b710`, svg("tspan", { dy: -5, "font-size": 9 }, power)];
}

/// Severities from left to right, labelled if there is room.
function severityAxis(severities, from, to) {
  const step = (to - from) / Math.max(1, severities.length - 1);
  const every = Math.ceil((Math.max(...severities.map((text) => text.length)) * LETTER + 8) / step);
  const place = (k) => from + k * step;
  const ticks = severities.map((text, k) => ({ at: place(k), text })).filter((_, k) => k % every === 0);
  return { place, step, ticks, cuts: [] };
}

/// The grid lines, rows and labels of an axis, upwards or to the right, and zigzags for what is cut out.
function axisMarks({ ticks, cuts }, { left, right, top, bottom }, isUp) {
  const across = (at) => (isUp ? `M${left} ${at}H${right}` : `M${at} ${top}V${bottom}`);
  return [ticks.map(({ at, text, isRow }) => [
    isRow ? svg("rect", { class: "row", x: left, y: at - ROW / 2, width: right - left, height: ROW })
      : svg("path", { class: "gridline", d: across(at) }),
    svg("text", { class: "label quiet", x: isUp ? left - 8 : at, y: isUp ? at + 4 : bottom + 16,
      "text-anchor": isUp ? "end" : "middle" }, text)]),
  cuts.map((at) => [svg("path", { class: "cut-line", d: across(at) }),
    svg("path", { class: "cut", d: `M${left - 6} ${at + 2}l4 -6l4 8l4 -6` })])];
}

/// Traces {number, methods, name, places: [{x, y, standing}], isFront, spread}: a method's single point over run times,
/// or its points over severities (y null: none), one of which may be `current`. Small plots have no names.
export function plot({ traces, severities, runTimes, errors, current, width, tall, unit, under, isSmall, title }) {
  const isOfPoints = severities === null;
  const names = isOfPoints ? 14 : 26 + Math.max(0, ...traces.map(({ name }) => name.length)) * LETTER;
  const pane = isSmall ? { left: 40, right: width - 10, top: 8, bottom: tall - 24 }
    : { left: 58, right: width - names, top: 28, bottom: tall - 44 };
  const y = powerAxis(errors, pane.bottom, pane.top, isOfPoints && !isSmall);
  const x = (isOfPoints ? powerAxis : severityAxis)(isOfPoints ? runTimes : severities, pane.left, pane.right);
  const placed = traces.map((trace) => ({ ...trace, places: trace.places.map((at) =>
    ({ ...at, isThere: at.y !== null, x: x.place(at.x), y: at.y === null ? 0 : y.place(at.y) })) }));
  const front = placed.filter(({ isFront }) => isFront).map(({ places }) => places[0]).sort((a, b) => a.x - b.x);
  const text = (attributes, content) => svg("text", { class: "label quiet", ...attributes }, isSmall ? "" : content);
  const look = isSmall ? { "aria-hidden": "true" } : { role: "img", "aria-label": title };
  return svg("svg", { viewBox: `0 0 ${width} ${tall}`, class: "instrument", ...look },
    svg("g", { "aria-hidden": "true" },
    axisMarks(y, pane, true), axisMarks(x, pane, false),
    svg("path", { class: "axis", d: `M${pane.left} ${pane.top}V${pane.bottom}H${pane.right}` }),
    text({ x: 2, y: pane.top - 10 }, unit), text({ x: width - 4, y: tall - 6, "text-anchor": "end" }, under),
    current === null ? null
      : svg("path", { class: "current", d: `M${x.place(current)} ${pane.top - 8}V${pane.bottom}` }),
    front.length === 0 ? null : svg("path", { class: "front",
      d: `M${front[0].x} ${pane.top}${front.map((at) => `H${at.x}V${at.y}`).join("")}H${pane.right}` }),
    placed.map((trace) => traceMarks(trace, x, isSmall)),
    isSmall ? null : namesBeside(placed, pane, isOfPoints)));
}

function traceMarks({ number, methods, places, spread }, x, isSmall) {
  const isAlone = (k) => !places[k - 1]?.isThere && !places[k + 1]?.isThere;
  const d = places.map((at, k) => (!at.isThere ? "" : isAlone(k) ? `M${at.x - 4} ${at.y}h8`
    : `${places[k - 1]?.isThere ? "L" : "M"}${at.x} ${at.y}`)).join("");
  if (number === null) return svg("path", { class: "condition", d });
  const every = Math.ceil(LEAST_APART / (x.step ?? LEAST_APART));
  const [size, stroke] = [(isSmall ? 0.6 : 1) * (places.length > 1 ? 3.5 : 5.5), `var(--series-${number % 7})`];
  return svg("g", { "data-method": methods },
    spread && !isSmall ? svg("path", { class: "spread", stroke,
      d: `M${x.place(spread[0])} ${places[0].y}H${x.place(spread[1])}` }) : null,
    svg("path", { class: "curve", stroke, "stroke-dasharray": DASHES[number % DASHES.length], d }),
    places.filter((at, k) => at.isThere && (k % every === 0 || isAlone(k))).map((at) => [
      methodMark(number, at.standing, at.x, at.y, size),
      svg("circle", { class: "touch", cx: at.x, cy: at.y, r: 2 * size })]));
}

/// Names of points go around them, the front's first; names of curves into a column at their ends, the lowest first.
function namesBeside(placed, { left, right, top, bottom }, isOfPoints) {
  const pane = { x: left + 2, y: top - 8, width: isOfPoints ? right - left + 10 : Infinity, height: bottom - top + 16 };
  const ends = placed.map((trace) => ({ ...trace, at: trace.places.findLast(({ isThere }) => isThere) }));
  const taken = isOfPoints ? ends.map(({ at }) => ({ x: at.x - 6, y: at.y - LABEL_LINE / 2, width: 12 })) : [];
  ends.sort((a, b) => (isOfPoints ? b.isFront - a.isFront : b.at.y - a.at.y));
  return ends.map(({ methods, name, isFront, at }) => svg("g", { "data-method": methods },
    writeLabel(name, [at.x + (isOfPoints ? 0 : 5), at.y], isFront ? "strong" : "", pane, taken,
      isOfPoints ? BESIDE : inColumn(right + 16))));
}
