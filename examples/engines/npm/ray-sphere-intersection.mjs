// ray-sphere-intersection (npm, used with stack.gl and ray-3d): "Determines if the 3D ray (origin,
// direction) intersects with the 3D sphere (center, radius). If no intersection occurs, returns
// `null`. Otherwise, the intersection point is stored in `out` and then returned." Silent about
// unit directions, which the code needs and its example has, about tangents and about origins
// inside; the code takes only the smaller root. Source: README.md.
import { run } from "./raycheck_candidate.mjs";
import intersectRaySphere from "ray-sphere-intersection";

const intersect = ({ origin, direction }, { centre, radius }) => intersectRaySphere([], origin, direction, centre, radius);

run("ray-sphere-intersection", {
  directions: "unit", returns: "point", root: "smaller", tangent: "either", level: "ordinary", intersect,
});
