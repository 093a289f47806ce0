/* MuJoCo's mju_rayGeom of a sphere, in doubles: the x of pnt + x vec, x >= 0, at the nearest
   surface, or -1. Debian: libmujoco-dev; -lmujoco.
   Source: mujoco/mujoco.h, "Ray collisions". Directions of any length. Silent on tangents and on
   the effect of mjMINVAL, 1e-15. */

#include <mujoco/mujoco.h>
#include <raycheck/candidate.h>

static raycheck_hit intersect(const raycheck_ray* ray, const raycheck_sphere* sphere,
                              const raycheck_conventions* asked) {
  static const mjtNum turned[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const raycheck_vector o = ray->origin, d = ray->direction, c = sphere->centre;
  const mjtNum pos[3] = {c.x, c.y, c.z}, size[3] = {sphere->radius, 0, 0};
  const mjtNum pnt[3] = {o.x, o.y, o.z}, vec[3] = {d.x, d.y, d.z};
  raycheck_hit hit = {0, 0, {0, 0, 0}};
  (void)asked;
  hit.parameter = mju_rayGeom(pos, turned, size, pnt, vec, mjGEOM_SPHERE);
  hit.hit = hit.parameter != -1;
  return hit;
}

const raycheck_candidate* raycheck_candidate_functions(void) {
  static raycheck_candidate candidate;
  candidate.version = RAYCHECK_CANDIDATE_VERSION;
  candidate.declared.root = RAYCHECK_ROOT_NEAREST;
  candidate.declared.tangent = RAYCHECK_TANGENT_EITHER;
  candidate.intersect = intersect;
  candidate.level = RAYCHECK_LEVEL_ORDINARY;
  candidate.returns = RAYCHECK_RETURNS_PARAMETER;
  return &candidate;
}
