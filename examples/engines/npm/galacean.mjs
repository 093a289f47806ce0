// Galacean (npm @galacean/engine-math), Ray.intersectSphere: "The distance from this ray to the specified sphere if
// intersecting, -1 otherwise": 0 where the origin is inside, since it is the ball that is met. That is no point on the sphere:
// it is passed as no hit, and only the first root, in front of the origin, is asked for. Ray: "the normalized direction".
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
