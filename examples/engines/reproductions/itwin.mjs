// node case.mjs, beside node_modules with @itwin/core-geometry
import { Ellipsoid, Point3d, Ray3d, Vector3d } from "@itwin/core-geometry";
const sphere = Ellipsoid.createCenterMatrixRadii(Point3d.create({cx}, {cy}, {cz}), undefined, {r}, {r}, {r});
const ray = Ray3d.create(Point3d.create({ox}, {oy}, {oz}), Vector3d.create({dx}, {dy}, {dz})), fractions = [];
sphere.intersectRay(ray, fractions, undefined, undefined);
console.log(fractions.find((fraction) => fraction >= 0) ?? "miss");
