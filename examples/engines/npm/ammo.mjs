// Bullet as ammo.js (npm ammo.js: C++ by Emscripten, in floats), btCollisionWorld.rayTest with a
// ClosestRayResultCallback and a btSphereShape: m_hitPointWorld. It takes the two ends of a
// segment, here a ray's first 2^14 lengths; the far end is rounded. Bullet casts such rays by GJK.
// Silent about tangents and about origins inside, which have no hit.
// Source: Bullet's manual, "Performing queries"; btCollisionWorld.h.
import { run } from "./raycheck_candidate.mjs";
import ammo from "ammo.js";

const Ammo = typeof ammo === "function" ? await ammo() : ammo;
const reach = 2 ** 14;
const configuration = new Ammo.btDefaultCollisionConfiguration();
const world = new Ammo.btDiscreteDynamicsWorld(new Ammo.btCollisionDispatcher(configuration), new Ammo.btDbvtBroadphase(),
  new Ammo.btSequentialImpulseConstraintSolver(), configuration);

function intersectBatch(rays, { centre, radius }) {
  const shape = new Ammo.btSphereShape(radius);
  const placed = new Ammo.btTransform();
  placed.setIdentity();
  placed.setOrigin(new Ammo.btVector3(...centre));
  const state = new Ammo.btDefaultMotionState(placed);
  const body = new Ammo.btRigidBody(new Ammo.btRigidBodyConstructionInfo(0, state, shape, new Ammo.btVector3(0, 0, 0)));
  world.addRigidBody(body);
  const hits = rays.map(({ origin, direction }) => {
    const from = new Ammo.btVector3(...origin);
    const to = new Ammo.btVector3(...origin.map((x, k) => x + reach * direction[k]));
    const result = new Ammo.ClosestRayResultCallback(from, to);
    world.rayTest(from, to, result);
    const at = result.get_m_hitPointWorld();
    const point = result.hasHit() ? [at.x(), at.y(), at.z()] : null;
    for (const used of [result, to, from]) Ammo.destroy(used);
    return point;
  });
  world.removeRigidBody(body);
  for (const used of [body, state, placed, shape]) Ammo.destroy(used);
  return hits;
}

run("ammo", {
  precision: "single", directions: "unit", returns: "point", root: "smaller", tangent: "either",
  roots: { tMax: reach, unit: "length" }, level: "ordinary", lengths: [2 ** -10, 2 ** 10], intersectBatch,
});
