// node case.mjs, beside node_modules with claygl
import clay from "claygl";
const fov = 2 * Math.atan({top} / {near}) * (180 / Math.PI);
const camera = new clay.camera.Perspective({ near: {near}, far: 1000 * {near}, fov, aspect: {right} / {top} });
camera.position.set({ex}, {ey}, {ez});
camera.lookAt(new clay.Vector3({ax}, {ay}, {az}), new clay.Vector3({ux}, {uy}, {uz}));
camera.update(true);
const ray = camera.castRay(new clay.Vector2((2 * {i} + 1) / {width} - 1, 1 - (2 * {j} + 1) / {height}));
const point = ray.intersectSphere(new clay.Vector3({cx}, {cy}, {cz}), {r});
console.log(point ? point.array.join(" ") : "miss");
