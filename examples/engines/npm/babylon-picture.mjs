// Babylon.js (npm @babylonjs/core), pictures by Ray.CreateNew, which "creates a new ray from screen coordinates", and
// Ray.intersectsSphere: hit or miss. Matrices have floats. Source:
// Culling/ray.core.d.ts, Maths/math.vector.d.ts.
import { draw } from "./pictures.mjs";
import { BoundingSphere } from "@babylonjs/core/Culling/boundingSphere.js";
import { Ray } from "@babylonjs/core/Culling/ray.core.js";
import { Matrix, Vector3 } from "@babylonjs/core/Maths/math.vector.js";

draw(({ eye, at, up, angle, width, height }) => {
  const view = Matrix.LookAtRH(new Vector3(...eye), new Vector3(...at), new Vector3(...up));
  const projection = Matrix.PerspectiveFovRH((angle * Math.PI) / 180, width / height, 0.1, 2000);
  return (x, y) => {
    const ray = Ray.CreateNew(x, y, width, height, Matrix.Identity(), view, projection);
    return (centre, radius) =>
      ray.intersectsSphere(BoundingSphere.CreateFromCenterAndRadius(new Vector3(...centre), radius)) || undefined;
  };
});
