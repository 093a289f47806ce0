// NAME, a candidate for raycheck: call your function below, and declare its conventions at the end.
import { run } from "./raycheck_candidate.mjs";

function intersect({ origin, direction }, { centre, radius }) {
  // Vectors are [x, y, z]. Return null for a miss, or { s, point } with the point at origin + s direction.
  throw new Error("NAME: calls nothing yet");
}

// root: "smaller" is always v - d. Add what applies to your code: precision: "single" if it
// computes in floats; roots: { ends: "()", tMin: 1e-3, unit: "length" } if it ignores hits nearer
// than 1e-3; directions: "unit" if it requires unit directions; returns: "parameter", "point",
// "distance", "squared-distance", "class" (it declares its root, too) or "roots".
run("NAME", { root: "nearest", tangent: "either", intersect });
