// cannon-es (npm cannon-es), World.raycastClosest(from, to, options, result): "Ray cast, and return
// information of the closest hit"; result.hitPointWorld. It takes the two ends of a segment, here a
// ray's first 2^20 lengths; the far end is rounded. Silent about tangents. Source:
// dist/cannon-es.d.ts.
import { run } from "./raycheck_candidate.mjs";
import { Body, RaycastResult, Sphere, Vec3, World } from "cannon-es";

const reach = 2 ** 20;

function intersect({ origin, direction }, { centre, radius }) {
  const world = new World();
  world.addBody(new Body({ mass: 0, shape: new Sphere(radius), position: new Vec3(...centre) }));
  const far = new Vec3(...origin.map((x, k) => x + reach * direction[k]));
  const result = new RaycastResult();
  return world.raycastClosest(new Vec3(...origin), far, {}, result) && result.hitPointWorld.toArray();
}

run("cannon-es", {
  directions: "unit", returns: "point", root: "nearest", tangent: "either", roots: { tMax: reach, unit: "length" },
  level: "ordinary", intersect,
});
