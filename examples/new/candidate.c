/* NAME, a candidate for raycheck: call your function below, and declare its conventions. */

#include <raycheck/candidate.h>
#include <stdio.h>
#include <stdlib.h>

static raycheck_hit intersect(const raycheck_ray* ray, const raycheck_sphere* sphere,
                              const raycheck_conventions* asked) {
  /* Doubles: ray->origin, ray->direction, sphere->centre (x, y, z), sphere->radius. Return
     {0, ...} for a miss, or {1, s, {x, y, z}} with the point at origin + s direction. */
  (void)ray, (void)sphere, (void)asked;
  fputs("NAME: calls nothing yet\n", stderr);
  exit(1);
}

#ifdef __cplusplus
extern "C"
#endif
    const raycheck_candidate*
    raycheck_candidate_functions(void) {
  static raycheck_candidate candidate;
  candidate.version = RAYCHECK_CANDIDATE_VERSION;
  candidate.name = "NAME";
  candidate.intersect = intersect;
  candidate.declared.root = RAYCHECK_ROOT_NEAREST; /* or RAYCHECK_ROOT_SMALLER: always v - d */
  candidate.declared.tangent = RAYCHECK_TANGENT_EITHER;
  /* If it applies, set candidate.precision (your code computes in floats), candidate.roots and
     .declared_roots, candidate.directions, candidate.returns. */
  return &candidate;
}
