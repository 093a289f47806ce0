// node case.mjs, beside node_modules with yuka
import { BoundingSphere, Ray, Vector3 } from "yuka";
const ray = new Ray(new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz}));
const sphere = new BoundingSphere(new Vector3({cx}, {cy}, {cz}), {r});
const point = ray.intersectBoundingSphere(sphere, new Vector3());
console.log(point ? point.toArray([]).join(" ") : "miss");
