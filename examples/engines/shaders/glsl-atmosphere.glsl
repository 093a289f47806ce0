// glsl-atmosphere (npm; skies by stack.gl), rsi: "ray-sphere intersection that assumes the sphere is centered at the origin. No
// intersection when result.x > result.y": both roots, the smaller one first.
// raycheck include node_modules/glsl-atmosphere/index.glsl
// raycheck placement origin
// raycheck returns parameter
// raycheck root smaller
// raycheck tangent either
float hit_sphere(vec3 o, vec3 d, vec3 c, float r) {
  vec2 roots = rsi(o, d, r);
  return roots.x > roots.y ? -1.0 : roots.x;
}
