// minimatrix-polyroots (npm), getQuadraticRoots(a, b, c) of the textbook's rounded coefficients: "an implementation of a
// numerically stable method illustrated in Kahan's notes": complex roots, in an array that is not sorted; those with an
// imaginary part are misses. (It depends on all of TypeScript, which it does not use; package.json leaves this out.) Source:
// README.md.
import { chosen, coefficients } from "./quadratic.mjs";
import { run } from "./raycheck_candidate.mjs";
import { getQuadraticRoots } from "minimatrix-polyroots";

function intersect(ray, sphere) {
  const { a, b, c } = coefficients(ray, sphere);
  return chosen(getQuadraticRoots(a, b, c).filter(({ imag }) => imag === 0).map(({ real }) => real));
}

run("polyroots", { returns: "parameter", root: "nearest", tangent: "either", level: "ordinary", intersect });
