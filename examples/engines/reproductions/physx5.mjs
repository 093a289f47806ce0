// node case.mjs, beside node_modules with physx-js-webidl
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
const wasmBinary = readFileSync(createRequire(import.meta.url).resolve("physx-js-webidl/physx-js-webidl.wasm"));
const { process: node } = globalThis;
Object.assign(globalThis, { window: globalThis, document: {}, process: undefined }); // it runs only in browsers
const PX = await (await import("physx-js-webidl")).default({ wasmBinary });
globalThis.process = node;
const placed = new PX.PxTransform(new PX.PxVec3({cx}, {cy}, {cz}), new PX.PxQuat(0, 0, 0, 1)), hit = new PX.PxRaycastHit();
const count = PX.PxGeometryQuery.prototype.raycast(new PX.PxVec3({ox}, {oy}, {oz}), new PX.PxVec3({dx}, {dy}, {dz}),
  new PX.PxSphereGeometry({r}), placed, 2 ** 20, new PX.PxHitFlags(PX.PxHitFlagEnum.eDEFAULT), 1, hit);
console.log(count && hit.distance > 0 ? hit.distance : "miss"); // 0 from inside
