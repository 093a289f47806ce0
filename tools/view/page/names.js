// Names in the figure: each beside its place, none over another.
import { LETTER, svg } from "./dom.js";
import { onPane } from "./projection.js";

const LINE = 15; // pixels

/// Writes names {at, text, colour} over panes; returns how many found no room.
export function writeNames(target, names, panes) {
  const taken = [];
  let missing = 0;
  target.replaceChildren();
  for (const pane of panes) {
    for (const { at, text, colour } of names) {
      const place = onPane(pane, at);
      const box = place && freeBox(place[0] + pane.x, place[1] + pane.y, LETTER * text.length + 6, pane, taken);
      if (place && !box) missing += 1;
      if (!box) continue;
      taken.push(box);
      if (box.isApart) target.append(svg("path", { d: `M${box.from}L${box.joint}`, stroke: colour }));
      target.append(svg("text", { x: box.x + 3, y: box.y + LINE - 4, fill: colour }, text));
    }
  }
  return missing;
}

/// The first box around a place that lies in the pane and on no other, in turns of 45 degrees.
export function freeBox(x, y, width, pane, taken, turns = [0.5, 7.5, 3.5, 4.5, 1, 3, 2, 5, 6, 7, 0, 4]) {
  for (const away of [9, 24, 42, 64, 90, 120]) {
    for (const turn of turns) {
      const angle = (turn * Math.PI) / 4;
      const left = x + (away + width / 2) * Math.cos(angle) - width / 2;
      const top = y - (away + LINE / 2) * Math.sin(angle) - LINE / 2;
      const isInside = left >= pane.x && top >= pane.y
        && left + width <= pane.x + pane.width && top + LINE <= pane.y + pane.height;
      const meets = (box) => left < box.x + box.width && box.x < left + width && Math.abs(top - box.y) < LINE;
      if (!isInside || taken.some(meets)) continue;
      const joint = [Math.min(Math.max(x, left), left + width), Math.min(Math.max(y, top), top + LINE)];
      return { x: left, y: top, width, from: [x, y], joint, isApart: Math.hypot(joint[0] - x, joint[1] - y) > 12 };
    }
  }
  return null;
}
