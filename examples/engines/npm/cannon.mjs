// cannon.js (npm cannon), World.raycastClosest(from, to, options, result): "Ray cast, and return information of the closest
// hit"; result.hitPointWorld. It takes the two ends of a segment. Silent about tangents. Source: src/world/World.js.
import { run } from "./raycheck_candidate.mjs";
import CANNON from "cannon";

const { Body, RaycastResult, Sphere, Vec3, World } = CANNON;

function intersect({ origin, direction: end }, { centre, radius }) {
  const world = new World(), result = new RaycastResult();
  world.addBody(new Body({ mass: 0, shape: new Sphere(radius), position: new Vec3(...centre) }));
  return world.raycastClosest(new Vec3(...origin), new Vec3(...end), {}, result) && result.hitPointWorld.toArray();
}

run("cannon", { rays: "end", returns: "point", root: "nearest", tangent: "either", tMax: 1, level: "ordinary", intersect });
