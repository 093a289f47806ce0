// node case.mjs, beside node_modules with playcanvas
import { BoundingSphere, Ray, Vec3 } from "playcanvas";
const ray = new Ray(new Vec3({ox}, {oy}, {oz}), new Vec3({dx}, {dy}, {dz}));
const point = new Vec3();
const hit = new BoundingSphere(new Vec3({cx}, {cy}, {cz}), {r}).intersectsRay(ray, point);
console.log(hit ? point.toArray().join(" ") : "miss");
