// CesiumJS (npm @cesium/engine), IntersectionTests.rayEllipsoid with equal radii: "The interval containing scalar points
// along the ray or undefined if there are no intersections." From inside, the interval starts at 0, and its stop is the
// point on the ellipsoid. Ray normalises its direction. Silent about tangents. With the argument `far` only the stop is
// judged. Source: Source/Core/IntersectionTests.js.
import { run } from "./raycheck_candidate.mjs";

const core = async (name) => (await import(`@cesium/engine/Source/Core/${name}.js`)).default; // a sandbox opens few files
const Cartesian3 = await core("Cartesian3");
const Ray = await core("Ray");
const IntersectionTests = await core("IntersectionTests");
const Ellipsoid = await core("Ellipsoid");

const far = process.argv[2] === "far";
function intersect({ origin, direction }, { radius }) {
  const ray = new Ray(Cartesian3.fromArray(origin), Cartesian3.fromArray(direction));
  const interval = IntersectionTests.rayEllipsoid(ray, new Ellipsoid(radius, radius, radius));
  return interval && (interval.start > 0 && !far ? interval.start : interval.stop);
}

run("cesium-ellipsoid", {
  placement: "origin", returns: "distance", root: "nearest", tangent: "either", level: "ordinary", intersect,
  ...(far && { roots: { culling: "front-faces" } }),
});
