// node case.mjs, beside node_modules with @openglobus/og
const anything = new Proxy(class {}, { // in place of a browser
  get: (_, name) => (name === Symbol.toPrimitive ? () => "" : anything), apply: () => anything });
Object.assign(globalThis, { window: globalThis, document: anything, HTMLElement: class {} });
const { Ray, Vec3, bv } = await import("@openglobus/og");
const [o, d] = [new Vec3({ox}, {oy}, {oz}), new Vec3({dx}, {dy}, {dz})];
const point = new Ray(o, d).hitSphere(new bv.Sphere({r}, new Vec3({cx}, {cy}, {cz})));
console.log(point ? [point.x, point.y, point.z].join(" ") : "miss");
