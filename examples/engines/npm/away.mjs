// AwayJS (npm @awayjs/core), Sphere.rayIntersection: the parameter where the ray enters, 0 if the
// origin is inside, -1 for a miss; vectors are stored in floats. This is read from its code, since
// there is no documentation. 0 is not a point on the sphere; the adapter returns it as a miss, and
// declares the first root, in front of the origin. The package is for browsers; the objects that it
// needs while loading are faked here. Source: lib/geom/Sphere.ts, lib/geom/Vector3D.ts.
import { run } from "./raycheck_candidate.mjs";

Object.assign(globalThis, { window: globalThis, self: globalThis, navigator: { userAgent: "" },
  document: { createElement: () => ({ getContext: () => ({}) }) } });
const { default: { Sphere, Vector3D } } = await import("@awayjs/core");

function intersect({ origin, direction }, { centre, radius }) {
  const s = new Sphere(...centre, radius).rayIntersection(new Vector3D(...origin), new Vector3D(...direction), new Vector3D());
  return s <= 0 ? null : s;
}

run("away", {
  precision: "single", returns: "parameter", root: "smaller", tangent: "either", roots: { ends: "(]" },
  level: "ordinary", lengths: [2 ** -30, 2 ** 30], intersect,
});
