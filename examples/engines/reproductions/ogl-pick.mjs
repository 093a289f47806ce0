// node case.mjs, beside node_modules with ogl
import { Camera, Raycast, Vec3 } from "ogl";
const fov = 2 * Math.atan({top} / {near}) * (180 / Math.PI);
const camera = new Camera(null, { near: {near}, far: 1000 * {near}, fov, aspect: {right} / {top} });
camera.position.set({ex}, {ey}, {ez});
camera.up.set({ux}, {uy}, {uz});
camera.lookAt([{ax}, {ay}, {az}]);
camera.updateMatrixWorld();
const caster = new Raycast();
caster.castMouse(camera, [(2 * {i} + 1) / {width} - 1, 1 - (2 * {j} + 1) / {height}]);
console.log(caster.intersectSphere({ center: new Vec3({cx}, {cy}, {cz}), radius: {r} }) || "miss");
