// node case.mjs, beside node_modules with @takram/three-geospatial and three
import { Ellipsoid } from "@takram/three-geospatial";
import { Ray, Vector3 } from "three";
const ray = new Ray(new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz}));
const point = new Ellipsoid({r}, {r}, {r}).getIntersection(ray);
console.log(point ? point.toArray().join(" ") : "miss");
