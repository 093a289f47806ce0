// node case.mjs, beside node_modules with 3d-tiles-renderer and three
import { Ellipsoid } from "3d-tiles-renderer/three";
import { Ray, Vector3 } from "three";
const ray = new Ray(new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz}));
const point = new Ellipsoid({r}, {r}, {r}).intersectRay(ray, new Vector3());
console.log(point ? point.toArray().join(" ") : "miss");
