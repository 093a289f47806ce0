// Jolt Physics (npm jolt-physics: C++ in WebAssembly, in floats), TransformedShape.CastRay of a body with a SphereShape:
// "mFraction: Hit fraction of the ray [0, 1], HitPoint = Start + mFraction * (End - Start)". With mTreatConvexAsSolid false and
// back faces not ignored a ray from inside hits where it leaves. "mDirection:
// Direction and length of the ray (anything beyond this length will not be reported as a hit)": here 2^14. Silent about
// tangents. Source: Jolt/Physics/Collision/CastResult.h, RayCast.h (Doxygen); dist/types.d.ts.
import { run } from "./raycheck_candidate.mjs";
import initJolt from "jolt-physics";

const Jolt = await initJolt();
const reach = 2 ** 14;
const layers = { object: new Jolt.ObjectLayerPairFilterTable(1), broad: new Jolt.BroadPhaseLayerInterfaceTable(1, 1) };
layers.object.EnableCollision(0, 0);
layers.broad.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
const settings = new Jolt.JoltSettings();
settings.mObjectLayerPairFilter = layers.object;
settings.mBroadPhaseLayerInterface = layers.broad;
settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers.broad, 1, layers.object, 1);
const bodies = new Jolt.JoltInterface(settings).GetPhysicsSystem().GetBodyInterface();
const cast = new Jolt.RayCastSettings();
cast.mTreatConvexAsSolid = false;
cast.SetBackFaceMode(Jolt.EBackFaceMode_CollideWithBackFaces);
const anyShape = new Jolt.ShapeFilter();

function intersectBatch(rays, { centre, radius }) {
  const body = bodies.CreateBody(new Jolt.BodyCreationSettings(new Jolt.SphereShape(radius), new Jolt.RVec3(...centre),
    new Jolt.Quat(0, 0, 0, 1), Jolt.EMotionType_Static, 0));
  const shape = body.GetTransformedShape();
  const hits = rays.map(({ origin, direction }) => {
    const collector = new Jolt.CastRayClosestHitCollisionCollector();
    const from = new Jolt.RVec3(...origin);
    const along = new Jolt.Vec3(...direction.map((x) => reach * x));
    const ray = new Jolt.RRayCast(from, along);
    shape.CastRay(ray, cast, collector, anyShape);
    const s = collector.HadHit() ? collector.mHit.mFraction * reach : null;
    for (const used of [ray, along, from, collector]) Jolt.destroy(used);
    return s;
  });
  bodies.DestroyBody(body.GetID());
  return hits;
}

run("jolt", {
  precision: "single", directions: "unit", returns: "distance", root: "nearest", tangent: "either",
  roots: { tMax: reach, unit: "length" }, level: "ordinary", lengths: [2 ** -30, 2 ** 30], intersectBatch,
});
