// Names in the figure: each beside its place, none over another.
import { svg } from "./dom.js";
import { cssColour } from "./flat.js";
import { LETTER, freeBox } from "./marks.js";
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
      if (box.isApart) target.append(svg("path", { d: `M${box.from}L${box.joint}`, stroke: cssColour(colour) }));
      target.append(svg("text", { x: box.x + 3, y: box.y + LINE - 4, fill: cssColour(colour) }, text));
    }
  }
  return missing;
}
