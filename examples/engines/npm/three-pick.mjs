// three.js (npm three), Raycaster.setFromCamera with a PerspectiveCamera, "2D coordinates of the mouse, in normalized device
// coordinates", then Ray.intersectSphere (three.mjs). The camera has a vertical field of view in degrees. Silent about
// errors; the far plane, 1000 near, does not limit rays. Source: src/core/Raycaster.js.
import { run } from "./raycheck_candidate.mjs";
import { PerspectiveCamera, Raycaster, Sphere, Vector2, Vector3 } from "three";

function pick({ eye, lookAt, up, near, right, top, width, height }, _, [i, j], { centre, radius }) {
  const fov = 2 * Math.atan(top / -near) * (180 / Math.PI);
  const camera = new PerspectiveCamera(fov, right / top, -near, -1000 * near);
  camera.position.set(...eye);
  camera.up.set(...up);
  camera.lookAt(...lookAt);
  camera.updateMatrixWorld();
  const caster = new Raycaster();
  caster.setFromCamera(new Vector2((2 * i + 1) / width - 1, 1 - (2 * j + 1) / height), camera);
  return caster.ray.intersectSphere(new Sphere(new Vector3(...centre), radius), new Vector3())?.toArray();
}

run("three-pick", {
  rows: "top-first", samples: "centres", origin: "focal", root: "nearest", tangent: "either", windows: "symmetric",
  returns: "point", level: "ordinary", pick,
});
