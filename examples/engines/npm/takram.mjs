// three-geospatial (npm @takram/three-geospatial), Ellipsoid.getIntersection with equal radii: the point, or undefined. It
// takes a Ray of three.js: "the (normalized) direction of the ray". There is no documentation; from inside its code returns
// the "backface of the ellipsoid". Source: src/Ellipsoid.ts.
import { run } from "./raycheck_candidate.mjs";
import { Ellipsoid } from "@takram/three-geospatial";
import { Ray, Vector3 } from "three";

function intersect({ origin, direction }, { radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  return new Ellipsoid(radius, radius, radius).getIntersection(ray)?.toArray();
}

run("takram", {
  directions: "unit", placement: "origin", returns: "point", root: "nearest", tangent: "either", level: "ordinary", intersect,
});
