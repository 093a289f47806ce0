/* libctl's (MEEP, MPB) intersect_line_with_object of a sphere, in doubles: the two parameters s of
   the points p + s d, for a line. Debian: libctl-dev; -lctlgeom. Source: utils/geom.c: "Compute the
   intersections with o of a line along p+s*d, returning the number of intersections (at most 2) and
   the two intersection s values". Silent on their order and on tangents. */

#include <ctlgeom.h>
#include <math.h>
#include <raycheck/candidate.h>

static vector3 to(raycheck_vector v) {
  const vector3 x = {v.x, v.y, v.z};
  return x;
}

static raycheck_hit intersect(const raycheck_ray* ray, const raycheck_sphere* sphere,
                              const raycheck_conventions* asked) {
  double s[2] = {0, 0};
  raycheck_hit hit = {0, 0, {0, 0, 0}};
  geometric_object ball = make_sphere(0, to(sphere->centre), sphere->radius);
  const int found = intersect_line_with_object(to(ray->origin), to(ray->direction), ball, s);
  (void)asked;
  geometric_object_destroy(ball);
  hit.hit = found > 0;
  hit.parameter = found == 2 ? fmin(s[0], s[1]) : s[0];
  hit.point.x = found == 2 ? fmax(s[0], s[1]) : s[0];
  return hit;
}

const raycheck_candidate* raycheck_candidate_functions(void) {
  static raycheck_candidate candidate;
  candidate.version = RAYCHECK_CANDIDATE_VERSION;
  candidate.declared.root = RAYCHECK_ROOT_NEAREST;
  candidate.declared.tangent = RAYCHECK_TANGENT_EITHER;
  candidate.intersect = intersect;
  candidate.level = RAYCHECK_LEVEL_ORDINARY;
  candidate.returns = RAYCHECK_RETURNS_ROOTS;
  return &candidate;
}
