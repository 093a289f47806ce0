// node case.mjs, beside node_modules with cannon
import CANNON from "cannon";
const { Body, RaycastResult, Sphere, Vec3, World } = CANNON;
const world = new World(), result = new RaycastResult();
world.addBody(new Body({ mass: 0, shape: new Sphere({r}), position: new Vec3({cx}, {cy}, {cz}) }));
const hit = world.raycastClosest(new Vec3({ox}, {oy}, {oz}), new Vec3({ox} + {dx}, {oy} + {dy}, {oz} + {dz}), {}, result);
console.log(hit ? result.hitPointWorld.toArray().join(" ") : "miss");
