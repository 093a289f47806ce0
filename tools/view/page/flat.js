// The figure from the side and from above, parallel, in SVG: where there is no WebGL, or when asked for.
import { svg } from "./dom.js";
import { dotProduct, homogeneous, onPane, parallelViewer, pixelsOf, plus, strokesOf, times } from "./projection.js";

const MOST_CIRCLES = 2000;
const GREATEST_RADIUS = 1e5; // pixels: browsers draw circles in single precision
const MARKS = {
  disc: "M1 0A1 1 0 1 1 -1 0A1 1 0 1 1 1 0Z", square: "M-.85 -.85H.85V.85H-.85Z", diamond: "M0 -1.1L1.1 0L0 1.1L-1.1 0Z",
  ring: "M1 0A1 1 0 1 1 -1 0A1 1 0 1 1 1 0ZM.6 0A.6 .6 0 1 0 -.6 0A.6 .6 0 1 0 .6 0Z",
  cross: "M-1 -.2H-.2V-1H.2V-.2H1V.2H.2V1H-.2V.2H-1Z",
};

/// Two panes beside or above each other, for a figure of that size.
export function flatPanes(list, width, height) {
  const [side, up, back] = list.axes;
  const isWide = width > 2.2 * height; // a frustum is long
  const size = isWide ? { width: width / 2, height } : { width, height: height / 2 };
  const [fromSide, fromAbove] = [[times(back, -1), up, side], [times(back, -1), times(side, -1), up]];
  const [U, V] = list.camera ? ["U", "V"] : ["x", "y"];
  const second = isWide ? { x: size.width, y: 0 } : { x: 0, y: size.height };
  return [
    { ...size, x: 0, y: 0, title: `from the side, along ${U}`, viewer: viewerOfAll(list, fromSide, size) },
    { ...size, ...second, title: `from above, along ${V}`, viewer: viewerOfAll(list, fromAbove, size) },
  ];
}

function viewerOfAll({ whole, size }, axes, { width, height }) {
  const ranges = axes.map((axis) => {
    const shown = whole.map((point) => dotProduct(axis, point));
    return [Math.min(...shown), Math.max(...shown)];
  });
  const middle = ranges.map(([low, high], k) => times(axes[k], (low + high) / 2)).reduce(plus);
  const [halfX, halfY] = ranges.map(([low, high]) => (high - low) / 2);
  const unit = 1.2 * Math.max(halfX / width, halfY / height) || size / width; // of a pixel
  return parallelViewer(axes, middle, unit * width, unit * height);
}

/// Draws a list into panes; returns what is not drawn.
export function paintFlat(target, list, panes) {
  const shown = list.spheres.slice(0, MOST_CIRCLES);
  target.replaceChildren(...panes.map((pane) => {
    const { x, y, width, height } = pane;
    return svg("svg", { x, y, width, height }, svg("text", { x: 10, y: 20 }, pane.title),
      shown.map((sphere) => flatCircle(sphere, pane)), list.segments.map((segment) => flatPath(segment, pane)),
      list.points.map((point) => flatMark(point, pane)));
  }));
  const large = panes.some((pane) => list.spheres.some(({ radius }) => radiusOn(pane, radius) > GREATEST_RADIUS));
  return [
    ...(list.spheres.length > MOST_CIRCLES ? [`Of ${list.spheres.length} spheres ${MOST_CIRCLES} are drawn here.`] : []),
    ...(large ? ["Spheres too large for this view are not drawn here."] : []),
  ];
}

export function cssColour(colour) {
  return `rgb(${colour.map((share) => Math.round(255 * share)).join(" ")})`;
}

const radiusOn = ({ viewer: { window }, width }, radius) => (radius / (window[1] - window[0])) * width;

function flatCircle({ centre, radius, colour }, pane) {
  const [cx, cy] = pixelsOf(homogeneous(pane.viewer, centre), pane);
  const r = radiusOn(pane, radius);
  if (Math.max(r, Math.abs(cx), Math.abs(cy)) > GREATEST_RADIUS) return null;
  return svg("circle", { cx, cy, r: Math.max(r, 2), fill: cssColour(colour), "fill-opacity": 0.35, stroke: cssColour(colour) });
}

function flatPath(segment, pane) {
  const told = (stroke) => stroke.map((end) => pixelsOf(end, pane).join(" ")).join("L");
  const strokes = strokesOf(pane, segment).map(told);
  return strokes.length === 0 ? null : svg("path", {
    d: `M${strokes.join("M")}`, stroke: cssColour(segment.colour), "stroke-width": segment.isThick ? 2.4 : 1.2,
  });
}

function flatMark({ at, colour, shape, size }, pane) {
  const place = onPane(pane, at);
  return place && svg("path", {
    d: MARKS[shape], transform: `translate(${place}) scale(${size / 2})`, fill: cssColour(colour), "fill-rule": "evenodd",
  });
}
