// OGL (npm ogl), Raycast.castMouse with a perspective Camera, then Raycast.intersectSphere: a distance, or 0 for a miss,
// so that an eye on the sphere counts as a miss.
// Matrices are arrays of doubles. Undocumented, so that this is the code's contract; silent about tangents, and about
// errors. Source: src/extras/Raycast.js, src/core/Camera.js.
import { run } from "./raycheck_candidate.mjs";
import { Camera, Raycast, Vec3 } from "ogl";

function pick({ eye, lookAt, up, near, right, top, width, height }, _, [i, j], { centre, radius }) {
  const fov = 2 * Math.atan(top / -near) * (180 / Math.PI);
  const camera = new Camera(null, { near: -near, far: -1000 * near, fov, aspect: right / top });
  camera.position.set(...eye);
  camera.up.set(...up);
  camera.lookAt(lookAt);
  camera.updateMatrixWorld();
  const caster = new Raycast();
  caster.castMouse(camera, [(2 * i + 1) / width - 1, 1 - (2 * j + 1) / height]);
  return caster.intersectSphere({ center: new Vec3(...centre), radius }) || null;
}

run("ogl-pick", {
  rows: "top-first", samples: "centres", origin: "focal", root: "nearest", tangent: "either", windows: "symmetric",
  returns: "distance", roots: { ends: "(]" }, level: "ordinary", pick,
});
