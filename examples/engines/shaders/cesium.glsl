// CesiumJS (npm @cesium/engine), czm_raySphereIntersectionInterval: "The intersection interval of
// the ray with the sphere", or czm_emptyRaySegment. Directions of any length. Its structs are in
// Source/Shaders/Builtin/Structs. If the origin is inside, the stop is the point on the sphere.
// raycheck include node_modules/@cesium/engine/Source/Shaders/Builtin/Constants/infinity.js
// raycheck include node_modules/@cesium/engine/Source/Shaders/Builtin/Structs/ray.js
// raycheck include node_modules/@cesium/engine/Source/Shaders/Builtin/Structs/raySegment.js
// raycheck include node_modules/@cesium/engine/Source/Shaders/Builtin/Functions/raySphereIntersectionInterval.js
// raycheck returns parameter
// raycheck root nearest
// raycheck tangent either
float hit_sphere(vec3 o, vec3 d, vec3 c, float r) {
  czm_raySegment found = czm_raySphereIntersectionInterval(czm_ray(o, d), c, r);
  return found == czm_emptyRaySegment ? -1.0 : found.start >= 0.0 ? found.start : found.stop;
}
