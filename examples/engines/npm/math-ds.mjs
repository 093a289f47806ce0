// math-ds (npm math-ds), Ray.intersectSphere: "The point of intersection, or null if there is none"; for an origin inside,
// the point where the ray leaves (comments in the code). Silent about unit directions, which the code needs, and tangents.
// Source: build/math-ds.esm.js.
import { run } from "./raycheck_candidate.mjs";
import { Ray, Sphere, Vector3 } from "math-ds";

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  return ray.intersectSphere(new Sphere(new Vector3(...centre), radius))?.toArray();
}

run("math-ds", {
  directions: "unit", returns: "point", root: "nearest", tangent: "either", level: "ordinary", intersect,
});
