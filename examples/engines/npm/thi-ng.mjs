// thi.ng/geom-isec (npm @thi.ng/geom-isec), intersectRayCircle, which handles rays and spheres, too (README: 3D tests, Ray,
// Sphere): alpha is the parameter of the first point. Silent about unit directions, which the code needs, and tangents.
// Source: README.md, ray-circle.d.ts.
import { run } from "./raycheck_candidate.mjs";
import { IntersectionType, intersectRayCircle } from "@thi.ng/geom-isec";

function intersect({ origin, direction }, { centre, radius }) {
  const { type, alpha, isec } = intersectRayCircle(origin, direction, centre, radius);
  return type === IntersectionType.INTERSECT ? { s: alpha, point: isec[0] } : null;
}

run("thi-ng", { directions: "unit", root: "nearest", tangent: "either", level: "ordinary", intersect });
