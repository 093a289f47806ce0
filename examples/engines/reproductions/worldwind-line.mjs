// node case.mjs, beside node_modules with @nasaworldwind/worldwind
import { createRequire } from "node:module";
Object.assign(globalThis, { window: globalThis, self: globalThis, location: { href: "", pathname: "" }, addEventListener() {},
  document: { getElementsByTagName: () => [], createElement: () => ({ style: {} }) } });
const { Line, Vec3, WWMath } = createRequire(import.meta.url)("@nasaworldwind/worldwind");
const line = new Line(new Vec3({ox}, {oy}, {oz}), new Vec3({dx}, {dy}, {dz})), point = new Vec3(0, 0, 0);
const hit = WWMath.computeEllipsoidalGlobeIntersection(line, {r}, {r}, point);
console.log(hit ? [point[0], point[1], point[2]].join(" ") : "miss");
