// OimoPhysics (npm oimophysics), SphereGeometry.rayCast(begin, end, transform, hit): "Performs ray casting. Returns `true` and
// sets the result information to `hit` if the line segment from `begin` to `end` and the geometry transformed by `transform`
// intersect." hit.fraction: "The ratio of the position the ray hit from the start point to the end point." Silent about
// tangents and about segments that begin inside, for which the code has no hit. Source: OimoPhysics.d.ts.
import { run } from "./raycheck_candidate.mjs";
import { oimo } from "oimophysics";

const { RayCastHit, SphereGeometry } = oimo.collision.geometry;
const { Transform, Vec3 } = oimo.common;

function intersect({ origin, direction: end }, { centre, radius }) {
  const placed = new Transform().setPosition(new Vec3(...centre)), hit = new RayCastHit();
  return new SphereGeometry(radius).rayCast(new Vec3(...origin), new Vec3(...end), placed, hit) ? hit.fraction : null;
}

run("oimo-physics", {
  rays: "end", returns: "parameter", root: "smaller", tangent: "either", tMax: 1, level: "ordinary", intersect,
});
