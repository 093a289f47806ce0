// The textbook's quadratic, as in ray-tracing books and many shaders: a, b and c with the factors 2
// and 4, directions of any length. Returns the first root in front of the origin. Tangents hit.
// raycheck returns parameter
// raycheck root nearest
// raycheck tangent either
float hit_sphere(vec3 o, vec3 d, vec3 c, float r) {
  vec3 oc = o - c;
  float a = dot(d, d);
  float b = 2.0 * dot(oc, d);
  float k = dot(oc, oc) - r * r;
  float disc = b * b - 4.0 * a * k;
  if (disc < 0.0) return -1.0;
  float root = sqrt(disc);
  float s = (-b - root) / (2.0 * a);
  return s >= 0.0 ? s : (-b + root) / (2.0 * a);
}
