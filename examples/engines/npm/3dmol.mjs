// 3Dmol.js (npm 3dmol), Ray.isIntersectionSphere, by which it picks atoms: true or false. There is no documentation; its code
// takes the distance of the sphere's centre from the whole line, with a unit direction. The package is for browsers; what it
// needs while loading is faked here. Source: src/WebGL/math/math.ts.
import { createRequire } from "node:module";
import { run } from "./raycheck_candidate.mjs";

const anything = new Proxy(class {}, {
  get: (_, name) => (name === Symbol.toPrimitive ? () => "" : anything),
  apply: () => anything,
});
Object.assign(globalThis, { window: globalThis, self: globalThis, document: anything, navigator: { userAgent: "" } });
const { Ray, Sphere, Vector3 } = createRequire(import.meta.url)("3dmol");

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  return ray.isIntersectionSphere(new Sphere(new Vector3(...centre), radius));
}

run("3dmol", {
  directions: "unit", returns: "class", root: "smaller", tangent: "either", roots: { tMin: -Infinity },
  level: "ordinary", intersect,
});
