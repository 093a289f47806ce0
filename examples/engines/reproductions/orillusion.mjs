// node case.mjs, beside node_modules with @orillusion/core
Object.assign(globalThis, { window: globalThis, navigator: { userAgent: "" }, // no browser
  document: { createElement: () => ({ getContext: () => ({}), style: {} }) } });
const { Ray, Vector3 } = await import("@orillusion/core");
const [o, d, c] = [new Vector3({ox}, {oy}, {oz}), new Vector3({dx}, {dy}, {dz}), new Vector3({cx}, {cy}, {cz})];
const point = new Ray().intersectSphere(o, d, c, {r});
console.log(point ? [point.x, point.y, point.z].join(" ") : "miss");
