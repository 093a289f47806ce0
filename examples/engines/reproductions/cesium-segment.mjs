// node case.mjs, beside node_modules with @cesium/engine
import { BoundingSphere, Cartesian3, IntersectionTests } from "@cesium/engine";
const from = new Cartesian3({ox}, {oy}, {oz}), to = new Cartesian3({ox} + {dx}, {oy} + {dy}, {oz} + {dz});
const interval = IntersectionTests.lineSegmentSphere(from, to, new BoundingSphere(new Cartesian3({cx}, {cy}, {cz}), {r}));
console.log(interval ? interval.start : "miss");
