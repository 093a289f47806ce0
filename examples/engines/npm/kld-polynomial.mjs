// kld-polynomial (npm), Polynomial.getRoots() of the textbook's rounded coefficients: the real roots, a double root once.
// Silent about accuracy; its code drops leading coefficients up to its TOLERANCE, 1e-12; therefore it gets unit directions.
// Source: README.md, lib/Polynomial.js.
import { chosen, coefficients } from "./quadratic.mjs";
import { run } from "./raycheck_candidate.mjs";
import { Polynomial } from "kld-polynomial";

function intersect(ray, sphere) {
  const { a, b, c } = coefficients(ray, sphere);
  return chosen(new Polynomial(a, b, c).getRoots());
}

run("kld-polynomial", {
  directions: "unit", returns: "parameter", root: "nearest", tangent: "either", level: "ordinary", intersect,
});
