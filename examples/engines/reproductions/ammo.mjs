// node case.mjs, beside node_modules with ammo.js
import ammo from "ammo.js";
const A = typeof ammo === "function" ? await ammo() : ammo, reach = 2 ** 14, still = new A.btVector3(0, 0, 0);
const configuration = new A.btDefaultCollisionConfiguration(), placed = new A.btTransform();
const world = new A.btDiscreteDynamicsWorld(new A.btCollisionDispatcher(configuration), new A.btDbvtBroadphase(),
  new A.btSequentialImpulseConstraintSolver(), configuration);
placed.setIdentity();
placed.setOrigin(new A.btVector3({cx}, {cy}, {cz}));
const motion = new A.btDefaultMotionState(placed), shape = new A.btSphereShape({r});
world.addRigidBody(new A.btRigidBody(new A.btRigidBodyConstructionInfo(0, motion, shape, still)));
const from = new A.btVector3({ox}, {oy}, {oz});
const to = new A.btVector3({ox} + reach * {dx}, {oy} + reach * {dy}, {oz} + reach * {dz});
const result = new A.ClosestRayResultCallback(from, to);
world.rayTest(from, to, result);
const point = result.get_m_hitPointWorld();
console.log(result.hasHit() ? [point.x(), point.y(), point.z()].join(" ") : "miss");
