// node case.mjs, beside node_modules with @babylonjs/havok
import { readFileSync } from "node:fs";
import initHavok from "@babylonjs/havok";
const wasm = new URL(import.meta.resolve("@babylonjs/havok/lib/esm/HavokPhysics.wasm"));
const hk = await initHavok({ wasmBinary: readFileSync(wasm) });
const world = hk.HP_World_Create()[1], body = hk.HP_Body_Create()[1], found = hk.HP_QueryCollector_Create(1)[1];
hk.HP_Body_SetShape(body, hk.HP_Shape_CreateSphere([0, 0, 0], {r})[1]);
hk.HP_Body_SetPosition(body, [{cx}, {cy}, {cz}]);
hk.HP_Body_SetMotionType(body, hk.MotionType.STATIC);
hk.HP_World_AddBody(world, body, false);
const reach = 2 ** 14, far = [{ox} + reach * {dx}, {oy} + reach * {dy}, {oz} + reach * {dz}];
hk.HP_World_CastRayWithCollector(world, found, [[{ox}, {oy}, {oz}], far, [~0, ~0], false, [0n]]);
const hit = hk.HP_QueryCollector_GetNumHits(found)[1] > 0;
console.log(hit ? hk.HP_QueryCollector_GetCastRayResult(found, 0)[1][0] * reach : "miss");
