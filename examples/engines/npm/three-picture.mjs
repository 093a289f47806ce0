// three.js (npm three), pictures by Raycaster.setFromCamera and Ray.intersectSphere. Its SphereGeometry is a mesh, which
// is not judged. Source: src/core/Raycaster.js, src/cameras/PerspectiveCamera.js, src/math/Ray.js.
import { draw } from "./pictures.mjs";
import { PerspectiveCamera, Raycaster, Sphere, Vector2, Vector3 } from "three";

draw(({ eye, at, up, angle, width, height }) => {
  const camera = new PerspectiveCamera(angle, width / height);
  camera.position.set(...eye);
  camera.up.set(...up);
  camera.lookAt(...at);
  camera.updateMatrixWorld();
  const raycaster = new Raycaster();
  return (x, y) => {
    raycaster.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), camera);
    return (centre, radius) => raycaster.ray.intersectSphere(new Sphere(new Vector3(...centre), radius), new Vector3())
      ?.distanceTo(raycaster.ray.origin);
  };
});
