// node case.mjs, beside node_modules with math-ds
import { Ray, Sphere, Vector3 } from "math-ds";
const ray = new Ray(new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz}));
const point = ray.intersectSphere(new Sphere(new Vector3({cx}, {cy}, {cz}), {r}));
console.log(point ? point.toArray().join(" ") : "miss");
