// node case.mjs, beside node_modules with three
import { Ray, Sphere, Vector3 } from "three";
const ray = new Ray(new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz}));
const sphere = new Sphere(new Vector3({cx}, {cy}, {cz}), {r});
console.log(ray.intersectsSphere(sphere) ? "hit" : "miss");
