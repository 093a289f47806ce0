// NASA WorldWind (npm @nasaworldwind/worldwind), Globe.intersectsLine, with equal radii: "The line is interpreted as a ray;
// intersection points behind the line's origin are ignored." Directions of any length; silent about tangents, and about
// origins on the globe. The package is for browsers; what it needs while loading is faked here, and the globe has nothing
// but its radii. With the argument `line`, WWMath.computeEllipsoidalGlobeIntersection: "Computes the Cartesian intersection
// point of a specified line with an ellipsoid". Source: build/dist/worldwind.js.
import { createRequire } from "node:module";
import { run } from "./raycheck_candidate.mjs";

Object.assign(globalThis, { window: globalThis, self: globalThis, location: { href: "", pathname: "" }, addEventListener() {},
  document: { getElementsByTagName: () => [], createElement: () => ({ style: {} }) } });
const { Globe, Line, Vec3, WWMath } = createRequire(import.meta.url)("@nasaworldwind/worldwind");
const asLine = process.argv[2] === "line";

function intersect({ origin, direction }, { radius }) {
  const line = new Line(new Vec3(...origin), new Vec3(...direction)), point = new Vec3(0, 0, 0);
  const globe = Object.assign(Object.create(Globe.prototype),
    { equatorialRadius: radius, polarRadius: radius, is2D: () => false });
  const hit = asLine
    ? WWMath.computeEllipsoidalGlobeIntersection(line, radius, radius, point)
    : globe.intersectsLine(line, point);
  return hit && [0, 1, 2].map((k) => point[k]);
}

run("worldwind", {
  placement: "origin", returns: "point", root: asLine ? "smaller" : "nearest", tangent: "either",
  roots: asLine ? { tMin: -Infinity } : { ends: "(]" }, level: "ordinary", intersect,
});
