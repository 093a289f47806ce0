// three.js (npm three), Ray.intersectsSphere: "`true` if this ray intersects with the given sphere". Ray: "the
// (normalized) direction of the ray". Silent about tangents. Source: src/math/Ray.js.
import { run } from "./raycheck_candidate.mjs";
import { Ray, Sphere, Vector3 } from "three";

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  return ray.intersectsSphere(new Sphere(new Vector3(...centre), radius));
}

run("three-test", {
  directions: "unit", returns: "class", root: "nearest", tangent: "either", level: "ordinary", intersect,
});
