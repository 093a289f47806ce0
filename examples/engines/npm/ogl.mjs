// OGL (npm ogl), Raycast.intersectSphere: the distance, or 0 for a miss. There is no documentation,
// but its castMouse makes unit directions, and its intersectBounds takes 0 for a miss. Source:
// src/extras/Raycast.js.
import { run } from "./raycheck_candidate.mjs";
import { Raycast } from "ogl/src/extras/Raycast.js"; // not all of ogl: a sandbox opens few files
import { Vec3 } from "ogl/src/math/Vec3.js";

function intersect({ origin, direction }, { centre, radius }) {
  const sphere = { center: new Vec3(...centre), radius };
  const distance = new Raycast().intersectSphere(sphere, new Vec3(...origin), new Vec3(...direction));
  return distance === 0 ? null : distance;
}

// A hit at an origin on the sphere cannot be distinguished from a miss.
run("ogl", {
  directions: "unit", returns: "distance", root: "nearest", tangent: "either", roots: { ends: "(]" },
  level: "ordinary", intersect,
});
