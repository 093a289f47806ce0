// PhysX 5 (npm physx-js-webidl: NVIDIA's C++ in WebAssembly, in floats), PxGeometryQuery::raycast with a PxSphereGeometry:
// "Raycast test against a geometry object"; hit.distance of "unitDir: The normalized direction of the ray", up to 2^20. If
// the origin is inside, "the hit's distance is set to zero". 0 is not a point on the sphere; the adapter returns it as a
// miss, and declares the first root, in front of the origin. An end very close to the surface may count as on either side
// of it. Silent about tangents. The package is for browsers: node is hidden from it. Source: PhysX SDK Guide, "Geometry
// Queries" (raycasts against spheres); PxGeometryQuery.h.
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { run } from "./raycheck_candidate.mjs";

const wasmBinary = await readFile(createRequire(import.meta.url).resolve("physx-js-webidl/physx-js-webidl.wasm"));
const { process: node } = globalThis;
Object.assign(globalThis, { window: globalThis, document: {}, process: undefined });
const { default: initPhysX } = await import("physx-js-webidl");
const PX = await initPhysX({ wasmBinary });
globalThis.process = node;
const reach = 2 ** 20;
const flags = new PX.PxHitFlags(PX.PxHitFlagEnum.eDEFAULT), hit = new PX.PxRaycastHit();

function intersectBatch(rays, { centre, radius }) {
  const sphere = new PX.PxSphereGeometry(radius), at = new PX.PxVec3(...centre), upright = new PX.PxQuat(0, 0, 0, 1);
  const placed = new PX.PxTransform(at, upright);
  const hits = rays.map(({ origin, direction }) => {
    const from = new PX.PxVec3(...origin), along = new PX.PxVec3(...direction);
    const count = PX.PxGeometryQuery.prototype.raycast(from, along, sphere, placed, reach, flags, 1, hit);
    for (const used of [from, along]) PX.destroy(used);
    return count === 0 || hit.distance === 0 ? null : hit.distance;
  });
  for (const used of [placed, upright, at, sphere]) PX.destroy(used);
  return hits;
}

run("physx5", {
  precision: "single", directions: "unit", returns: "distance", root: "smaller", tangent: "either",
  roots: { ends: "(]", tMax: reach, unit: "length" }, level: "ordinary", lengths: [2 ** -20, 2 ** 20], intersectBatch,
});
