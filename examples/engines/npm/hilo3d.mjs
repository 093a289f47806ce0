// Hilo3d (npm hilo3d), Ray.intersectsSphere(center, radius): the point, or null. Vectors are stored
// in floats (gl-matrix). Silent about unit directions, which the code needs, tangents and origins
// inside; the code takes only the smaller root. The package is for browsers; the objects that it
// needs while loading are faked here. Source: types/index.d.ts.
import { run } from "./raycheck_candidate.mjs";

const element = { getContext: () => ({}), style: {} };
Object.assign(globalThis, { window: globalThis, navigator: { userAgent: "" }, screen: {}, Image: class {},
  document: { createElement: () => element } });
const { default: Hilo3d } = await import("hilo3d");
const { Ray, Vector3 } = Hilo3d;

function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray({ origin: new Vector3(...origin), direction: new Vector3(...direction) });
  return ray.intersectsSphere(centre, radius)?.elements;
}

run("hilo3d", {
  precision: "single", directions: "unit", returns: "point", root: "smaller", tangent: "either", level: "ordinary",
  lengths: [2 ** -30, 2 ** 30], intersect,
});
