// node case.mjs, beside node_modules with @babylonjs/core
import { BoundingSphere } from "@babylonjs/core/Culling/boundingSphere.js";
import { Ray } from "@babylonjs/core/Culling/ray.core.js";
import { Vector3 } from "@babylonjs/core/Maths/math.vector.js";
const ray = new Ray(new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz}));
const sphere = BoundingSphere.CreateFromCenterAndRadius(new Vector3({cx}, {cy}, {cz}), {r});
console.log(ray.intersectsSphere(sphere) ? "hit" : "miss");
