#ifndef RAYCHECK_CANDIDATE_H_
#define RAYCHECK_CANDIDATE_H_

/* The interface of a shared library that raycheck judges (`--candidate library:PATH.so`). The
   library exports raycheck_candidate_functions(), which returns a struct raycheck_candidate.
   Functions of the struct that are null are not judged. In C++, <raycheck/candidate.hpp> is
   shorter.

   Conventions. A camera looks along -W, W = (eye - look_at)/|eye - look_at|, U = up x W normalised,
   V = W x U. The image plane is at the signed position `near` along W (negative in front of the
   eye), bounded along U by left and right and along V by bottom and top. Pixel (i, j) is column i
   of `width` and row j of `height`. A ray starts at `origin`; its parameter is a multiple of
   `direction`. All lengths are scene lengths.

   Functions are called from one thread at a time, in a separate process (except when `tradeoff
   --sandbox none` times them). */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define RAYCHECK_CANDIDATE_VERSION 6

typedef struct raycheck_vector {
  double x, y, z;
} raycheck_vector;

typedef struct raycheck_camera {
  raycheck_vector eye, look_at, up;
  double near_plane; /* `near` is a macro in some compilers' headers */
  double left, right, bottom, top;
  int64_t width, height;
} raycheck_camera;

typedef struct raycheck_frame {
  raycheck_vector u, v, w; /* unit, at right angles */
} raycheck_frame;

typedef struct raycheck_pixel {
  int64_t i, j;
} raycheck_pixel;

typedef struct raycheck_ray {
  raycheck_vector origin, direction;
} raycheck_ray;

typedef struct raycheck_sphere {
  raycheck_vector centre;
  double radius;
} raycheck_sphere;

typedef struct raycheck_hit {
  int32_t hit;           /* 0: a miss; the other members are ignored */
  double parameter;      /* s, or what `returns` declares */
  raycheck_vector point; /* origin + s direction */
} raycheck_hit;

/* The conventions that a scene asks for or a candidate declares. A candidate that declares
   AS_ASKED follows the scene; random cases ask it for corners only if its contract has
   "corners as-asked". */
enum { RAYCHECK_AS_ASKED = 0 };
enum { RAYCHECK_ROWS_BOTTOM_FIRST = 1, RAYCHECK_ROWS_TOP_FIRST = 2 }; /* which row is j = 0 */
enum {
  RAYCHECK_SAMPLES_EDGES = 1,   /* i/(w-1) */
  RAYCHECK_SAMPLES_CENTRES = 2, /* (i+1/2)/w */
  RAYCHECK_SAMPLES_CORNERS = 3  /* i/w */
};
enum { RAYCHECK_ORIGIN_PIXEL = 1, RAYCHECK_ORIGIN_FOCAL = 2 }; /* start: pixel's P, eye E */
enum { RAYCHECK_ROOT_NEAREST = 1, RAYCHECK_ROOT_SMALLER = 2 }; /* s >= 0, or smaller root */
enum { RAYCHECK_TANGENT_HIT = 1, RAYCHECK_TANGENT_MISS = 2, RAYCHECK_TANGENT_EITHER = 3 };

typedef struct raycheck_conventions {
  int32_t rows, samples, origin, root, tangent;
} raycheck_conventions;

/* The difficulty of the random cases by which `raycheck properties` judges the candidate. Careful
   code in doubles gets ordinary cases right; demanding cases need a stable method; extreme cases
   include all that doubles can express. */
enum {
  RAYCHECK_LEVEL_UNSTATED = 0, /* ordinary */
  RAYCHECK_LEVEL_ORDINARY = 1,
  RAYCHECK_LEVEL_DEMANDING = 2,
  RAYCHECK_LEVEL_EXTREME = 3
};

/* The roots that count: those from t_min (-INFINITY: a line is intersected, not a ray) to t_max
   (INFINITY: no upper end) that are not culled. t_min and t_max are values of s, radii of the
   sphere or scene lengths along the ray. If t_max = INFINITY and all other members are 0, every
   root >= 0 counts. */
enum {
  RAYCHECK_ENDS_CLOSED = 0,
  RAYCHECK_ENDS_OPEN_MAX = 1,
  RAYCHECK_ENDS_OPEN_MIN = 2,
  RAYCHECK_ENDS_OPEN = 3
};
enum { RAYCHECK_T_ABSOLUTE = 0, RAYCHECK_T_RADIUS = 1, RAYCHECK_T_LENGTH = 2 };
enum { RAYCHECK_CULL_NONE = 0, RAYCHECK_CULL_BACK_FACES = 1, RAYCHECK_CULL_FRONT_FACES = 2 };
typedef struct raycheck_valid_roots {
  double t_min, t_max;
  int32_t ends, unit, culling;
} raycheck_valid_roots;

/* From version 3 on, the conventions that a function receives are the first member of this struct;
   raycheck_valid_roots_of() returns the other member. */
typedef struct raycheck_asked {
  raycheck_conventions conventions;
  raycheck_valid_roots valid;
} raycheck_asked;
static inline const raycheck_valid_roots* raycheck_valid_roots_of(
    const raycheck_conventions* asked) {
  return &((const raycheck_asked*)(const void*)asked)->valid;
}

/* Whether the candidate follows the scene's valid roots, or declares its own. */
enum { RAYCHECK_ROOTS_USUAL = 0, RAYCHECK_ROOTS_DECLARED = 1, RAYCHECK_ROOTS_AS_ASKED = 2 };

/* The format that the candidate computes in. In single precision all inputs are floats, passed as
   doubles, and errors are counted in u and ulp of float. */
enum { RAYCHECK_PRECISION_DOUBLE = 0, RAYCHECK_PRECISION_SINGLE = 1 };

/* The directions that the candidate accepts. UNIT: it is called only with directions of length 1,
   up to rounding. */
enum { RAYCHECK_DIRECTIONS_ANY = 0, RAYCHECK_DIRECTIONS_UNIT = 1 };

/* What the candidate returns for a hit: s and Q; s; Q; as `parameter`, the distance of Q along the
   ray in scene lengths or the square of this distance; only that there is a hit; or both roots of
   the ray's line, v - d as `parameter` and v + d as `point.x`: raycheck chooses among them. */
enum {
  RAYCHECK_RETURNS_HIT = 0,
  RAYCHECK_RETURNS_PARAMETER = 1,
  RAYCHECK_RETURNS_POINT = 2,
  RAYCHECK_RETURNS_DISTANCE = 3,
  RAYCHECK_RETURNS_SQUARED_DISTANCE = 4,
  RAYCHECK_RETURNS_CLASS = 5,
  RAYCHECK_RETURNS_ROOTS = 6
};

typedef struct raycheck_candidate {
  uint32_t version; /* RAYCHECK_CANDIDATE_VERSION */
  const char* name; /* of letters, digits, '-', '_' and '.'; may be null */
  raycheck_conventions declared;

  /* The camera's axes. */
  raycheck_frame (*frame)(const raycheck_camera*);
  /* P, a pixel's point on the image plane. */
  raycheck_vector (*pixel_point)(const raycheck_camera*, const raycheck_conventions*,
                                 raycheck_pixel);
  /* The ray from P along (P - E)/|P - E|. */
  raycheck_ray (*pixel_ray)(const raycheck_camera*, const raycheck_conventions*, raycheck_pixel);
  /* The ray from E along (P - E)/|P - E|. */
  raycheck_ray (*focal_ray)(const raycheck_camera*, const raycheck_conventions*, raycheck_pixel);
  /* One ray and one sphere; directions need not be unit. */
  raycheck_hit (*intersect)(const raycheck_ray*, const raycheck_sphere*,
                            const raycheck_conventions*);
  /* `count` rays and one sphere: hits[k] is for rays[k]. If set, called instead of `intersect`. */
  void (*intersect_batch)(const raycheck_ray* rays, size_t count, const raycheck_sphere*,
                          const raycheck_conventions*, raycheck_hit* hits);
  /* The index of the sphere with the least s; -1 if all are missed. */
  int64_t (*nearest)(const raycheck_ray*, const raycheck_sphere* spheres, size_t count,
                     const raycheck_conventions*);

  /* From version 2 on. */
  int32_t level;
  /* Scenes with a nonzero length outside these bounds are not judged; both 0: 2^-960 and inf. */
  double smallest_length, largest_length;

  /* From version 3 on. */
  int32_t precision;
  int32_t roots;                       /* RAYCHECK_ROOTS_...; USUAL: every root >= 0 counts */
  raycheck_valid_roots declared_roots; /* used only if roots is RAYCHECK_ROOTS_DECLARED */

  /* From version 4 on. */
  int32_t directions, returns;

  /* From version 5 on: more declarations, in the words of `raycheck list`, separated by semicolons:
     "samples centres; t_min 1e-4"; or null. */
  const char* contract;

  /* From version 6 on: the point of the sphere that is seen through a pixel, as `intersect` answers
     about the pixel's ray. If set, the hits of a camera's pixels are these. */
  raycheck_hit (*pick)(const raycheck_camera*, const raycheck_conventions*, raycheck_pixel,
                       const raycheck_sphere*);
} raycheck_candidate;

#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const raycheck_candidate*
raycheck_candidate_functions(void);

#ifdef __cplusplus
}
#endif

#endif /* RAYCHECK_CANDIDATE_H_ */
