// The projected-centre form with unit directions. The squared distance of the centre from the line
// is subtracted from the squared radius. Returns the first root in front of the origin.
// raycheck directions unit
// raycheck returns distance
// raycheck root nearest
// raycheck tangent either
float hit_sphere(vec3 o, vec3 d, vec3 c, float r) {
  vec3 oc = o - c;
  float h = dot(oc, d);
  vec3 across = oc - h * d;
  float disc = r * r - dot(across, across);
  if (disc < 0.0) return -1.0;
  float root = sqrt(disc);
  return -h - root >= 0.0 ? -h - root : -h + root;
}
