// Simbody's ContactGeometry::Sphere::intersectsRay, in doubles: the distance from the ray's origin
// to the intersection point. Debian: libsimbody-dev; -std=c++17 -lSimTKmath -lSimTKcommon. Source:
// simmath/internal/ContactGeometry.h, which is not valid C++20. UnitVec3 makes directions unit. Its
// spheres have their centres at (0, 0, 0), so that the adapter subtracts the centre. Silent on
// tangents.

#include <SimTKmath.h>
#include <raycheck/candidate.h>

static SimTK::Vec3 vec3(const raycheck_vector& v) { return {v.x, v.y, v.z}; }

static raycheck_hit intersect(const raycheck_ray* ray, const raycheck_sphere* sphere,
                              const raycheck_conventions*) {
  const SimTK::ContactGeometry::Sphere ball(sphere->radius);
  SimTK::UnitVec3 normal;
  raycheck_hit hit = {};
  hit.hit = ball.intersectsRay(vec3(ray->origin) - vec3(sphere->centre),
                               SimTK::UnitVec3(vec3(ray->direction)), hit.parameter, normal);
  return hit;
}

const raycheck_candidate* raycheck_candidate_functions() {
  static raycheck_candidate candidate;
  candidate.version = RAYCHECK_CANDIDATE_VERSION;
  candidate.declared.root = RAYCHECK_ROOT_NEAREST;
  candidate.declared.tangent = RAYCHECK_TANGENT_EITHER;
  candidate.intersect = intersect;
  candidate.level = RAYCHECK_LEVEL_ORDINARY;
  candidate.returns = RAYCHECK_RETURNS_DISTANCE;
  return &candidate;
}
