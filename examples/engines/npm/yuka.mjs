// Yuka (npm yuka), Ray.intersectBoundingSphere: "Performs a ray/sphere intersection test and stores the intersection point
// to the given 3D vector. If no intersection is detected, *null* is returned." Silent about unit directions,
// which the code needs, and tangents. Source: build/yuka.module.js.
import { run } from "./raycheck_candidate.mjs";
import { BoundingSphere, Ray, Vector3 } from "yuka";

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  return ray.intersectBoundingSphere(new BoundingSphere(new Vector3(...centre), radius), new Vector3())?.toArray([]);
}

run("yuka", { directions: "unit", returns: "point", root: "nearest", tangent: "either", level: "ordinary", intersect });
