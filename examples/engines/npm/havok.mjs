// Havok (npm @babylonjs/havok: a closed engine in WebAssembly, in floats),
// HP_World_CastRayWithCollector with a body of HP_Shape_CreateSphere: the fraction of the way
// between the ends of a segment, here a ray's first 2^14 lengths; the far end is rounded. Silent
// about tangents and about origins inside, which have no hit. Source: HavokPhysics.d.ts.
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { run } from "./raycheck_candidate.mjs";
import initHavok from "@babylonjs/havok";

const path = createRequire(import.meta.url).resolve("@babylonjs/havok/lib/esm/HavokPhysics.wasm");
const hk = await initHavok({ wasmBinary: await readFile(path) });
const reach = 2 ** 14;
const world = hk.HP_World_Create()[1];
const collector = hk.HP_QueryCollector_Create(1)[1];

function intersectBatch(rays, { centre, radius }) {
  const shape = hk.HP_Shape_CreateSphere([0, 0, 0], radius)[1];
  const body = hk.HP_Body_Create()[1];
  hk.HP_Body_SetShape(body, shape);
  hk.HP_Body_SetMotionType(body, hk.MotionType.STATIC);
  hk.HP_Body_SetPosition(body, centre);
  hk.HP_World_AddBody(world, body, false);
  const hits = rays.map(({ origin, direction }) => {
    const far = origin.map((x, k) => x + reach * direction[k]);
    hk.HP_World_CastRayWithCollector(world, collector, [origin, far, [~0, ~0], false, [0n]]);
    if (hk.HP_QueryCollector_GetNumHits(collector)[1] === 0) return null;
    return hk.HP_QueryCollector_GetCastRayResult(collector, 0)[1][0] * reach;
  });
  hk.HP_World_RemoveBody(world, body);
  hk.HP_Body_Release(body);
  hk.HP_Shape_Release(shape);
  return hits;
}

run("havok", {
  precision: "single", directions: "unit", returns: "distance", root: "smaller", tangent: "either",
  roots: { tMax: reach, unit: "length" }, level: "ordinary", lengths: [2 ** -20, 2 ** 20], intersectBatch,
});
