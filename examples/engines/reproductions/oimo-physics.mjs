// node case.mjs, beside node_modules with oimophysics
import { oimo } from "oimophysics";
const { Transform, Vec3 } = oimo.common, hit = new oimo.collision.geometry.RayCastHit();
const placed = new Transform().setPosition(new Vec3({cx}, {cy}, {cz})), to = new Vec3({ox} + {dx}, {oy} + {dy}, {oz} + {dz});
const found = new oimo.collision.geometry.SphereGeometry({r}).rayCast(new Vec3({ox}, {oy}, {oz}), to, placed, hit);
console.log(found ? hit.fraction : "miss");
