// The textbook's quadratic, as in ray-tracing books and many shaders: a, b and c with the factors 2
// and 4, directions of any length. Returns the first root in front of the origin. Tangents hit.
// raycheck returns parameter
// raycheck root nearest
// raycheck tangent either
float hit_sphere(float3 o, float3 d, float3 c, float r) {
  float3 oc = o - c;
  float a = dot(d, d);
  float b = 2.0f * dot(oc, d);
  float k = dot(oc, oc) - r * r;
  float disc = b * b - 4.0f * a * k;
  if (disc < 0.0f) return -1.0f;
  float root = sqrt(disc);
  float s = (-b - root) / (2.0f * a);
  return s >= 0.0f ? s : (-b + root) / (2.0f * a);
}
