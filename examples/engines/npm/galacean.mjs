// Galacean (npm @galacean/engine-math), Ray.intersectSphere: "The distance from this ray to the
// specified sphere if intersecting, -1 otherwise". If the origin is inside, the distance is 0,
// since the solid ball is intersected. 0 is not a point on the sphere; the adapter returns it as a
// miss, and declares the first root, in front of the origin. Ray: "the normalized direction".
// Silent about tangents. Source: types/CollisionUtil.d.ts, types/Ray.d.ts.
import { run } from "./raycheck_candidate.mjs";
import { BoundingSphere, Ray, Vector3 } from "@galacean/engine-math";

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  const distance = ray.intersectSphere(new BoundingSphere(new Vector3(...centre), radius));
  return distance <= 0 ? null : distance;
}

run("galacean", {
  directions: "unit", returns: "distance", root: "smaller", tangent: "either", roots: { ends: "(]" },
  level: "ordinary", intersect,
});
