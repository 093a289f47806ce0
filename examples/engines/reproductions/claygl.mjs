// node case.mjs, beside node_modules with claygl
import clay from "claygl";
const { Ray, Vector3 } = clay;
const ray = new Ray(new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz}));
const point = ray.intersectSphere(new Vector3({cx}, {cy}, {cz}), {r});
console.log(point ? point.array.join(" ") : "miss");
