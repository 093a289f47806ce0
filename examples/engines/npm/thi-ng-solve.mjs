// thi.ng/math (npm @thi.ng/math), solveQuadratic(a, b, c, eps) of the textbook's rounded coefficients: "Returns array of real
// solutions"; "eps - tolerance to determine multiple roots", by default 1e-9 on the discriminant, where it returns -b / 2a.
// Source: solve.d.ts, solve.js.
import { chosen, coefficients } from "./quadratic.mjs";
import { run } from "./raycheck_candidate.mjs";
import { solveQuadratic } from "@thi.ng/math";

function intersect(ray, sphere) {
  const { a, b, c } = coefficients(ray, sphere);
  return chosen(solveQuadratic(a, b, c));
}

run("thi-ng-solve", {
  returns: "parameter", root: "nearest", tangent: "either", toleranceDiscriminant: 1e-9, level: "ordinary", intersect,
});
