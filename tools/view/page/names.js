// Names in the figure: each beside its place, none over another.
import { around, label } from "./marks.js";
import { onPane } from "./projection.js";

const TURNS = [0.5, 7.5, 3.5, 4.5, 1, 3, 2, 5, 6, 7, 0, 4]; // where a name is tried, in turns of 45 degrees

/// Writes names {at, text, colour} over panes, the first first; returns how many found no room.
export function writeNames(target, names, panes) {
  const written = panes.flatMap((pane) => {
    const taken = [];
    return names.flatMap(({ at, text, colour }) => {
      const place = onPane(pane, at);
      return place ? [label(text, [place[0] + pane.x, place[1] + pane.y], colour, pane, taken, around(TURNS))] : [];
    });
  });
  target.replaceChildren(...written.flat().filter((node) => node !== null));
  return written.filter((nodes) => nodes === null).length;
}
