// node case.mjs, beside node_modules with 3dmol
import { createRequire } from "node:module";
const anything = new Proxy(class {}, { // in place of a browser
  get: (_, name) => (name === Symbol.toPrimitive ? () => "" : anything), apply: () => anything });
Object.assign(globalThis, { window: globalThis, self: globalThis, document: anything, navigator: { userAgent: "" } });
const { Ray, Sphere, Vector3 } = createRequire(import.meta.url)("3dmol");
const ray = new Ray(new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz}));
console.log(ray.isIntersectionSphere(new Sphere(new Vector3({cx}, {cy}, {cz}), {r})) ? "hit" : "miss");
