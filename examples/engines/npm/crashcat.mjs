// crashcat (npm crashcat), castRayVsShape of a sphere (by GJK, which it uses for all convex
// shapes): hit.fraction of the ray's length, here 2^10, with a unit direction. "treatConvexAsSolid:
// [...] when false, only surface hits are reported". Back faces are left out, which is the default.
// Silent about tangents, and about the tolerance at which GJK stops. Source: README.md ("Cast
// Ray"), dist/src/collision/cast-ray-vs-shape.d.ts.
import { run } from "./raycheck_candidate.mjs";
import { CastRayStatus, castRayVsShape, createClosestCastRayCollector, registerAll, sphere } from "crashcat";

registerAll();
const reach = 2 ** 10;
const settings = { collideWithBackfaces: false, treatConvexAsSolid: false };

function intersect({ origin, direction }, { centre, radius }) {
  const collector = createClosestCastRayCollector();
  collector.reset();
  const shape = sphere.create({ radius });
  castRayVsShape(collector, settings, ...origin, ...direction, reach, shape, 0, 0, ...centre, 0, 0, 0, 1, 1, 1, 1);
  return collector.hit.status === CastRayStatus.COLLIDING ? collector.hit.fraction * reach : null;
}

run("crashcat", {
  directions: "unit", returns: "distance", root: "nearest", tangent: "either",
  roots: { tMax: reach, unit: "length", culling: "back-faces" }, level: "ordinary", intersect,
});
