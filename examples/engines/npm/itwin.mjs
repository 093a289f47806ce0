// iTwin.js (npm @itwin/core-geometry), Ellipsoid.intersectRay with equal radii: "Compute intersections with a ray": "Return
// the number of intersections"; "rayFractions = fractions along the ray", whatever their signs: the adapter takes the first in
// front of the origin. "return 0 if ray length is too small": below 1e-10 of the radius; therefore it gets unit directions.
// With the argument `points`, "xyz intersection coordinates points in space", of which the first is judged. Source:
// lib/cjs/geometry3d/Ellipsoid.d.ts.
import { run } from "./raycheck_candidate.mjs";
import { Ellipsoid, Point3d, Ray3d, Vector3d } from "@itwin/core-geometry";

const points = process.argv[2] === "points";

function intersect({ origin, direction }, { centre, radius }) {
  const sphere = Ellipsoid.createCenterMatrixRadii(Point3d.create(...centre), undefined, radius, radius, radius);
  const ray = Ray3d.create(Point3d.create(...origin), Vector3d.create(...direction)), fractions = [], xyz = [];
  const count = sphere.intersectRay(ray, fractions, xyz, undefined);
  return points ? count > 0 && xyz[0].toArray() : fractions.find((fraction) => fraction >= 0);
}

run("itwin", {
  directions: "unit", returns: points ? "point" : "parameter", root: points ? "smaller" : "nearest", tangent: "either",
  level: "ordinary", lengths: [2 ** -33, 2 ** 33], intersect, ...(points && { tMin: -Infinity }),
});
