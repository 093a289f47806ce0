// ClayGL (npm claygl), Ray.intersectSphere: "Calculate intersection point between ray and sphere".
// Vectors have doubles (GLMAT_ARRAY_TYPE of its gl-matrix is Array). Silent about unit
// directions, which the code needs, tangents and origins inside, for which the code returns the
// point where the ray leaves. Source: src/math/Ray.js, src/glmatrix/common.js.
import { run } from "./raycheck_candidate.mjs";
import clay from "claygl";

const { Ray, Vector3 } = clay;

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
  return ray.intersectSphere(new Vector3(...centre), radius)?.array;
}

run("claygl", { directions: "unit", returns: "point", root: "nearest", tangent: "either", level: "ordinary", intersect });
