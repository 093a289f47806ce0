// node case.mjs, beside node_modules with @galacean/engine-math
import { BoundingSphere, Ray, Vector3 } from "@galacean/engine-math";
const ray = new Ray(new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz}));
const distance = ray.intersectSphere(new BoundingSphere(new Vector3({cx}, {cy}, {cz}), {r}));
console.log(distance <= 0 ? "miss" : distance); // 0 from inside
