// node case.mjs, beside node_modules with @dimforge/rapier3d-compat
import RAPIER from "@dimforge/rapier3d-compat";
await RAPIER.init();
const ray = new RAPIER.Ray({ x: {ox}, y: {oy}, z: {oz} }, { x: {dx}, y: {dy}, z: {dz} });
const centre = { x: {cx}, y: {cy}, z: {cz} }, upright = { x: 0, y: 0, z: 0, w: 1 };
const s = new RAPIER.Ball({r}).castRay(ray, centre, upright, Infinity, false);
console.log(s < 0 ? "miss" : s);
