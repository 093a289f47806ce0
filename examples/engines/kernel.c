/* A sphere in a fragment shader, as a candidate: code of GLSL and WGSL, with vec3 and float,
   translated to C. A shader's compiler may also fuse and reorder operations.

       gcc -O2 -ffp-contract=off -fPIC -shared -Iinclude examples/engines/kernel.c -lm -o kernel.so
       raycheck properties --candidate library:kernel.so */

#include <math.h>
#include <raycheck/candidate.h>

typedef struct vec3 {
  float x, y, z;
} vec3;

static vec3 vec(raycheck_vector v) {
  const vec3 r = {(float)v.x, (float)v.y, (float)v.z};
  return r;
}
static vec3 sub(vec3 a, vec3 b) {
  const vec3 r = {a.x - b.x, a.y - b.y, a.z - b.z};
  return r;
}
static vec3 along(vec3 o, float s, vec3 d) {
  const vec3 r = {o.x + s * d.x, o.y + s * d.y, o.z + s * d.z};
  return r;
}
static float dot3(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/* float hit_sphere(vec3 o, vec3 d, vec3 c, float r): the nearest s >= 0, or -1. */
static float hit_sphere(vec3 o, vec3 d, vec3 c, float r) {
  const vec3 oc = sub(o, c);
  const float a = dot3(d, d);
  const float b = dot3(oc, d);
  const float q = dot3(oc, oc) - r * r;
  const float disc = b * b - a * q;
  if (disc < 0.0f) return -1.0f;
  const float root = sqrtf(disc);
  const float s = (-b - root) / a;
  return s >= 0.0f ? s : (-b + root) / a;
}

static raycheck_hit intersect(const raycheck_ray* ray, const raycheck_sphere* sphere,
                              const raycheck_conventions* asked) {
  raycheck_hit hit = {0, 0, {0, 0, 0}};
  const vec3 o = vec(ray->origin), d = vec(ray->direction);
  const float s = hit_sphere(o, d, vec(sphere->centre), (float)sphere->radius);
  (void)asked;
  if (!(s >= 0.0f)) return hit;
  const vec3 at = along(o, s, d);
  hit.hit = 1;
  hit.parameter = s;
  hit.point.x = at.x;
  hit.point.y = at.y;
  hit.point.z = at.z;
  return hit;
}

const raycheck_candidate* raycheck_candidate_functions(void) {
  static raycheck_candidate candidate;
  candidate.version = RAYCHECK_CANDIDATE_VERSION;
  candidate.name = "kernel";
  candidate.declared.root = RAYCHECK_ROOT_NEAREST;
  candidate.declared.tangent = RAYCHECK_TANGENT_HIT;
  candidate.intersect = intersect;
  candidate.level = RAYCHECK_LEVEL_ORDINARY;
  candidate.smallest_length = 0x1p-30; /* whose squares stay in the range of floats */
  candidate.largest_length = 0x1p30;
  candidate.precision = RAYCHECK_PRECISION_SINGLE;
  return &candidate;
}
