// CesiumJS (npm @cesium/engine), IntersectionTests.lineSegmentSphere: "Computes the intersection points of a line segment with
// a sphere": "The interval containing scalar points along the ray or undefined if there are no intersections." The start of
// the interval is judged: 0 from inside, so that the ball is solid. Silent about tangents. Source:
// Source/Core/IntersectionTests.js.
import { run } from "./raycheck_candidate.mjs";

const core = async (name) => (await import(`@cesium/engine/Source/Core/${name}.js`)).default; // a sandbox opens few files
const Cartesian3 = await core("Cartesian3");
const IntersectionTests = await core("IntersectionTests");
const BoundingSphere = await core("BoundingSphere");

function intersect({ origin, direction: end }, { centre, radius }) {
  const sphere = new BoundingSphere(Cartesian3.fromArray(centre), radius);
  return IntersectionTests.lineSegmentSphere(Cartesian3.fromArray(origin), Cartesian3.fromArray(end), sphere)?.start;
}

run("cesium-segment", {
  rays: "end", fromInside: "start", returns: "distance", root: "nearest", tangent: "either", tMax: 1,
  level: "ordinary", intersect,
});
