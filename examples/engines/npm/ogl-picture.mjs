// OGL (npm ogl), pictures by Raycast.castMouse and Raycast.intersectSphere, which returns 0 for a miss. Source:
// src/core/Camera.js, src/extras/Raycast.js.
import { draw } from "./pictures.mjs";
import { Camera } from "ogl/src/core/Camera.js"; // not all of ogl: a sandbox opens few files
import { Raycast } from "ogl/src/extras/Raycast.js";
import { Vec3 } from "ogl/src/math/Vec3.js";

draw(({ eye, at, up, angle, width, height }) => {
  const camera = new Camera({}, { fov: angle, aspect: width / height });
  camera.position.set(...eye);
  camera.up.set(...up);
  camera.lookAt(new Vec3(...at));
  camera.updateMatrixWorld();
  const raycast = new Raycast();
  return (x, y) => {
    raycast.castMouse(camera, [(2 * x) / width - 1, 1 - (2 * y) / height]);
    return (centre, radius) => raycast.intersectSphere({ center: new Vec3(...centre), radius }) || null;
  };
});
