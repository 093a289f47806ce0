// node case.mjs, beside node_modules with @openglobus/og
const anything = new Proxy(class {}, { // in place of a browser
  get: (_, name) => (name === Symbol.toPrimitive ? () => "" : anything), apply: () => anything });
Object.assign(globalThis, { window: globalThis, document: anything, HTMLElement: class {} });
const { Ellipsoid, Vec3 } = await import("@openglobus/og");
const [o, d] = [new Vec3({ox}, {oy}, {oz}), new Vec3({dx}, {dy}, {dz})];
const point = new Ellipsoid({r}, {r}).hitRay(o, d);
console.log(point ? [point.x, point.y, point.z].join(" ") : "miss");
