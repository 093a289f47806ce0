// Babylon.js (npm @babylonjs/core), scene.createPickingRay, "a ray that can be used to pick in the scene" by "the x
// coordinate (on-screen)", then Ray.intersectsSphere (babylon.mjs). The camera is a TargetCamera in a right-handed scene,
// whose rays start on its near plane. Matrices are floats, or, with the argument `double`, doubles (the engine's option
// useHighPrecisionMatrix). Silent about errors. Source: Culling/ray.core.js.
import { run } from "./raycheck_candidate.mjs";
import "@babylonjs/core/Culling/ray.js";
import { TargetCamera } from "@babylonjs/core/Cameras/targetCamera.js";
import { BoundingSphere } from "@babylonjs/core/Culling/boundingSphere.js";
import { NullEngine } from "@babylonjs/core/Engines/nullEngine.js";
import { Matrix, Vector3 } from "@babylonjs/core/Maths/math.vector.js";
import { Scene } from "@babylonjs/core/scene.js";

const double = process.argv.includes("double");
const options = { renderWidth: 1, renderHeight: 1, useHighPrecisionMatrix: double };
const engine = new NullEngine(options);

function pick({ eye, lookAt, up, near, right, top, width, height }, _, [i, j], { centre, radius }) {
  const scene = new Scene(engine);
  scene.useRightHandedSystem = true;
  Object.assign(options, { renderWidth: width, renderHeight: height });
  const camera = new TargetCamera("camera", new Vector3(...eye), scene);
  camera.upVector = new Vector3(...up);
  camera.setTarget(new Vector3(...lookAt));
  Object.assign(camera, { fov: 2 * Math.atan(top / -near), minZ: -near, maxZ: -1000 * near });
  const ray = scene.createPickingRay(i + 0.5, j + 0.5, Matrix.Identity(), camera);
  const found = ray.intersectsSphere(BoundingSphere.CreateFromCenterAndRadius(new Vector3(...centre), radius));
  scene.dispose();
  return found;
}

run(double ? "babylon-pick-double" : "babylon-pick", {
  rows: "top-first", samples: "centres", origin: "pixel", root: "nearest", tangent: "either", windows: "square-pixels",
  returns: "class", level: "ordinary", ...(!double && { precision: "single", lengths: [2 ** -30, 2 ** 30] }), pick,
});
