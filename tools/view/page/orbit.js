// Turns, moves and zooms the figure by three's OrbitControls, and finds what lies under a click.
import { lengthOf, minus, onPane, pixelUnder, plus, shareSeen, times } from "./projection.js";

const FIELD = Math.PI / 6; // radians from the bottom to the top of the screen
const KEYS = { // factor of the distance, radians to the right, radians up
  a: [1, -0.1, 0], d: [1, 0.1, 0], w: [1, 0, 0.1], s: [1, 0, -0.1],
  "+": [0.8, 0, 0], "=": [0.8, 0, 0], "-": [1.25, 0, 0],
};
const REACH = 14; // pixels by which a click may miss a point
const STILL = 4; // pixels: a pointer that moves less has clicked

/// An orbit about what was last shown, scaled to size 1 for three.js; calls `redraw` as it moves.
export function createOrbit(stage, redraw) {
  const camera = new THREE.PerspectiveCamera((FIELD * 180) / Math.PI);
  let [axes, target, size, fitted] = [[], [], 1, 1];
  // One finger and the wheel scroll the page until the figure has been clicked.
  for (const kind of ["wheel", "touchstart", "touchmove"]) {
    stage.addEventListener(kind, (event) => {
      if (document.activeElement !== stage && !(event.touches?.length > 1)) event.stopImmediatePropagation();
    }, { capture: true, passive: true });
  }
  const controls = new THREE.OrbitControls(camera, stage);
  Object.assign(controls, { enableKeys: false, screenSpacePanning: true });
  const { update } = controls;
  controls.update = () => { // called by OrbitControls itself
    update();
    camera.updateMatrix();
    redraw();
  };
  const turn = (zoom, right, up) => {
    const { radius, phi, theta } = new THREE.Spherical().setFromVector3(camera.position.clone().sub(controls.target));
    camera.position.setFromSphericalCoords(radius * zoom, phi - up, theta + right).add(controls.target);
    controls.update();
  };
  stage.addEventListener("keydown", ({ key, altKey, ctrlKey, metaKey }) => {
    if (KEYS[key] && !(altKey || ctrlKey || metaKey)) turn(...KEYS[key]);
  });
  const inFigure = (x, y, z) => plus(times(axes[0], x), plus(times(axes[1], y), times(axes[2], z)));
  const distance = () => camera.position.distanceTo(controls.target);
  const orbit = {
    zoom: () => distance() / fitted,
    viewer(aspect) {
      const { elements: m } = camera.matrix;
      const high = Math.tan(FIELD / 2);
      return {
        position: plus(target, times(inFigure(...camera.position.toArray()), size)),
        axes: [inFigure(m[0], m[1], m[2]), inFigure(m[4], m[5], m[6]), inFigure(-m[8], -m[9], -m[10])],
        window: [-high * aspect, high * aspect, -high, high], nearest: (distance() * size) / 4096, start: 0,
      };
    },
    /// Shows all of `whole` from angles about axes [side, up, back].
    show(whole, about, [azimuth, elevation], aspect) {
      const middle = (places) => Math.min(...places) / 2 + Math.max(...places) / 2;
      axes = about;
      target = [0, 1, 2].map((k) => middle(whole.map((place) => place[k])));
      size = Math.max(...whole.map((place) => lengthOf(minus(place, target)))) || 1;
      controls.target.set(0, 0, 0);
      camera.position.setFromSphericalCoords(1 / Math.sin(FIELD / 2), Math.PI / 2 - elevation, azimuth);
      controls.update();
      // Moves nearer until the view is nearly full. (Near things grow faster than far things.)
      for (let k = 0; k < 4; ++k) turn(shareSeen(orbit.viewer(aspect), whole) + 0.12, 0, 0);
      fitted = distance();
    },
  };
  return orbit;
}

/// Calls pick(x, y), in pixels of the stage, for a click or a tap.
export function followClicks(stage, pick) {
  let [fromX, fromY] = [0, 0];
  stage.addEventListener("pointerdown", (event) => { [fromX, fromY] = [event.clientX, event.clientY]; });
  stage.addEventListener("pointerup", ({ clientX, clientY, button, isPrimary }) => {
    const box = stage.getBoundingClientRect();
    const isStill = Math.hypot(clientX - fromX, clientY - fromY) < STILL;
    if (isStill && isPrimary && button === 0) pick(clientX - box.left, clientY - box.top);
  });
}

/// The part of a selection that lies under (x, y) of a figure, or null.
export function pickedAt({ camera, points }, panes, x, y) {
  const pane = panes.find((one) => x >= one.x && y >= one.y && x < one.x + one.width && y < one.y + one.height);
  if (!pane) return null;
  const { viewer, width, height } = pane;
  if (viewer.isEye) {
    const [x0, x1, y0, y1] = viewer.window;
    const pixel = pixelUnder(camera, x0 + (x / width) * (x1 - x0), y1 + (y / height) * (y0 - y1));
    return pixel && { pixel };
  }
  const awayFrom = ([left, top]) => Math.hypot(left + pane.x - x, top + pane.y - y);
  const near = points.filter(({ select }) => select).map(({ at, select }) => ({ select, place: onPane(pane, at) }))
    .filter(({ place }) => place && awayFrom(place) < REACH).sort((a, b) => awayFrom(a.place) - awayFrom(b.place));
  return near[0]?.select ?? null;
}
