// The projected-centre form with unit directions: the vector from the centre to the point of the line that is nearest to
// it, whose square is subtracted from that of the radius. The first root in front of the origin.
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
