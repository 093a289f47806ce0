// node case.mjs, beside node_modules with @feng3d/math
import { Sphere, Vector3 } from "@feng3d/math";
const [o, d] = [new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz})];
const distance = new Sphere(new Vector3({cx}, {cy}, {cz}), {r}).rayIntersection(o, d, new Vector3());
console.log(distance <= 0 ? "miss" : distance); // 0 from inside
