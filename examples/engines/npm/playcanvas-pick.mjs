// PlayCanvas (npm playcanvas), CameraComponent.screenToWorld: "Convert a point from 2D screen space to 3D world space"; its
// example casts a ray from the camera's position to that point on the far plane. Then BoundingSphere.intersectsRay
// (playcanvas.mjs). Matrices are floats. Silent about errors. Source: framework/components/camera/component.d.ts.
import { run } from "./raycheck_candidate.mjs";
import { AppBase, AppOptions, BoundingSphere, CameraComponentSystem, Entity, NullGraphicsDevice, Ray, Vec3 } from "playcanvas/build/playcanvas.mjs";

const canvas = { id: "", width: 1, height: 1, clientRect: {}, addEventListener() {}, removeEventListener() {} };
const options = new AppOptions();
Object.assign(options, { graphicsDevice: new NullGraphicsDevice(canvas), componentSystems: [CameraComponentSystem] });
const app = new AppBase(canvas);
app.init(options);

function pick({ eye, lookAt, up, near, right, top, width, height }, _, [i, j], { centre, radius }) {
  Object.assign(canvas, { width, height });
  app.graphicsDevice.updateClientRect();
  const entity = new Entity();
  app.root.addChild(entity);
  const fov = 2 * Math.atan(top / -near) * (180 / Math.PI);
  entity.addComponent("camera", { fov, aspectRatioMode: 1, aspectRatio: right / top, nearClip: -near, farClip: -1000 * near });
  entity.setPosition(...eye);
  entity.lookAt(...lookAt, ...up);
  const from = entity.getPosition().clone();
  const to = entity.camera.screenToWorld(i + 0.5, j + 0.5, entity.camera.farClip);
  const point = new Vec3();
  const found = new BoundingSphere(new Vec3(centre), radius).intersectsRay(new Ray(from, to.sub(from).normalize()), point);
  entity.destroy();
  return found && point.toArray();
}

run("playcanvas-pick", {
  rows: "top-first", samples: "centres", origin: "focal", root: "nearest", tangent: "either", windows: "symmetric",
  returns: "point", level: "ordinary", precision: "single", lengths: [2 ** -30, 2 ** 30], pick,
});
