// feng3d (npm @feng3d/math), Sphere.rayIntersection: the distance from the ray's origin to the point, -1 for a miss, 0 if the
// origin is inside (by its code). 0 is not a point on the sphere; the adapter returns it as a miss, and declares the first
// root, in front of the origin. Silent about unit directions, which distances need, and tangents. Source:
// lib/geom/Sphere.d.ts, dist/index.js.
import { run } from "./raycheck_candidate.mjs";
import { Sphere, Vector3 } from "@feng3d/math";

function intersect({ origin, direction }, { centre, radius }) {
  const sphere = new Sphere(new Vector3(...centre), radius);
  const distance = sphere.rayIntersection(new Vector3(...origin), new Vector3(...direction), new Vector3());
  return distance <= 0 ? null : distance;
}

run("feng3d", {
  directions: "unit", returns: "distance", root: "smaller", tangent: "either", roots: { ends: "(]" },
  level: "ordinary", intersect,
});
