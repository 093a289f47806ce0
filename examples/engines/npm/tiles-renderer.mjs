// 3d-tiles-renderer (npm 3d-tiles-renderer), Ellipsoid.intersectRay with equal radii: "Returns the point where the given ray
// intersects the ellipsoid surface, or null if no intersection exists." It takes a Ray of three.js: "the (normalized)
// direction of the ray". Silent about tangents. Source: src/three/renderer/math/Ellipsoid.js.
import { run } from "./raycheck_candidate.mjs";
import { Ellipsoid } from "3d-tiles-renderer/three";
import { Ray, Vector3 } from "three";

function intersect({ origin, direction }, { radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  return new Ellipsoid(radius, radius, radius).intersectRay(ray, new Vector3())?.toArray();
}

run("tiles-renderer", {
  directions: "unit", placement: "origin", returns: "point", root: "nearest", tangent: "either", level: "ordinary", intersect,
});
