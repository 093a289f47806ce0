// node case.mjs, beside node_modules with cannon-es
import { Body, RaycastResult, Sphere, Vec3, World } from "cannon-es";
const world = new World(), result = new RaycastResult(), reach = 2 ** 20;
world.addBody(new Body({ mass: 0, shape: new Sphere({r}), position: new Vec3({cx}, {cy}, {cz}) }));
const far = new Vec3({ox} + reach * {dx}, {oy} + reach * {dy}, {oz} + reach * {dz});
const hit = world.raycastClosest(new Vec3({ox}, {oy}, {oz}), far, {}, result);
console.log(hit ? result.hitPointWorld.toArray().join(" ") : "miss");
