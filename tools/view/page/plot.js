// Errors as points or curves, each with its name beside it. An axis goes by powers of ten; 0 and
// infinity have rows of their own, and stretches in which nothing lies may be cut out.
import { LETTER, alike, brief, glyph, svg } from "./dom.js";
import { freeBox } from "./names.js";

const ROW = 24; // pixels: of zeros, of infinities
const WIDEST_GAP = 2.5; // decades with nothing in them that are not cut out
const CUT = 16; // pixels that stand for them
const LEAST_STRETCH = 0.8; // decades
const PADDING = 0.12; // decades beyond the first and the last point
const LABEL_LINE = 15; // pixels: from a label's line to the next
const LONGEST_LABEL = 30; // letters
const BESIDE = [0, 4, 0.5, 3.5, 7.5, 4.5, 1, 3, 7, 5, 2, 6]; // where a point's name is tried, in turns of 45 degrees
const LEAST_APART = 9; // pixels: the marks of a curve
const CONDITION = "kappa of the problem";
const DASHES = ["none", "7 3", "2 2.5", "9 3 2 3", "4 2 1 2 1 2"];

/// Where numbers and "infinity" lie between the pixels `from` (the least) and `to`.
export function powerAxis(values, from, to, mayCut = false) {
  const logs = values.filter((value) => value > 0 && value !== "infinity").map(Math.log10).sort((a, b) => a - b);
  const stretches = [];
  for (const log of logs.length > 0 ? logs : [0]) {
    const last = stretches.at(-1);
    if (last && !(mayCut && log - last.high > WIDEST_GAP)) last.high = log;
    else stretches.push({ low: log, high: log });
  }
  const way = Math.sign(to - from);
  const zero = values.includes(0) ? ROW : 0;
  const infinite = values.includes("infinity") ? ROW : 0;
  for (const one of stretches) {
    const room = Math.max(PADDING, (LEAST_STRETCH - one.high + one.low) / 2);
    [one.low, one.high] = [one.low - room, one.high + room];
  }
  const decades = stretches.reduce((sum, one) => sum + one.high - one.low, 0);
  const scale = (Math.abs(to - from) - zero - infinite - CUT * (stretches.length - 1)) / decades;
  let at = from + way * zero;
  for (const one of stretches) {
    one.at = at;
    at += way * ((one.high - one.low) * scale + CUT);
  }
  const ofLog = (log) => {
    const one = stretches.findLast(({ low }) => low <= log) ?? stretches[0];
    return one.at + way * (log - one.low) * scale;
  };
  const place = (value) => (value === 0 ? from + way * zero / 2 : value === "infinity" ? to - way * infinite / 2 : ofLog(Math.log10(value)));
  const rows = [[zero, 0, "0"], [infinite, "infinity", "\u221e"]].filter(([size]) => size > 0)
    .map(([size, value, text]) => ({ at: place(value), size, text }));
  const cuts = stretches.slice(1).map((one) => one.at - way * CUT / 2);
  const ticks = ticksOf(stretches, scale).map(([mantissa, power]) => ({ at: ofLog(Math.log10(mantissa) + power), mantissa, power }));
  return { place, rows, cuts, ticks: ticks.filter((tick) => rows.every((row) => Math.abs(row.at - tick.at) > LABEL_LINE)) };
}

function ticksOf(stretches, scale) {
  const mantissas = scale > 110 ? [1, 2, 5] : [1];
  const every = Math.ceil(34 / scale);
  return stretches.flatMap(({ low, high }) => {
    const powers = [...Array(Math.ceil(high) - Math.floor(low) + 1).keys()].map((k) => Math.floor(low) + k);
    return powers.filter((power) => power % every === 0).flatMap((power) => mantissas.map((mantissa) => [mantissa, power]))
      .filter(([mantissa, power]) => mantissa * 10 ** power >= 10 ** low && mantissa * 10 ** power <= 10 ** high);
  });
}

function tickText({ mantissa, power }) {
  if (Math.abs(power) <= 3) return String(Number((mantissa * 10 ** power).toPrecision(1)));
  return [mantissa === 1 ? "10" : `${mantissa}\u00b710`, svg("tspan", { dy: -5, "font-size": 9 }, power)];
}

/// A row, a grid line and a label for each tick of the axis of errors, a zigzag for what is cut out.
function errorAxis(axis, { left, right, top, bottom }, unit) {
  return [axis.rows.map(({ at, size, text }) => [
    svg("rect", { class: "row", x: left, y: at - size / 2, width: right - left, height: size }),
    svg("text", { class: "label quiet", x: left - 8, y: at + 4, "text-anchor": "end" }, text)]),
  axis.ticks.map((tick) => [svg("path", { class: "gridline", d: `M${left} ${tick.at}H${right}` }),
    svg("text", { class: "label quiet", x: left - 8, y: tick.at + 4, "text-anchor": "end" }, tickText(tick))]),
  axis.cuts.map((at) => [svg("path", { class: "cut-line", d: `M${left + 8} ${at}H${right}` }),
    svg("path", { class: "cut", d: `M${left - 6} ${at + 2}l4 -6l4 8l4 -6` })]),
  svg("text", { class: "label quiet", x: 2, y: top - 10 }, unit),
  svg("path", { class: "axis", d: `M${left} ${top}V${bottom}H${right}` })];
}

/// The mark of a method: pale where decisions are wrong that are excused, crossed where they are not.
export function methodMark(number, standing, x, y, size) {
  return svg("g", { class: standing === "right" ? null : "pale" }, glyph(number, x, y, size),
    standing === "defect" ? svg("path", { class: "cross", d: `M${x} ${y}m${-size} ${-size}l${2 * size} ${2 * size}m0 ${-2 * size}l${-2 * size} ${2 * size}` }) : null);
}

/// A small plot is part of something that has a name.
function described(isSmall, label) {
  return isSmall ? { "aria-hidden": "true" } : { role: "img", "aria-label": label };
}

/// Points {name, number, time: {ratio, low, high}, error, standing, isFront}; without names where small.
export function pointPlot({ points, runTimes, errors, width, tall, unit, timeText, isSmall, label }) {
  const pane = { left: isSmall ? 40 : 58, right: width - 14, top: isSmall ? 8 : 28, bottom: tall - (isSmall ? 24 : 44) };
  const y = powerAxis(errors, pane.bottom, pane.top, !isSmall);
  const x = powerAxis(runTimes, pane.left, pane.right);
  const placed = points.map((point) => ({ ...point, y: y.place(point.error),
    x: x.place(point.time.ratio), low: x.place(point.time.low), high: x.place(point.time.high) }));
  const front = placed.filter((point) => point.isFront).sort((a, b) => a.x - b.x);
  const size = isSmall ? 3.2 : 5.5;
  return svg("svg", { viewBox: `0 0 ${width} ${tall}`, class: "instrument", ...described(isSmall, label) }, svg("g", { "aria-hidden": "true" },
    errorAxis(y, pane, unit),
    x.ticks.map((tick) => [svg("path", { class: "gridline", d: `M${tick.at} ${pane.top}V${pane.bottom}` }),
      svg("text", { class: "label quiet", x: tick.at, y: pane.bottom + 16, "text-anchor": "middle" }, tickText(tick))]),
    svg("text", { class: "label quiet", x: pane.right, y: tall - 6, "text-anchor": "end" }, timeText),
    front.length === 0 ? null : svg("path", { class: "front", d: `M${front[0].x} ${pane.top}${front.map((point) => `V${point.y}H${point.x}V${point.y}`).join("")
      .replace(/^V[^H]*H[^V]*/, "")}H${pane.right}` }),
    placed.map((point) => svg("g", { "data-method": point.number },
      isSmall ? null : svg("path", { class: `spread line-${point.number % 7}`, d: `M${point.low} ${point.y}H${point.high}` }),
      methodMark(point.number, point.standing, point.x, point.y, size),
      svg("circle", { class: "touch", cx: point.x, cy: point.y, r: isSmall ? 7 : 11 }))),
    isSmall ? null : pointNames(placed, pane)));
}

/// Those on the front first; a name that finds no room is left to the list of methods.
function pointNames(placed, { left, right, top, bottom }) {
  const pane = { x: left + 2, y: top - 6, width: right - left + 10, height: bottom - top + 4 };
  const taken = placed.map(({ x, y, low, high }) => ({ x: Math.min(x - 6, low), y: y - LABEL_LINE / 2, width: Math.max(12, high - low + 6) }));
  return [...placed].sort((a, b) => b.isFront - a.isFront).map(({ name, number, x, y, isFront }) => {
    const text = brief(name, LONGEST_LABEL);
    const box = freeBox(x, y, LETTER * text.length + 6, pane, taken, BESIDE);
    if (box === null) return null;
    taken.push(box);
    return svg("g", { "data-method": number },
      box.isApart ? svg("path", { class: "leader", d: `M${box.from}L${box.joint}` }) : null,
      svg("text", { class: isFront ? "label strong" : "label", x: box.x + 3, y: box.y + 11 }, text));
  });
}

/// Curves {name, number, errors: [number, "infinity" or null], standings: [...]}, one of each at
/// every severity; `condition` is a curve of errors alone.
export function curvePlot({ curves, condition, severities, current, errors, width, tall, unit, severityText, isSmall, label, classOf, onSeverity }) {
  const groups = alike(curves, (curve) => JSON.stringify([curve.errors, curve.standings])).map((same) => ({ ...same[0], text: namesText(same),
    attributes: { "data-method": same.map(({ number }) => number).join(" "), class: classOf?.(same) } }));
  const named = condition === null ? groups : [...groups, { text: CONDITION, errors: condition, attributes: {} }];
  const room = isSmall ? 10 : 26 + Math.max(0, ...named.map(({ text }) => text.length)) * LETTER;
  const pane = { left: isSmall ? 40 : 58, right: width - room, top: isSmall ? 8 : 28, bottom: tall - (isSmall ? 24 : 44) };
  const y = powerAxis(errors, pane.bottom, pane.top);
  const step = (pane.right - pane.left) / Math.max(1, severities.length - 1);
  const x = (k) => pane.left + k * step;
  const every = Math.ceil((Math.max(...severities.map((text) => String(text).length)) * LETTER + 8) / step);
  const line = (list) => list.map((error, k) => (error === null ? "" : `${k === 0 || list[k - 1] === null ? "M" : "L"}${x(k).toFixed(1)} ${y.place(error).toFixed(1)}`)).join("");
  const marked = Math.ceil(LEAST_APART / step);
  return svg("svg", { viewBox: `0 0 ${width} ${tall}`, class: "instrument", ...described(isSmall, label) }, svg("g", { "aria-hidden": "true" },
    errorAxis(y, pane, unit),
    severities.map((severity, k) => (k % every > 0 ? null
      : svg("text", { class: "label quiet", x: x(k), y: pane.bottom + 16, "text-anchor": "middle" }, severity))),
    svg("text", { class: "label quiet", x: pane.left, y: tall - 6 }, severityText),
    current === undefined ? null : svg("path", { class: "current", d: `M${x(current)} ${pane.top - 8}V${pane.bottom}` }),
    condition === null ? null : svg("path", { class: "condition", d: line(condition) }),
    groups.map((group) => svg("g", group.attributes,
      svg("path", { class: `curve line-${group.number % 7}`, "stroke-dasharray": DASHES[group.number % DASHES.length], d: line(group.errors) }),
      svg("path", { class: "curve touch-line", d: line(group.errors) }),
      group.errors.map((error, k) => (error === null || k % marked > 0 ? null : methodMark(group.number, group.standings[k], x(k), y.place(error), isSmall ? 2 : 3.5))))),
    isSmall ? null : endNames(named, pane, x, y),
    onSeverity === undefined ? null : severities.map((_, k) => svg("rect", { class: "touch", x: x(k) - step / 2, y: 0, width: step, height: tall, click: () => onSeverity(k) }))));
}

function namesText(same) {
  const all = same.map(({ name }) => name).join(", ");
  if (all.length <= LONGEST_LABEL) return all;
  return brief(same[0].name, LONGEST_LABEL - 12) + (same.length > 1 ? ` and ${same.length - 1} more` : "");
}

/// Names beside the curves' ends, pushed apart: first downwards, then up from the axis.
function endNames(groups, { right, top, bottom }, x, y) {
  const names = groups.map((group) => {
    const isThere = (k) => (group.errors[k] ?? null) !== null;
    const joined = group.errors.findLastIndex((_, k) => isThere(k) && isThere(k - 1));
    const end = joined >= 0 ? joined : group.errors.findLastIndex((_, k) => isThere(k));
    return { group, end: x(end) + 5, at: y.place(group.errors[end]) };
  }).sort((a, b) => a.at - b.at);
  let last = top - LABEL_LINE;
  for (const name of names) last = name.place = Math.max(name.at, last + LABEL_LINE);
  let next = bottom + LABEL_LINE;
  for (const name of names.toReversed()) next = name.place = Math.min(name.place, next - LABEL_LINE);
  return names.map(({ group, end, at, place }) => svg("g", group.attributes,
    svg("path", { class: `leader line-${group.number % 7}`, d: `M${end} ${at}H${right + 5}L${right + 16} ${place}` }),
    svg("text", { class: group.number === undefined ? "label quiet" : "label", x: right + 20, y: place + 4 }, group.text)));
}
