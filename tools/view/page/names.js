// Names in the figure: each beside its place, none over another.
import { aroundPlace, writeLabel } from "./marks.js";
import { onPane } from "./projection.js";

const TRIED = aroundPlace([0.5, 7.5, 3.5, 4.5, 1, 3, 2, 5, 6, 7, 0, 4]);

/// Writes names {at, text, colour} over panes, the first first; returns how many found no room.
export function writeNames(target, names, panes) {
  const written = panes.flatMap((pane) => {
    const taken = [];
    return names.flatMap(({ at, text, colour }) => {
      const place = onPane(pane, at);
      return place ? [writeLabel(text, [place[0] + pane.x, place[1] + pane.y], colour, pane, taken, TRIED)] : [];
    });
  });
  target.replaceChildren(...written.flat().filter((node) => node !== null));
  return written.filter((nodes) => nodes === null).length;
}
