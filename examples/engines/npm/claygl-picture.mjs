// ClayGL (npm claygl), pictures by Camera.castRay, whose rays start in the near plane, and Ray.intersectSphere. Source:
// src/Camera.js, src/math/Ray.js.
import { draw } from "./pictures.mjs";
import clay from "claygl";

const { Vector2, Vector3, camera: { Perspective } } = clay;

draw(({ eye, at, up, angle, width, height }) => {
  const camera = new Perspective({ fov: angle, aspect: width / height, near: 0.001 });
  camera.position.set(...eye);
  camera.lookAt(new Vector3(...at), new Vector3(...up));
  camera.update();
  return (x, y) => {
    const ray = camera.castRay(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height));
    return (centre, radius) => ray.intersectSphere(new Vector3(...centre), radius)?.dist(ray.origin);
  };
});
