// Hilo3d (npm hilo3d), pictures by Ray.fromCamera and Ray.intersectsSphere. The objects of a browser that the package needs
// while loading are faked here. It takes only the smaller root. Source: types/index.d.ts.
import { draw } from "./pictures.mjs";

const element = { getContext: () => ({}), style: {} };
Object.assign(globalThis, { window: globalThis, navigator: { userAgent: "" }, screen: {}, Image: class {},
  document: { createElement: () => element } });
const { default: Hilo3d } = await import("hilo3d");
const { PerspectiveCamera, Ray, Vector3 } = Hilo3d;

draw(({ eye, at, up, angle, width, height }) => {
  const camera = new PerspectiveCamera({ fov: angle, aspect: width / height, near: 0.1, far: 2000 });
  camera.position.set(...eye);
  camera.up.set(...up);
  camera.lookAt(new Vector3(...at));
  camera.updateViewProjectionMatrix();
  return (x, y) => {
    const ray = new Ray();
    ray.fromCamera(camera, x, y, width, height);
    return (centre, radius) => ray.intersectsSphere(centre, radius)?.distance(ray.origin);
  };
}, { culls: true });
