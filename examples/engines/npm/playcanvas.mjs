// PlayCanvas (npm playcanvas), BoundingSphere.intersectsRay: "Ray to test against (direction must be normalized)"; "If
// there is an intersection, the intersection point will be copied into here". Silent about tangents, and about origins
// inside. Source: core/shape/bounding-sphere.d.ts.
import { run } from "./raycheck_candidate.mjs";
import { BoundingSphere, Ray, Vec3 } from "playcanvas/build/playcanvas.mjs"; // one file: a sandbox opens few

function intersect({ origin, direction }, { centre, radius }) {
  const point = new Vec3();
  const ray = new Ray(new Vec3(origin), new Vec3(direction));
  return new BoundingSphere(new Vec3(centre), radius).intersectsRay(ray, point) && [point.x, point.y, point.z];
}

run("playcanvas", {
  directions: "unit", returns: "point", root: "nearest", tangent: "either", level: "ordinary", intersect,
});
