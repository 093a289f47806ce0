// Goblin Physics (npm goblinphysics), World.rayIntersect(start, end): "Checks if a ray segment intersects with objects in the
// world": "an array of intersections, sorted by distance from `start`", each with its distance t. Silent about tangents.
// Source: build/goblin.js.
import { createRequire } from "node:module";
import { run } from "./raycheck_candidate.mjs";

const Goblin = createRequire(import.meta.url)("goblinphysics");

function intersect({ origin, direction: end }, { centre, radius }) {
  const world = new Goblin.World(new Goblin.BasicBroadphase(), new Goblin.NarrowPhase(), new Goblin.IterativeSolver());
  const body = new Goblin.RigidBody(new Goblin.SphereShape(radius), 0);
  body.position.set(...centre);
  world.addRigidBody(body);
  body.updateDerived();
  return world.rayIntersect(new Goblin.Vector3(...origin), new Goblin.Vector3(...end))[0]?.t;
}

run("goblin", { rays: "end", returns: "distance", root: "nearest", tangent: "either", tMax: 1, level: "ordinary", intersect });
