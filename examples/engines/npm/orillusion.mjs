// Orillusion (npm @orillusion/core), Ray.intersectSphere(o, dir, center, radius): "Determine
// whether a ray intersects the sphere", "point of intersection" or null. Directions of any length,
// since it divides by their square. Silent about tangents and about origins inside; the code takes
// only the smaller root. The package is for browsers with WebGPU; the objects that it needs while
// loading are faked here. Source: dist/types/math/Ray.d.ts.
import { run } from "./raycheck_candidate.mjs";

Object.assign(globalThis, { window: globalThis, navigator: { userAgent: "" },
  document: { createElement: () => ({ getContext: () => ({}), style: {} }) } });
const { Ray, Vector3 } = await import("@orillusion/core");

function intersect({ origin, direction }, { centre, radius }) {
  const point = new Ray().intersectSphere(new Vector3(...origin), new Vector3(...direction), new Vector3(...centre), radius);
  return point && [point.x, point.y, point.z];
}

run("orillusion", { returns: "point", root: "smaller", tangent: "either", level: "ordinary", intersect });
