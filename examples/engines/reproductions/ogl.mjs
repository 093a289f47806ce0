// node case.mjs, beside node_modules with ogl
import { Raycast, Vec3 } from "ogl";
const sphere = { center: new Vec3({cx}, {cy}, {cz}), radius: {r} };
const s = new Raycast().intersectSphere(sphere, new Vec3({ox}, {oy}, {oz}), new Vec3({dx}, {dy}, {dz}));
console.log(s === 0 ? "miss" : s);
