// Rapier (npm @dimforge/rapier3d-compat: Rust's parry in WebAssembly, in floats), Ball.castRay: the
// time of impact, "or -1 if there is no intersection". "If `solid` is `false` then the ray will
// attempt to hit the boundary of a shape, even if its origin already lies inside". Directions of
// any length: `maxToi` "limits the length of the ray to ray.dir.norm() * maxToi". Silent about
// tangents. Source: geometry/shape.d.ts, geometry/collider.d.ts.
import { run } from "./raycheck_candidate.mjs";
import RAPIER from "@dimforge/rapier3d-compat";

await RAPIER.init();
const vector = ([x, y, z]) => ({ x, y, z });
const upright = { x: 0, y: 0, z: 0, w: 1 };

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new RAPIER.Ray(vector(origin), vector(direction));
  const s = new RAPIER.Ball(radius).castRay(ray, vector(centre), upright, Infinity, false);
  return s < 0 ? null : s;
}

run("rapier", {
  precision: "single", returns: "parameter", root: "nearest", tangent: "either", level: "ordinary",
  lengths: [2 ** -30, 2 ** 30], intersect,
});
