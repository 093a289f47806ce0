// Names in the figure: each beside its place, none over another.

import { LETTER, svg } from "./dom.js";
import { cssColour } from "./flat.js";
import { onScreen } from "./projection.js";

const LINE = 15; // pixels

/// Writes labels over panes {viewer, x, y, width, height}; returns how many found no room.
export function writeNames(target, labels, panes) {
  const written = panes.flatMap((pane) => placed(labels, pane));
  target.replaceChildren(...written.flatMap(({ at, box, text, colour }) => {
    const [x, y] = [box.x + 4, box.y + LINE - 4];
    const joint = [Math.min(Math.max(at[0], box.x), box.x + box.width), Math.min(Math.max(at[1], box.y), box.y + LINE)];
    const isApart = Math.hypot(joint[0] - at[0], joint[1] - at[1]) > 12;
    return [
      isApart ? svg("line", { x1: at[0], y1: at[1], x2: joint[0], y2: joint[1], stroke: cssColour(colour), "stroke-width": 0.8 }) : null,
      svg("text", { x, y, fill: cssColour(colour) }, text),
    ].filter((node) => node !== null);
  }));
  return panes.reduce((missing, pane) => missing + pane.crowdedOut, 0);
}

/// The labels whose places are on a pane, each with the first free box around its place.
function placed(labels, pane) {
  const [taken, result] = [[], []];
  const anchors = labels
    .map((label) => ({ label, at: onScreen(pane.viewer, label.at, pane.width, pane.height) }))
    .filter(({ at }) => at !== null && at[0] >= 0 && at[1] >= 0 && at[0] <= pane.width && at[1] <= pane.height);
  pane.crowdedOut = 0;
  for (const { label, at } of anchors) {
    const box = freeBox(at, LETTER * label.text.length + 8, pane, taken);
    if (box === null) {
      pane.crowdedOut += 1;
      continue;
    }
    taken.push(box);
    const moved = ([x, y]) => [x + pane.x, y + pane.y];
    const [x, y] = moved([box.x, box.y]);
    result.push({ ...label, at: moved(at), box: { ...box, x, y } });
  }
  return result;
}

function freeBox([x, y], width, pane, taken) {
  const turns = [0, 0.5, 3.5, 4, 3, 1, 2.5, 1.5, 2, 5, 6, 7];
  for (const away of [9, 24, 42, 64, 90, 120]) {
    for (const turn of turns) {
      const angle = (turn * Math.PI) / 4;
      const [cx, cy] = [x + (away + width / 2) * Math.cos(angle), y - (away + LINE / 2) * Math.sin(angle)];
      const box = { x: cx - width / 2, y: cy - LINE / 2, width };
      const isInside = box.x >= 0 && box.y >= 0 && box.x + width <= pane.width && box.y + LINE <= pane.height;
      if (isInside && !taken.some((other) => meets(box, other))) return box;
    }
  }
  return null;
}

function meets(a, b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && Math.abs(a.y - b.y) < LINE;
}
