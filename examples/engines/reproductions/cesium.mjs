// node case.mjs, beside node_modules with @cesium/engine
import { BoundingSphere, Cartesian3, IntersectionTests, Ray } from "@cesium/engine";
const ray = new Ray(new Cartesian3({ox}, {oy}, {oz}), new Cartesian3({dx}, {dy}, {dz}));
const sphere = new BoundingSphere(new Cartesian3({cx}, {cy}, {cz}), {r});
const interval = IntersectionTests.raySphere(ray, sphere);
console.log(interval ? interval.start > 0 ? interval.start : interval.stop : "miss"); // from inside it starts at 0
