// node case.mjs, beside node_modules with three
import { PerspectiveCamera, Raycaster, Sphere, Vector2, Vector3 } from "three";
const camera = new PerspectiveCamera(2 * Math.atan({top} / {near}) * (180 / Math.PI), {right} / {top}, {near}, 1000 * {near});
camera.position.set({ex}, {ey}, {ez});
camera.up.set({ux}, {uy}, {uz});
camera.lookAt({ax}, {ay}, {az});
camera.updateMatrixWorld();
const caster = new Raycaster();
caster.setFromCamera(new Vector2((2 * {i} + 1) / {width} - 1, 1 - (2 * {j} + 1) / {height}), camera);
const point = caster.ray.intersectSphere(new Sphere(new Vector3({cx}, {cy}, {cz}), {r}), new Vector3());
console.log(point ? point.toArray().join(" ") : "miss");
