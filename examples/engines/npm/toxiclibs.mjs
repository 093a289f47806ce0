// toxiclibs.js (npm toxiclibsjs), Sphere.intersectRay: "the distance to the primary intersection point (i.e. the closest in
// the direction of the ray) as its first index"; "If any of distance values is negative, the intersection point lies in the
// opposite ray direction". Silent about unit directions, which the code needs, and tangents. Source: geom/Sphere.js.
import { createRequire } from "node:module";
import { run } from "./raycheck_candidate.mjs";

const { Ray3D, Sphere, Vec3D } = createRequire(import.meta.url)("toxiclibsjs").geom;

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray3D(new Vec3D(...origin), new Vec3D(...direction));
  const distances = new Sphere(new Vec3D(...centre), radius).intersectRay(ray);
  return distances && distances[0] >= 0 ? distances[0] : null;
}

run("toxiclibs", { directions: "unit", returns: "distance", root: "nearest", tangent: "either", level: "ordinary", intersect });
