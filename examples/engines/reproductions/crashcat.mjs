// node case.mjs, beside node_modules with crashcat
import { CastRayStatus, castRayVsShape, createClosestCastRayCollector, registerAll, sphere } from "crashcat";
registerAll();
const collector = createClosestCastRayCollector(), settings = { collideWithBackfaces: false, treatConvexAsSolid: false };
collector.reset();
castRayVsShape(collector, settings, {ox}, {oy}, {oz}, {dx}, {dy}, {dz}, 1024, sphere.create({ radius: {r} }), 0, 0,
  {cx}, {cy}, {cz}, 0, 0, 0, 1, 1, 1, 1);
console.log(collector.hit.status === CastRayStatus.COLLIDING ? collector.hit.fraction * 1024 : "miss");
