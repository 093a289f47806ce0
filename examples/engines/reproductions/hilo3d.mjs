// node case.mjs, beside node_modules with hilo3d
Object.assign(globalThis, { window: globalThis, navigator: { userAgent: "" }, screen: {}, Image: class {}, // no browser
  document: { createElement: () => ({ getContext: () => ({}), style: {} }) } });
const { Ray, Vector3 } = (await import("hilo3d")).default;
const ray = new Ray({ origin: new Vector3({ox}, {oy}, {oz}), direction: new Vector3({dx}, {dy}, {dz}) });
const point = ray.intersectsSphere([{cx}, {cy}, {cz}], {r});
console.log(point ? point.elements.join(" ") : "miss");
