// node case.mjs, beside node_modules with @itwin/core-geometry
import { Ellipsoid, Point3d, Ray3d, Vector3d } from "@itwin/core-geometry";
const sphere = Ellipsoid.createCenterMatrixRadii(Point3d.create({cx}, {cy}, {cz}), undefined, {r}, {r}, {r});
const ray = Ray3d.create(Point3d.create({ox}, {oy}, {oz}), Vector3d.create({dx}, {dy}, {dz})), points = [];
sphere.intersectRay(ray, undefined, points, undefined);
console.log(points.length ? points[0].toArray().join(" ") : "miss");
