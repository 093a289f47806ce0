// node case.mjs, beside node_modules with @babylonjs/core
import "@babylonjs/core/Culling/ray.js";
import { TargetCamera } from "@babylonjs/core/Cameras/targetCamera.js";
import { BoundingSphere } from "@babylonjs/core/Culling/boundingSphere.js";
import { NullEngine } from "@babylonjs/core/Engines/nullEngine.js";
import { Matrix, Vector3 } from "@babylonjs/core/Maths/math.vector.js";
import { Logger } from "@babylonjs/core/Misc/logger.js";
import { Scene } from "@babylonjs/core/scene.js";
Logger.LogLevels = Logger.ErrorLogLevel; // no greeting
const scene = new Scene(new NullEngine({ renderWidth: {width}, renderHeight: {height}, useHighPrecisionMatrix: true }));
scene.useRightHandedSystem = true;
const camera = new TargetCamera("camera", new Vector3({ex}, {ey}, {ez}), scene);
camera.upVector = new Vector3({ux}, {uy}, {uz});
camera.setTarget(new Vector3({ax}, {ay}, {az}));
Object.assign(camera, { fov: 2 * Math.atan({top} / {near}), minZ: {near}, maxZ: 1000 * {near} });
const ray = scene.createPickingRay({i} + 0.5, {j} + 0.5, Matrix.Identity(), camera);
const ball = BoundingSphere.CreateFromCenterAndRadius(new Vector3({cx}, {cy}, {cz}), {r});
console.log(ray.intersectsSphere(ball) ? "hit" : "miss");
process.exit();
