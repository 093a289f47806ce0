// openglobus (npm @openglobus/og), Ray.hitSphere: "Returns a ray hit sphere coordinates. If there isn't hit returns null."
// With the argument `ellipsoid`, Ellipsoid.hitRay with equal radii: "Returns cartesian coordinates of the intersection of a
// ray and an ellipsoid." Both have directions of any length; silent about tangents. The package is for browsers; what it needs
// while loading is faked here. Source: lib/math/Ray.d.ts, lib/ellipsoid/Ellipsoid.d.ts.
import { run } from "./raycheck_candidate.mjs";

const anything = new Proxy(class {}, {
  get: (_, name) => (name === Symbol.toPrimitive ? () => "" : anything),
  apply: () => anything,
});
Object.assign(globalThis, { window: globalThis, document: anything, HTMLElement: class {} });
const { Ellipsoid, Ray, Vec3, bv } = await import("@openglobus/og");
const ellipsoid = process.argv[2] === "ellipsoid";

function intersect({ origin, direction }, { centre, radius }) {
  const [o, d] = [new Vec3(...origin), new Vec3(...direction)], sphere = new bv.Sphere(radius, new Vec3(...centre));
  const point = ellipsoid ? new Ellipsoid(radius, radius).hitRay(o, d) : new Ray(o, d).hitSphere(sphere);
  return point && [point.x, point.y, point.z];
}

run("openglobus", {
  returns: "point", root: "nearest", tangent: "either", level: "ordinary", intersect,
  ...(ellipsoid && { placement: "origin" }),
});
