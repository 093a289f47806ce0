// Galacean Effects (npm @galacean/effects-math), Ray.intersectSphere: the point, or undefined; for an origin inside, the point
// where the ray leaves (comments in the code). Silent about unit directions, which the code needs, and tangents. Its modules
// name each other without ".js", which bundlers add. Source: es/core/ray.js.
import { register } from "node:module";
import { run } from "./raycheck_candidate.mjs";

const completed = (name, from, next) => next(name.startsWith(".") ? `${name}.js` : name, from);
register(`data:text/javascript,${encodeURIComponent(`export const resolve = ${completed}`)}`);
const { Ray } = await import("@galacean/effects-math/es/core/ray");
const { Vector3 } = await import("@galacean/effects-math/es/core/vector3");

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  return ray.intersectSphere({ center: new Vector3(...centre), radius }, new Vector3())?.toArray();
}

run("effects-math", {
  directions: "unit", returns: "point", root: "nearest", tangent: "either", level: "ordinary", intersect,
});
