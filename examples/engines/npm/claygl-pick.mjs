// ClayGL (npm claygl), camera.castRay, "Cast a picking ray from camera near plane to far plane" by normalized device
// coordinates, of a Perspective camera, then Ray.intersectSphere (claygl.mjs). Silent about errors. Source: src/Camera.js.
import { run } from "./raycheck_candidate.mjs";
import clay from "claygl";

const { Vector2, Vector3, camera: { Perspective } } = clay;

function pick({ eye, lookAt, up, near, right, top, width, height }, _, [i, j], { centre, radius }) {
  const fov = 2 * Math.atan(top / -near) * (180 / Math.PI);
  const camera = new Perspective({ near: -near, far: -1000 * near, fov, aspect: right / top });
  camera.position.set(...eye);
  camera.lookAt(new Vector3(...lookAt), new Vector3(...up));
  camera.update(true);
  const ray = camera.castRay(new Vector2((2 * i + 1) / width - 1, 1 - (2 * j + 1) / height));
  return ray.intersectSphere(new Vector3(...centre), radius)?.array;
}

run("claygl-pick", {
  rows: "top-first", samples: "centres", origin: "pixel", root: "nearest", tangent: "either", windows: "symmetric",
  returns: "point", level: "ordinary", pick,
});
