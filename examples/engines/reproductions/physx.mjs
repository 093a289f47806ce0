// node case.mjs, beside node_modules with @cocos/physx
import initPhysX from "@cocos/physx";
initPhysX().then((PX) => {
  const foundation = PX.PxCreateFoundation(PX.PX_PHYSICS_VERSION, new PX.PxDefaultAllocator(), new PX.PxDefaultErrorCallback());
  const scale = new PX.PxTolerancesScale(), physics = PX.PxCreatePhysics(PX.PX_PHYSICS_VERSION, foundation, scale, false, null);
  const scene = physics.createScene(PX.getDefaultSceneDesc(scale, 0, PX.PxSimulationEventCallback.implement({})));
  const queried = new PX.PxShapeFlags(PX.PxShapeFlag.eSCENE_QUERY_SHAPE.value), blocks = () => PX.PxQueryHitType.eBLOCK;
  const shape = physics.createShape(new PX.PxSphereGeometry({r}), physics.createMaterial(0.5, 0.5, 0.5), true, queried);
  const at = { translation: { x: {cx}, y: {cy}, z: {cz} }, rotation: { x: 0, y: 0, z: 0, w: 1 } };
  const actor = physics.createRigidStatic(at), hit = new PX.PxRaycastHit();
  actor.attachShape(shape);
  scene.addActor(actor, null);
  const found = scene.raycastSingle({ x: {ox}, y: {oy}, z: {oz} }, { x: {dx}, y: {dy}, z: {dz} }, 2 ** 20,
    PX.PxHitFlag.eDEFAULT.value, hit, new PX.PxQueryFilterData(),
    PX.PxQueryFilterCallback.implement({ preFilter: blocks, postFilter: blocks }), null);
  console.log(found && hit.distance > 0 ? hit.distance : "miss"); // 0 from inside
});
