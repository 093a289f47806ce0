// The figure from the side and from above, in parallel projection, in SVG. Used if there is no
// WebGL, or if chosen.
import { svg } from "./dom.js";
import { dotProduct, homogeneous, onPane, pixelsOf, plus, strokesOf, times } from "./projection.js";

const MOST_CIRCLES = 2000;
const GREATEST_RADIUS = 1e5; // pixels: browsers draw circles in single precision
const MARKS = {
  disc: "M1 0A1 1 0 1 1 -1 0A1 1 0 1 1 1 0Z",
  square: "M-.85 -.85H.85V.85H-.85Z",
  diamond: "M0 -1.1L1.1 0L0 1.1L-1.1 0Z",
  ring: "M1 0A1 1 0 1 1 -1 0A1 1 0 1 1 1 0ZM.6 0A.6 .6 0 1 0 -.6 0A.6 .6 0 1 0 .6 0Z",
  cross: "M-1 -.2H-.2V-1H.2V-.2H1V.2H.2V1H-.2V.2H-1Z",
};

/// Two panes, one above the other, for a figure of this size.
export function flatPanes(list, width, height) {
  const [side, up, back] = list.axes;
  const [U, V] = list.camera ? ["U", "V"] : ["x", "y"];
  const size = { width, height: height / 2 };
  const views = [[`from the side, along ${U}`, [times(back, -1), up, side]],
    [`from above, along ${V}`, [times(back, -1), times(side, -1), up]]];
  return views.map(([title, axes], k) =>
    ({ ...size, x: 0, y: k * size.height, title, viewer: viewerOfAll(list, axes, size) }));
}

function viewerOfAll({ whole, figure }, axes, { width, height }) {
  const ranges = axes.map((axis) => {
    const shown = whole.map((point) => dotProduct(axis, point));
    return [Math.min(...shown), Math.max(...shown)];
  });
  const position = ranges.map(([low, high], k) => times(axes[k], (low + high) / 2)).reduce(plus);
  const [halfX, halfY] = ranges.map(([low, high]) => (high - low) / 2);
  const unit = 1.2 * Math.max(halfX / width, halfY / height) || figure.size / width; // per pixel
  const window = [-unit * width, unit * width, -unit * height, unit * height];
  return { isParallel: true, position, axes, window, nearest: 0, start: 0 };
}

/// Draws a list into panes; returns the same kind of result as the WebGL painter.
export function paintFlat(target, list, panes) {
  const shown = list.spheres.slice(0, MOST_CIRCLES);
  let tooLarge = 0;
  target.replaceChildren(...panes.map((pane) => {
    const { x, y, width, height } = pane;
    const circles = shown.map((sphere) => flatCircle(sphere, pane));
    tooLarge += circles.filter((circle) => circle === null).length;
    return svg("svg", { x, y, width, height }, svg("text", { x: 10, y: 20 }, pane.title), circles,
      list.segments.map((segment) => flatPath(segment, pane)), list.points.map((point) => flatMark(point, pane)));
  }));
  const notes = [
    list.spheres.length > MOST_CIRCLES ? `Of ${list.spheres.length} spheres ${MOST_CIRCLES} are drawn here.` : "",
    tooLarge > 0 ? "Spheres too large or too far away for this view are not drawn here." : "",
  ];
  return { small: [], notes };
}

function flatCircle({ centre, radius, colour }, pane) {
  const [cx, cy] = pixelsOf(homogeneous(pane.viewer, centre), pane);
  const { viewer: { window }, width } = pane;
  const r = (radius / (window[1] - window[0])) * width;
  if (Math.max(r, Math.abs(cx), Math.abs(cy)) > GREATEST_RADIUS) return null;
  return svg("circle", { cx, cy, r: Math.max(r, 2), fill: colour, "fill-opacity": 0.35, stroke: colour });
}

function flatPath(segment, pane) {
  const strokes = strokesOf(pane, segment).map((ends) => `M${ends.map((end) => pixelsOf(end, pane)).join("L")}`);
  return svg("path", { d: strokes.join(""), stroke: segment.colour, "stroke-width": segment.thick ? 2.4 : 1.2 });
}

function flatMark({ at, colour, shape, size }, pane) {
  const place = onPane(pane, at);
  const transform = `translate(${place}) scale(${size / 2})`;
  return place && svg("path", { d: MARKS[shape], transform, fill: colour, "fill-rule": "evenodd" });
}
