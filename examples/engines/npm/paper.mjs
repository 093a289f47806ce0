// Paper.js (npm paper), Numerical.solveQuadratic(a, b, c, roots) of the textbook's rounded coefficients: the number of real
// roots, which it stores. There is no documentation of this class. Coefficients below its EPSILON, 1e-12, count as 0; therefore
// it gets unit directions. Source: dist/paper-core.js.
import { chosen, coefficients } from "./quadratic.mjs";
import { run } from "./raycheck_candidate.mjs";
import paper from "paper/dist/paper-core.js";

function intersect(ray, sphere) {
  const { a, b, c } = coefficients(ray, sphere), roots = [];
  paper.Numerical.solveQuadratic(a, b, c, roots);
  return chosen(roots);
}

run("paper", { directions: "unit", returns: "parameter", root: "nearest", tangent: "either", level: "ordinary", intersect });
