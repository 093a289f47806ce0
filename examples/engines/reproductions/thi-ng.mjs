// node case.mjs, beside node_modules with @thi.ng/geom-isec
import { IntersectionType, intersectRayCircle } from "@thi.ng/geom-isec";
const { type, alpha } = intersectRayCircle([{ox}, {oy}, {oz}], [{dx}, {dy}, {dz}], [{cx}, {cy}, {cz}], {r});
console.log(type === IntersectionType.INTERSECT ? alpha : "miss");
