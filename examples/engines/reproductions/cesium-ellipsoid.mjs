// node case.mjs, beside node_modules with @cesium/engine
import { Cartesian3, Ellipsoid, IntersectionTests, Ray } from "@cesium/engine";
const ray = new Ray(new Cartesian3({ox}, {oy}, {oz}), new Cartesian3({dx}, {dy}, {dz}));
const interval = IntersectionTests.rayEllipsoid(ray, new Ellipsoid({r}, {r}, {r}));
console.log(interval ? interval.start > 0 ? interval.start : interval.stop : "miss"); // from inside it starts at 0
