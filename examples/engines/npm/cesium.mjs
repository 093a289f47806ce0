// CesiumJS (npm @cesium/engine), IntersectionTests.raySphere: "The interval containing scalar
// points along the ray or undefined if there are no intersections". If the origin is inside, the
// interval starts at 0, and its stop is the point on the sphere. Ray normalises its direction, so
// that these are distances. Silent about tangents. With the argument `far` only the stop is judged.
// Source: Source/Core/IntersectionTests.js, Source/Core/Ray.js.
import { run } from "./raycheck_candidate.mjs";

// Loads single modules, one after the other, since Cesium has more modules than a sandbox can open
// at once.
const core = async (name) => (await import(`@cesium/engine/Source/Core/${name}.js`)).default;
const Cartesian3 = await core("Cartesian3");
const Ray = await core("Ray");
const IntersectionTests = await core("IntersectionTests");
const BoundingSphere = await core("BoundingSphere");

const far = process.argv[2] === "far";
function intersect({ origin, direction }, { centre, radius }) {
  const ray = new Ray(Cartesian3.fromArray(origin), Cartesian3.fromArray(direction));
  const interval = IntersectionTests.raySphere(ray, new BoundingSphere(Cartesian3.fromArray(centre), radius));
  return interval && (interval.start > 0 && !far ? interval.start : interval.stop);
}

run("cesium", { returns: "distance", root: "nearest", tangent: "either", level: "ordinary", intersect,
  ...(far && { roots: { culling: "front-faces" } }) });
