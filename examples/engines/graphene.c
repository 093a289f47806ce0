/* Graphene's graphene_ray_intersect_sphere, in floats: whether the ray enters or leaves the sphere,
   and "the distance of the point on the ray that intersects the sphere". Debian:
   libgraphene-1.0-dev; -lgraphene-1.0.
   Source: graphene-ray.h and its manual. A ray's direction is made unit. Silent on tangents. */

#include <graphene.h>
#include <raycheck/candidate.h>

static raycheck_hit intersect(const raycheck_ray* ray, const raycheck_sphere* sphere,
                              const raycheck_conventions* asked) {
  const raycheck_vector o = ray->origin, d = ray->direction, c = sphere->centre;
  const graphene_point3d_t origin = {(float)o.x, (float)o.y, (float)o.z};
  const graphene_point3d_t centre = {(float)c.x, (float)c.y, (float)c.z};
  graphene_vec3_t direction;
  graphene_ray_t line;
  graphene_sphere_t ball;
  float distance = 0;
  raycheck_hit hit = {0, 0, {0, 0, 0}};
  (void)asked;
  graphene_vec3_init(&direction, (float)d.x, (float)d.y, (float)d.z);
  graphene_ray_init(&line, &origin, &direction);
  graphene_sphere_init(&ball, &centre, (float)sphere->radius);
  hit.hit =
      graphene_ray_intersect_sphere(&line, &ball, &distance) != GRAPHENE_RAY_INTERSECTION_KIND_NONE;
  hit.parameter = distance;
  return hit;
}

const raycheck_candidate* raycheck_candidate_functions(void) {
  static raycheck_candidate candidate;
  candidate.version = RAYCHECK_CANDIDATE_VERSION;
  candidate.declared.root = RAYCHECK_ROOT_NEAREST;
  candidate.declared.tangent = RAYCHECK_TANGENT_EITHER;
  candidate.intersect = intersect;
  candidate.level = RAYCHECK_LEVEL_ORDINARY;
  candidate.smallest_length = 0x1p-30; /* whose squares stay in the range of floats */
  candidate.largest_length = 0x1p30;
  candidate.precision = RAYCHECK_PRECISION_SINGLE;
  candidate.returns = RAYCHECK_RETURNS_DISTANCE;
  return &candidate;
}
