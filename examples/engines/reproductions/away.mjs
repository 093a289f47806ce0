// node case.mjs, beside node_modules with @awayjs/core
Object.assign(globalThis, { window: globalThis, self: globalThis, navigator: { userAgent: "" }, // no browser
  document: { createElement: () => ({ getContext: () => ({}) }) } });
console.debug = () => {}; // the library prints its name by it
const { Sphere, Vector3D } = (await import("@awayjs/core")).default;
const [o, d] = [new Vector3D({ox}, {oy}, {oz}), new Vector3D({dx}, {dy}, {dz})];
const s = new Sphere({cx}, {cy}, {cz}, {r}).rayIntersection(o, d, new Vector3D());
console.log(s <= 0 ? "miss" : s); // 0 from inside
