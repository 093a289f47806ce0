// Mouse and touch on the figure, and what lies under a click.

import { drawnHit, clipSegment, homogeneous, onScreen, pixelUnder, plus, times, unitOf } from "./projection.js";

const REACH = 14; // pixels around a point that are the point's
const STILL = 4; // a pointer that moves less has clicked

/// Calls turn(x, y) in radians, pan(x, y) in heights of the stage, zoom(factor) and pick(x, y) in pixels.
export function orbitByPointer(stage, { turn, pan, zoom, pick }) {
  const down = new Map();
  let moved = 0;
  const middle = () => {
    const all = [...down.values()];
    const [x, y] = [0, 1].map((k) => all.reduce((sum, place) => sum + place[k], 0) / all.length);
    return { x, y, spread: Math.hypot(all[0][0] - x, all[0][1] - y) };
  };
  stage.addEventListener("pointerdown", (event) => {
    if (down.size === 0) moved = 0;
    down.set(event.pointerId, [event.clientX, event.clientY]);
    stage.setPointerCapture(event.pointerId);
  });
  stage.addEventListener("pointermove", (event) => {
    if (!down.has(event.pointerId)) return;
    const before = middle();
    down.set(event.pointerId, [event.clientX, event.clientY]);
    const after = middle();
    const [x, y] = [after.x - before.x, after.y - before.y];
    moved += Math.abs(x) + Math.abs(y);
    if (moved < STILL) return;
    if (down.size > 1) {
      zoom(before.spread / Math.max(after.spread, 1));
      pan(x / stage.clientHeight, y / stage.clientHeight);
    } else if (event.shiftKey || event.buttons === 2) pan(x / stage.clientHeight, y / stage.clientHeight);
    else turn(x / 150, y / 150);
  });
  stage.addEventListener("pointerup", (event) => {
    const box = stage.getBoundingClientRect();
    if (down.size === 1 && moved < STILL && event.button === 0) pick(event.clientX - box.left, event.clientY - box.top);
    down.delete(event.pointerId);
  });
  stage.addEventListener("pointercancel", (event) => down.delete(event.pointerId));
  stage.addEventListener("contextmenu", (event) => event.preventDefault());
  stage.addEventListener("wheel", (event) => {
    if (document.activeElement !== stage) return; // the page scrolls until the figure is clicked
    event.preventDefault();
    zoom(Math.exp(event.deltaY / 600));
  }, { passive: false });
}

/// The part of a selection that is under (x, y) of a pane: a pixel or a ray, else a sphere; null for neither.
export function pickedAt(list, pane, x, y, layers) {
  if (pane.viewer.isEye) return pixelSeenAt(list, pane, x, y);
  const near = [...list.points.filter((point) => point.select).map((point) => [point.select, pointAway(point, pane, x, y)]),
    ...list.segments.filter((segment) => segment.select).map((segment) => [segment.select, segmentAway(segment, pane, x, y) + REACH / 2])];
  const nearest = near.reduce((best, one) => (one[1] < best[1] ? one : best), [null, REACH]);
  if (nearest[0]) return nearest[0];
  return layers.spheres && !pane.viewer.parallel ? sphereAt(list, pane, x, y) : null;
}

function tangentsAt({ viewer, width, height }, x, y) {
  const [x0, x1, y0, y1] = viewer.window;
  return [x0 + (x / width) * (x1 - x0), y1 + (y / height) * (y0 - y1)];
}

function pixelSeenAt({ camera }, pane, x, y) {
  const depth = Math.abs(camera.near);
  const [across, along] = tangentsAt(pane, x, y);
  const pixel = pixelUnder(camera, across * depth, along * depth);
  return pixel && { pixel };
}

function pointAway({ at }, { viewer, width, height }, x, y) {
  const place = onScreen(viewer, at, width, height);
  return place === null ? Infinity : Math.hypot(place[0] - x, place[1] - y);
}

function segmentAway({ from, to }, { viewer, width, height }, x, y) {
  const clipped = clipSegment(homogeneous(viewer, from), homogeneous(viewer, to), viewer.nearest);
  if (!clipped) return Infinity;
  const [a, b] = clipped.map(([u, v, w]) => [((u / w + 1) / 2) * width, ((1 - v / w) / 2) * height]);
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const share = Math.min(Math.max(((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy || 1), 0), 1);
  return Math.hypot(a[0] + share * dx - x, a[1] + share * dy - y);
}

function sphereAt(list, pane, x, y) {
  const { axes, position } = pane.viewer;
  const [across, along] = tangentsAt(pane, x, y);
  const direction = unitOf(plus(axes[2], plus(times(axes[0], across), times(axes[1], along))));
  const met = list.spheres.map(({ index, centre, radius }) => ({ index, s: drawnHit(position, direction, centre, radius) }))
    .filter(({ s }) => s !== null).sort((a, b) => a.s - b.s)[0];
  return met ? { sphere: met.index } : null;
}
