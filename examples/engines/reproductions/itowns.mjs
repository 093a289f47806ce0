// node case.mjs, beside node_modules with @itowns/geographic and three
import { Ellipsoid } from "@itowns/geographic";
import { Ray, Vector3 } from "three";
const ray = new Ray(new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz}));
const point = new Ellipsoid(new Vector3({r}, {r}, {r})).intersection(ray);
console.log(point ? point.toArray().join(" ") : "miss");
