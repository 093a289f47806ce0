// The projected-centre form with unit directions. The squared distance of the centre from the line
// is subtracted from the squared radius. Returns the first root in front of the origin.
// raycheck directions unit
// raycheck returns distance
// raycheck root nearest
// raycheck tangent either
float hit_sphere(float3 o, float3 d, float3 c, float r) {
  float3 oc = o - c;
  float h = dot(oc, d);
  float3 across = oc - h * d;
  float disc = r * r - dot(across, across);
  if (disc < 0.0f) return -1.0f;
  float root = sqrt(disc);
  return -h - root >= 0.0f ? -h - root : -h + root;
}
