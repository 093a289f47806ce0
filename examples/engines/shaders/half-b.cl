// The half-b form, h*h - c, with unit directions, as in most signed-distance shaders and small ray
// tracers. Returns the first root in front of the origin.
// raycheck directions unit
// raycheck returns distance
// raycheck root nearest
// raycheck tangent either
float hit_sphere(float3 o, float3 d, float3 c, float r) {
  float3 oc = o - c;
  float h = dot(oc, d);
  float disc = h * h - (dot(oc, oc) - r * r);
  if (disc < 0.0f) return -1.0f;
  float root = sqrt(disc);
  return -h - root >= 0.0f ? -h - root : -h + root;
}
