// Babylon.js (npm @babylonjs/core), Ray.intersectsSphere: "true if it hits the sphere". It takes a
// BoundingSphere, here made by CreateFromCenterAndRadius. Its documentation does not require unit
// directions, but the code does, and Babylon's own rays have them (Ray.CreateNewFromTo). Silent
// about tangents. Source: Culling/ray.core.d.ts.
import { run } from "./raycheck_candidate.mjs";
import { BoundingSphere } from "@babylonjs/core/Culling/boundingSphere.js";
import { Ray } from "@babylonjs/core/Culling/ray.core.js";
import { Vector3 } from "@babylonjs/core/Maths/math.vector.js";

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  return ray.intersectsSphere(BoundingSphere.CreateFromCenterAndRadius(new Vector3(...centre), radius));
}

run("babylon", {
  directions: "unit", returns: "class", root: "nearest", tangent: "either", level: "ordinary", intersect,
});
