// node case.mjs, beside node_modules with goblinphysics
import { createRequire } from "node:module";
const Goblin = createRequire(import.meta.url)("goblinphysics");
const world = new Goblin.World(new Goblin.BasicBroadphase(), new Goblin.NarrowPhase(), new Goblin.IterativeSolver());
const body = new Goblin.RigidBody(new Goblin.SphereShape({r}), 0);
body.position.set({cx}, {cy}, {cz});
world.addRigidBody(body);
body.updateDerived();
const [hit] = world.rayIntersect(new Goblin.Vector3({ox}, {oy}, {oz}), new Goblin.Vector3({ox} + {dx}, {oy} + {dy}, {oz} + {dz}));
console.log(hit ? hit.t : "miss");
