// A right candidate in JavaScript, which implements all functions; its output does not disturb the protocol.
import { run } from "./raycheck_candidate.mjs";

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const sub = (a, b) => a.map((x, k) => x - b[k]);
const add = (a, b) => a.map((x, k) => x + b[k]);
const times = (k, a) => a.map((x) => k * x);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => times(1 / Math.hypot(...a), a);

function frame(camera) {
  const w = unit(sub(camera.eye, camera.lookAt));
  const u = unit(cross(camera.up, w));
  return [u, cross(w, u), w];
}

const shares = { edges: (k, n) => k / (n - 1), centres: (k, n) => (k + 0.5) / n, corners: (k, n) => k / n };
const across = (first, last, k, n, samples) => first + (last - first) * shares[samples](k, n);

function sight(camera, asked, [i, j]) {
  const [u, v, w] = frame(camera);
  const [first, last] = asked.rows === "top-first" ? ["top", "bottom"] : ["bottom", "top"];
  const alpha = across(camera.left, camera.right, i, camera.width, asked.samples);
  const beta = across(camera[first], camera[last], j, camera.height, asked.samples);
  return add(times(camera.near, w), add(times(alpha, u), times(beta, v)));
}

const pixelPoint = (camera, asked, pixel) => add(camera.eye, sight(camera, asked, pixel));
const pixelRay = (camera, asked, pixel) => {
  const g = sight(camera, asked, pixel);
  return { origin: add(camera.eye, g), direction: unit(g) };
};
const focalRay = (camera, asked, pixel) => ({ origin: camera.eye, direction: unit(sight(camera, asked, pixel)) });

function intersect({ origin, direction }, { centre, radius }, asked) {
  const t = sub(centre, origin), a = dot(direction, direction), b = dot(t, direction), m = cross(t, direction);
  const underRoot = a * radius * radius - dot(m, m);
  if (underRoot < 0 || (underRoot === 0 && asked.tangent === "miss")) return null;
  const q = b + (b < 0 ? -1 : 1) * Math.sqrt(underRoot);
  const other = (Math.hypot(...t) - radius) * (Math.hypot(...t) + radius) / q;
  const [smaller, larger] = [other, q / a].sort((x, y) => x - y);
  const s = smaller >= 0 || asked.root === "smaller" ? smaller : larger;
  return s >= 0 ? { s, point: add(origin, times(s, direction)) } : null;
}

function nearest(ray, spheres, asked) {
  let least = Infinity, found = null;
  for (const [k, sphere] of spheres.entries()) {
    const hit = intersect(ray, sphere, asked);
    if (hit && hit.s < least) [least, found] = [hit.s, k];
  }
  return found;
}

console.log("hello");
run("right", { frame, pixelPoint, pixelRay, focalRay, intersect, nearest, corners: "as-asked" });
