// The figure without WebGL: from the side and from above, parallel, in SVG.

import { svg } from "./dom.js";
import { arrowHead, clipSegment, dotProduct, homogeneous, onScreen, parallelViewer, times } from "./projection.js";

const MOST_CIRCLES = 2000;

/// Two panes beside or above each other: what each holds is seen along an axis.
export function flatPanes(list, width, height) {
  const [side, up, back] = list.axes;
  const isWide = width > 1.3 * height;
  const [paneWidth, paneHeight] = isWide ? [width / 2, height] : [width, height / 2];
  const views = [
    { name: "from the side (along U)", axes: [times(back, -1), up, side] },
    { name: "from above (along V)", axes: [times(back, -1), times(side, -1), up] },
  ];
  return views.map(({ name, axes }, k) => ({
    name: list.camera ? name : name.replace("U", "x").replace("V", "y"),
    x: isWide ? k * paneWidth : 0, y: isWide ? 0 : k * paneHeight, width: paneWidth, height: paneHeight,
    viewer: paneViewer(list, axes, paneWidth, paneHeight),
  }));
}

function paneViewer(list, axes, width, height) {
  const shown = list.frame.map((point) => axes.map((axis) => dotProduct(axis, point)));
  const range = [0, 1, 2].map((k) => [Math.min(...shown.map((p) => p[k])), Math.max(...shown.map((p) => p[k]))]);
  const middle = [0, 1, 2].map((k) => axes.reduce((sum, axis, n) => sum + (axis[k] * (range[n][0] + range[n][1])) / 2, 0));
  const half = [0, 1].map((n) => (range[n][1] - range[n][0]) / 2 || list.size);
  const unit = 1.2 * Math.max(half[0] / width, half[1] / height); // of a pixel
  return parallelViewer(axes, middle, unit * width, unit * height);
}

/// Draws a list into panes; returns what could not be drawn.
export function paintFlat(target, list, panes) {
  const notes = [];
  target.replaceChildren(...panes.map((pane) => svg("svg", {
    x: pane.x, y: pane.y, width: pane.width, height: pane.height, overflow: "hidden",
  }, svg("text", { x: 10, y: 20, class: "figure-pane" }, pane.name), circles(list, pane), strokes(list, pane), marks(list, pane))));
  if (list.spheres.length > MOST_CIRCLES) notes.push(`Of ${list.spheres.length} spheres ${MOST_CIRCLES} are drawn here.`);
  return notes;
}

export function cssColour(colour) {
  return `rgb(${colour.map((share) => Math.round(255 * share)).join(" ")})`;
}

function circles(list, { viewer, width, height }) {
  const [x0, x1] = viewer.window;
  return list.spheres.slice(0, MOST_CIRCLES).map(({ centre, radius, colour, isChosen }) => {
    const at = onScreen(viewer, centre, width, height);
    const r = (radius / (x1 - x0)) * width;
    // A browser draws circles in single precision: of one much larger than the pane nothing right would be seen.
    if (at === null || r > 1e5 || Math.hypot(at[0], at[1]) > 1e6) return null;
    return svg("circle", {
      cx: at[0], cy: at[1], r: Math.max(r, 2), fill: cssColour(colour), "fill-opacity": 0.35, stroke: cssColour(colour), "stroke-width": isChosen ? 3 : 1.2,
    });
  });
}

function strokes(list, { viewer, width, height }) {
  return list.segments.flatMap(({ from, to, colour, thick, isDashed, hasArrow }) => {
    const clipped = clipSegment(homogeneous(viewer, from), homogeneous(viewer, to), viewer.nearest);
    if (!clipped) return [];
    return [clipped, ...(hasArrow ? arrowHead(...clipped, width, height) : [])].map((piece, k) => {
      const [[x1, y1], [x2, y2]] = piece.map(([x, y]) => [((x + 1) / 2) * width, ((1 - y) / 2) * height]);
      return svg("line", {
        x1, y1, x2, y2, stroke: cssColour(colour), "stroke-width": thick ? 2.4 : 1.2, "stroke-dasharray": isDashed && k === 0 ? "5 5" : null,
      });
    });
  });
}

const MARKS = {
  disc: "M1 0A1 1 0 1 1 -1 0A1 1 0 1 1 1 0Z", square: "M-.85 -.85H.85V.85H-.85Z", diamond: "M0 -1.1L1.1 0L0 1.1L-1.1 0Z",
  ring: "M1 0A1 1 0 1 1 -1 0A1 1 0 1 1 1 0ZM.6 0A.6 .6 0 1 0 -.6 0A.6 .6 0 1 0 .6 0Z",
  cross: "M-1 -.2H-.2V-1H.2V-.2H1V.2H.2V1H-.2V.2H-1Z",
};

function marks(list, { viewer, width, height }) {
  return list.points.map(({ at, colour, shape, size }) => {
    const place = onScreen(viewer, at, width, height);
    return place && svg("path", {
      d: MARKS[shape], transform: `translate(${place[0]} ${place[1]}) scale(${size / 2})`, fill: cssColour(colour), "fill-rule": "evenodd",
    });
  });
}
