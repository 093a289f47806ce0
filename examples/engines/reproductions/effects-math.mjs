// node case.mjs, beside node_modules with @galacean/effects-math
import { register } from "node:module"; // its modules name each other without ".js"
const completed = (name, from, next) => next(name.startsWith(".") ? `${name}.js` : name, from);
register(`data:text/javascript,${encodeURIComponent(`export const resolve = ${completed}`)}`);
const { Ray } = await import("@galacean/effects-math/es/core/ray");
const { Vector3 } = await import("@galacean/effects-math/es/core/vector3");
const ray = new Ray(new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz}));
const point = ray.intersectSphere({ center: new Vector3({cx}, {cy}, {cz}), radius: {r} }, new Vector3());
console.log(point ? point.toArray().join(" ") : "miss");
