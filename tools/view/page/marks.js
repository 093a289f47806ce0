// The marks of methods, and labels beside them that do not overlap.
import { svg } from "./dom.js";

export const LETTER = 6.7; // pixels: a letter of a drawing's label is narrower
export const LABEL_LINE = 15; // pixels: from a label's line to the next
const APART = 12; // pixels: a label farther away has a leader
const AWAY = [9, 24, 42, 64, 90, 120]; // pixels: where a label is tried
const COLUMN = [...Array(60).keys()]; // lines up, then down
const GLYPHS = ["M1 0A1 1 0 1 1 -1 0A1 1 0 1 1 1 0Z", "M-.9 -.9H.9V.9H-.9Z", "M0 -1.2L1.1 .8H-1.1Z",
  "M0 -1.3L1.1 0L0 1.3L-1.1 0Z", "M-.4 -1.2H.4V-.4H1.2V.4H.4V1.2H-.4V.4H-1.2V-.4H-.4Z", "M0 1.2L1.1 -.8H-1.1Z",
  "M0 -1.4L.4 -.4L1.4 0L.4 .4L0 1.4L-.4 .4L-1.4 0L-.4 -.4Z", "M-.6 -1.1H.6L1.2 0L.6 1.1H-.6L-1.2 0Z"];

/// The mark of method number k: eight shapes and seven colours make 56 different marks.
export function glyph(k, x, y, size) {
  const transform = `translate(${x} ${y}) scale(${size})`;
  return svg("path", { d: GLYPHS[k % 8], class: "glyph", fill: `var(--series-${k % 7})`, transform });
}

/// The mark of a method; pale if it has excused wrong decisions, crossed if it has wrong decisions
/// without an excuse.
export function methodMark(number, standing, x, y, size) {
  const cross = `M${x} ${y}m${-size} ${-size}l${2 * size} ${2 * size}m0 ${-2 * size}l${-2 * size} ${2 * size}`;
  return svg("g", { class: standing === "right" ? null : "pale" }, glyph(number, x, y, size),
    standing === "defect" ? svg("path", { class: "cross", d: cross }) : null);
}

/// Positions to try for a label of this width: around its place, in steps of 45 degrees; or in a column, upwards first.
export const aroundPlace = (turns) => (x, y, width) => AWAY.flatMap((away) => turns.map((turn) => {
  const [across, up] = [Math.cos(turn * Math.PI / 4), Math.sin(turn * Math.PI / 4)];
  return [x + (away + width / 2) * across - width / 2, y - (away + LABEL_LINE / 2) * up - LABEL_LINE / 2];
}));
export const inColumn = (left) => (x, y) =>
  [...COLUMN.map((k) => -k), ...COLUMN].map((k) => [left, y + (k - 0.5) * LABEL_LINE]);

function firstFree(places, [x, y], width, pane, taken) {
  const isFree = ([left, top]) => left >= pane.x && top >= pane.y
    && left + width <= pane.x + pane.width && top + LABEL_LINE <= pane.y + pane.height
    && !taken.some((box) => left < box.x + box.width && box.x < left + width && Math.abs(top - box.y) < LABEL_LINE);
  const found = places.find(isFree);
  if (found === undefined) return null;
  const [left, top] = found;
  const joint = [Math.min(Math.max(x, left), left + width), Math.min(Math.max(y, top), top + LABEL_LINE)];
  return { x: left, y: top, width, from: [x, y], joint, isApart: Math.hypot(joint[0] - x, joint[1] - y) > APART };
}

/// A text at the first free place of `places`, with a leader from (x, y); the place is then taken.
/// Null if none is free.
export function writeLabel(text, [x, y], look, pane, taken, places) {
  const width = LETTER * text.length + 6;
  const box = firstFree(places(x, y, width), [x, y], width, pane, taken);
  if (box === null) return null;
  taken.push(box);
  return [box.isApart ? svg("path", { class: "leader", d: `M${box.from}L${box.joint}` }) : null,
    svg("text", { class: `label ${look}`, x: box.x + 3, y: box.y + LABEL_LINE - 4 }, text)];
}
