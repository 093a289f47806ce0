// node case.mjs, beside node_modules with jolt-physics
import initJolt from "jolt-physics";
const Jolt = await initJolt(), reach = 2 ** 14, settings = new Jolt.RayCastSettings(), shape = new Jolt.TransformedShape();
settings.mTreatConvexAsSolid = false;
settings.SetBackFaceMode(Jolt.EBackFaceMode_CollideWithBackFaces);
shape.mShape = new Jolt.SphereShape({r});
shape.SetWorldTransform(new Jolt.RVec3({cx}, {cy}, {cz}), new Jolt.Quat(0, 0, 0, 1), new Jolt.Vec3(1, 1, 1));
const ray = new Jolt.RRayCast(new Jolt.RVec3({ox}, {oy}, {oz}), new Jolt.Vec3(reach * {dx}, reach * {dy}, reach * {dz}));
const found = new Jolt.CastRayClosestHitCollisionCollector();
shape.CastRay(ray, settings, found, new Jolt.ShapeFilter());
console.log(found.HadHit() ? found.mHit.mFraction * reach : "miss");
