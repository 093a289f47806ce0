// three.js (npm three), Ray.intersectSphere: "the intersection point or `null`"; for an origin inside, the point where the
// ray leaves (comments in the code). Ray: "the (normalized) direction of the ray". Silent about tangents. Source:
// src/math/Ray.js.
import { run } from "./raycheck_candidate.mjs";
import { Ray, Sphere, Vector3 } from "three";

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  return ray.intersectSphere(new Sphere(new Vector3(...centre), radius), new Vector3())?.toArray();
}

run("three", {
  directions: "unit", returns: "point", root: "nearest", tangent: "either", level: "ordinary", intersect,
});
