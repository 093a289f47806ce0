// PhysX 4 (npm @cocos/physx: NVIDIA's C++ by Emscripten, in floats), PxScene::raycast with a
// PxSphereGeometry: hit.distance of "unitDir: Normalized direction of the ray", up to 2^20. If the
// origin is inside, "the reported hit distance is set to zero". 0 is not a point on the sphere; the
// adapter returns it as a miss, and declares the first root, in front of the origin. An end very
// close to the surface may count as on either side of it. Silent about tangents. Source: PhysX SDK
// Guide, "Geometry Queries" (raycasts against spheres); PxScene.h.
import { run } from "./raycheck_candidate.mjs";
import initPhysX from "@cocos/physx";

const PX = await new Promise((resolve) => {
  initPhysX().then((module) => {
    delete module.then; // with it, await would never return
    resolve({ module });
  });
}).then(({ module }) => module);
const foundation = PX.PxCreateFoundation(PX.PX_PHYSICS_VERSION, new PX.PxDefaultAllocator(), new PX.PxDefaultErrorCallback());
const scale = new PX.PxTolerancesScale();
const physics = PX.PxCreatePhysics(PX.PX_PHYSICS_VERSION, foundation, scale, false, null);
const scene = physics.createScene(PX.getDefaultSceneDesc(scale, 0, PX.PxSimulationEventCallback.implement({})));
const material = physics.createMaterial(0.5, 0.5, 0.5);
const queried = new PX.PxShapeFlags(PX.PxShapeFlag.eSCENE_QUERY_SHAPE.value);
const all = new PX.PxQueryFilterData();
const blocks = () => PX.PxQueryHitType.eBLOCK;
const anything = PX.PxQueryFilterCallback.implement({ preFilter: blocks, postFilter: blocks });
const hitFlags = PX.PxHitFlag.eDEFAULT.value;
const reach = 2 ** 20;
const vector = ([x, y, z]) => ({ x, y, z });

function intersectBatch(rays, { centre, radius }) {
  const shape = physics.createShape(new PX.PxSphereGeometry(radius), material, true, queried);
  const actor = physics.createRigidStatic({ translation: vector(centre), rotation: { x: 0, y: 0, z: 0, w: 1 } });
  actor.attachShape(shape);
  scene.addActor(actor, null);
  const hit = new PX.PxRaycastHit();
  const hits = rays.map(({ origin, direction }) => {
    const found = scene.raycastSingle(vector(origin), vector(direction), reach, hitFlags, hit, all, anything, null);
    return !found || hit.distance === 0 ? null : hit.distance;
  });
  scene.removeActor(actor, false);
  hit.delete();
  shape.release();
  actor.release();
  return hits;
}

run("physx", {
  precision: "single", directions: "unit", returns: "distance", root: "smaller", tangent: "either",
  roots: { ends: "(]", tMax: reach, unit: "length" }, level: "ordinary", lengths: [2 ** -20, 2 ** 20], intersectBatch,
});
