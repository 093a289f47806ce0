// openNURBS (npm rhino3dm: C++ in WebAssembly), Intersection.lineSphere(line, sphere): "Intersects a line with a sphere using
// exact calculations": LineSphereIntersection, and two points. A line has no beginning: every root counts, and the first
// point is judged. Silent about the order of the points and about its tolerance. Source: rhino3dm.d.ts.
import { run } from "./raycheck_candidate.mjs";
import initRhino from "rhino3dm";

const Rhino = await initRhino();

function intersect({ origin, direction: end }, { centre, radius }) {
  const line = new Rhino.Line(origin, end), sphere = new Rhino.Sphere(centre, radius);
  const [kind, first] = Rhino.Intersection.lineSphere(line, sphere);
  line.delete();
  sphere.delete();
  return kind.value === 0 ? null : first;
}

run("rhino3dm", {
  rays: "end", returns: "point", root: "smaller", tangent: "either", tMin: -Infinity, level: "ordinary", intersect,
});
