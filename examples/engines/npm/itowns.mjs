// iTowns (npm @itowns/geographic), Ellipsoid.intersection with equal radii: "Calculate the intersection between a ray and the
// ellipsoid": the point, or false. It takes a Ray of three.js: "the (normalized) direction of the ray". Silent about
// tangents, and about hits near the origin: by its code, roots up to EPSILON = 1e-4 are behind it. Source: lib/Ellipsoid.js.
import { run } from "./raycheck_candidate.mjs";
import { Ellipsoid } from "@itowns/geographic";
import { Ray, Vector3 } from "three";

function intersect({ origin, direction }, { radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  const point = new Ellipsoid(new Vector3(radius, radius, radius)).intersection(ray);
  return point && point.toArray();
}

run("itowns", {
  directions: "unit", placement: "origin", returns: "point", root: "nearest", tangent: "either",
  roots: { ends: "(]", tMin: 1e-4 }, level: "ordinary", intersect,
});
