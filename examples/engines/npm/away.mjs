// AwayJS (npm @awayjs/core), Sphere.rayIntersection: the parameter where the ray enters, 0 where the origin is inside, -1
// for a miss; vectors are stored in floats. There is no documentation: this is its code. 0 is not a point on the sphere: it
// is returned as a miss, and the declared root is the first one, in front of the origin. The package is for browsers: the
// objects that it needs while loading are faked here. Source: lib/geom/Sphere.ts, lib/geom/Vector3D.ts.
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
