// node case.mjs, beside node_modules with toxiclibsjs
import { createRequire } from "node:module";
const { Ray3D, Sphere, Vec3D } = createRequire(import.meta.url)("toxiclibsjs").geom;
const ray = new Ray3D(new Vec3D({ox}, {oy}, {oz}), new Vec3D({dx}, {dy}, {dz}));
const distances = new Sphere(new Vec3D({cx}, {cy}, {cz}), {r}).intersectRay(ray);
console.log(distances && distances[0] >= 0 ? distances[0] : "miss");
