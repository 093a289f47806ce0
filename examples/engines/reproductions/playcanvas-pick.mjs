// node case.mjs, beside node_modules with playcanvas
import { AppBase, AppOptions, BoundingSphere, CameraComponentSystem, Entity, NullGraphicsDevice, Ray, Vec3 } from "playcanvas";
const canvas = { id: "", width: {width}, height: {height}, addEventListener() {}, removeEventListener() {} };
const app = new AppBase(canvas);
app.init(Object.assign(new AppOptions(), { graphicsDevice: new NullGraphicsDevice(canvas), componentSystems: [CameraComponentSystem] }));
app.graphicsDevice.updateClientRect();
const entity = new Entity();
app.root.addChild(entity);
const fov = 2 * Math.atan({top} / {near}) * (180 / Math.PI);
entity.addComponent("camera", { fov, aspectRatioMode: 1, aspectRatio: {right} / {top}, nearClip: {near}, farClip: 1000 * {near} });
entity.setPosition({ex}, {ey}, {ez});
entity.lookAt({ax}, {ay}, {az}, {ux}, {uy}, {uz});
const from = entity.getPosition().clone();
const to = entity.camera.screenToWorld({i} + 0.5, {j} + 0.5, entity.camera.farClip);
const point = new Vec3();
const ball = new BoundingSphere(new Vec3({cx}, {cy}, {cz}), {r});
console.log(ball.intersectsRay(new Ray(from, to.sub(from).normalize()), point) ? point.toArray().join(" ") : "miss");
process.exit();
