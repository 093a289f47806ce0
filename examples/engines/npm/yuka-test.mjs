// Yuka (npm yuka), Ray.intersectsBoundingSphere: "Performs a ray/sphere intersection test. Returns either true or false if
// there is a intersection or not." Directions and tangents: as in yuka.mjs. Source: build/yuka.module.js.
import { run } from "./raycheck_candidate.mjs";
import { BoundingSphere, Ray, Vector3 } from "yuka";

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  return ray.intersectsBoundingSphere(new BoundingSphere(new Vector3(...centre), radius));
}

run("yuka-test", {
  directions: "unit", returns: "class", root: "nearest", tangent: "either", level: "ordinary", intersect,
});
