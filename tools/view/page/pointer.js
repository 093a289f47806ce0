// Mouse and touch on the figure, and what lies under a click.
import { onPane, pixelUnder } from "./projection.js";

const REACH = 14; // pixels around a point that choose it
const STILL = 4; // a pointer that moves less has clicked

/// Calls turn(x, y) in radians, move(x, y) in heights of the stage, zoom(factor) and pick(x, y) in pixels. Two fingers
/// zoom and move, Shift or the other button moves; the wheel zooms only a figure that has been clicked.
export function followPointers(stage, { turn, move, zoom, pick }) {
  const down = new Map();
  let moved = 0;
  const middle = () => {
    const places = [...down.values()];
    const [x, y] = [0, 1].map((k) => places.reduce((sum, place) => sum + place[k], 0) / places.length);
    return { x, y, spread: Math.hypot(places[0][0] - x, places[0][1] - y) };
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
    moved += Math.abs(x) + Math.abs(y) + Math.abs(after.spread - before.spread);
    if (moved < STILL) return;
    if (down.size > 1) zoom(before.spread / Math.max(after.spread, 1));
    if (down.size > 1 || event.shiftKey || event.buttons === 2) move(x / stage.clientHeight, y / stage.clientHeight);
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
    if (document.activeElement !== stage) return;
    event.preventDefault();
    zoom(Math.exp(event.deltaY / 600));
  }, { passive: false });
}

/// The part of a selection that lies under (x, y) of a figure, or null.
export function pickedAt({ camera, points }, panes, x, y) {
  const pane = panes.find((one) => x >= one.x && y >= one.y && x < one.x + one.width && y < one.y + one.height);
  if (!pane) return null;
  const { viewer, width, height } = pane;
  if (viewer.isEye) {
    const [x0, x1, y0, y1] = viewer.window.map((tangent) => tangent * Math.abs(camera.near));
    const pixel = pixelUnder(camera, x0 + (x / width) * (x1 - x0), y1 + (y / height) * (y0 - y1));
    return pixel && { pixel };
  }
  let [nearest, least] = [null, REACH];
  for (const { at, select } of points) {
    const place = select && onPane(pane, at);
    const away = place ? Math.hypot(place[0] + pane.x - x, place[1] + pane.y - y) : Infinity;
    if (away < least) [nearest, least] = [select, away];
  }
  return nearest;
}
