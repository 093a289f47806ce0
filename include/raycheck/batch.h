#ifndef RAYCHECK_BATCH_H_
#define RAYCHECK_BATCH_H_

// Certified answers about many rays and spheres: arrays in, arrays out. C11; link
// raycheck::raycheck. In C++, <raycheck/batch.hpp> makes the arrays from spans.
//
//     raycheck_error error;
//     const raycheck_options options = {.version = RAYCHECK_BATCH_VERSION, .threads = 2};
//     const raycheck_decided to = {.hit_class = {classes, count, 0, RAYCHECK_UINT8},
//                                  .s = {s, count, 0, RAYCHECK_FLOAT64}};
//     if (raycheck_decide(&rays, &spheres, &options, &to, &error) != RAYCHECK_OK)
//       fprintf(stderr, "%s[%zu]: %s\n", error.array, error.index, error.reason);
//
// Functions return RAYCHECK_OK or another raycheck_code, and then fill `error`, which may be null.
// They throw nothing, and keep no pointer and no memory when they return. All arithmetic is inside
// libraycheck: your compiler flags change no answer.
//
// Answers: those of ray k are at index k; see raycheck_pairing. Answers that are not wanted have
// the pointer null. Of a miss, all numbers are NaN; where no sphere is seen, they are infinite.
//
// Invalid rays and spheres (a NaN or an infinity, the direction 0, a radius below 0) change no
// other answer. Their own classes are RAYCHECK_INVALID, their numbers NaN, and the function
// returns RAYCHECK_INVALID_INPUT with the first of them in `error`. If arrays do not fit together,
// or conventions or a camera are invalid, nothing is written.
//
// Thread safety: functions may be called from several threads.

#include <raycheck/api.h>
#include <raycheck/candidate.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The version of the structs below. A later version adds members at the ends of raycheck_options
/// and of the structs of answers; a library reads those that `version` of the options has.
#define RAYCHECK_BATCH_VERSION 1

/// What a function returns: success; an invalid number; arrays, conventions or a camera that cannot
/// be used; too little memory; a fault of libraycheck.
enum raycheck_code {
  RAYCHECK_OK = 0,
  RAYCHECK_INVALID_INPUT = 1,
  RAYCHECK_INVALID_ARGUMENT = 2,
  RAYCHECK_OUT_OF_MEMORY = 3,
  RAYCHECK_INTERNAL_ERROR = 4
};

/// Why a function failed.
typedef struct raycheck_error {
  int32_t code;      ///< A raycheck_code.
  size_t index;      ///< The element of the array.
  char array[32];    ///< Such as "direction", "radius" or "camera.up"; empty if no array is meant.
  char reason[216];  ///< A sentence without a full stop.
} raycheck_error;

/// The type of an array's elements. Coordinates are doubles or floats, pixels and answers that
/// count or choose are integers.
enum raycheck_type {
  RAYCHECK_FLOAT64 = 0,
  RAYCHECK_FLOAT32 = 1,
  RAYCHECK_UINT8 = 2,
  RAYCHECK_INT32 = 3,
  RAYCHECK_INT64 = 4
};

/// Numbers to read. A single element stands for any number of equal ones.
typedef struct raycheck_array {
  const void* data;  ///< The first element.
  size_t count;      ///< The number of elements.
  ptrdiff_t stride;  ///< Bytes from one element to the next; 0: no gaps.
  int32_t type;      ///< A raycheck_type.
} raycheck_array;

/// Points or vectors to read, for example three arrays, or one array of (x, y, z).
typedef struct raycheck_array3 {
  const void *x, *y, *z;  ///< The coordinates of the first element.
  size_t count;           ///< The number of points or vectors; 1 stands for any number.
  ptrdiff_t stride;       ///< Bytes from one x to the next, likewise y and z; 0: no gaps.
  int32_t type;           ///< RAYCHECK_FLOAT64 or RAYCHECK_FLOAT32.
} raycheck_array3;

/// Where to write numbers: as many as there are answers. Floats are rounded from doubles: bounds
/// and upper ends upward, lower ends downward.
typedef struct raycheck_output {
  void* data;        ///< The first element; null: not wanted.
  size_t count;      ///< The number of elements.
  ptrdiff_t stride;  ///< As in raycheck_array.
  int32_t type;      ///< A raycheck_type; integers for classes and roots, and, of 32 or 64
                     ///< bits, for spheres and ties.
} raycheck_output;

/// Where to write points or vectors.
typedef struct raycheck_output3 {
  void *x, *y, *z;   ///< The coordinates of the first element; all null: not wanted.
  size_t count;      ///< The number of points or vectors.
  ptrdiff_t stride;  ///< As in raycheck_array3.
  int32_t type;      ///< RAYCHECK_FLOAT64 or RAYCHECK_FLOAT32.
} raycheck_output3;

/// Given rays; or, if `camera` is not null, the exact rays of a camera's pixels, with directions of
/// length 1, whose s is a length.
typedef struct raycheck_rays {
  raycheck_array3 origin, direction;  ///< Of given rays.
  const raycheck_camera* camera;      ///< Null: the rays are given.
  raycheck_array pixel_i, pixel_j;    ///< Integers. Without data: all pixels, row by row.
} raycheck_rays;

/// The spheres.
typedef struct raycheck_spheres {
  raycheck_array3 centre;  ///< Scene lengths.
  raycheck_array radius;   ///< Scene lengths, at least 0.
} raycheck_spheres;

/// Which ray is compared with which sphere: ray k with sphere k (one sphere: with it); or every ray
/// with every sphere, where the answers of sphere m are at m times the number of rays.
enum raycheck_pairing { RAYCHECK_EACH_WITH_ITS_OWN = 0, RAYCHECK_EACH_WITH_EVERY = 1 };

/// How to answer. All members may be 0, except `version`.
typedef struct raycheck_options {
  uint32_t version;             ///< RAYCHECK_BATCH_VERSION
  int32_t pairing;              ///< A raycheck_pairing; not used by nearest and image.
  int32_t threads;              ///< At most this many threads; 0 and 1: only the calling thread.
  const raycheck_asked* asked;  ///< The conventions and valid roots; null: the defaults.
} raycheck_options;

/// A ray's class with a sphere. Whether a tangent counts as a hit is up to the `tangent`
/// convention, which changes no class. Roots that are not valid do not count.
enum raycheck_class {
  RAYCHECK_MISS = 0,
  RAYCHECK_HIT = 1,
  RAYCHECK_TANGENT = 2,
  RAYCHECK_INVALID = 3
};

/// The answers of raycheck_decide().
typedef struct raycheck_decided {
  raycheck_output hit_class;     ///< A raycheck_class. Exact.
  raycheck_output root;          ///< Of hits and tangents: 0 is v - d, 1 is v + d. Exact.
  raycheck_output s;             ///< s, in multiples of the direction.
  raycheck_output3 point;        ///< Q
  raycheck_output s_error;       ///< A certified bound on |s - the exact s|.
  raycheck_output3 point_error;  ///< Certified bounds on the errors of Q's coordinates.
} raycheck_decided;

/// The answers of raycheck_nearest() and raycheck_image().
typedef struct raycheck_seen {
  raycheck_output sphere;   ///< The nearest sphere, of several the first; -1: none. Exact.
  raycheck_output ties;     ///< The number of spheres at exactly this s; 0: none. Exact.
  raycheck_output s;        ///< s
  raycheck_output3 point;   ///< Q
  raycheck_output s_error;  ///< A certified bound on |s - the exact s|.
} raycheck_seen;

/// Lower and upper ends: neighbouring doubles; or, if the number is within 2^-70 of itself of a
/// double, that double, perhaps with its neighbours. D and P have one answer for each ray.
typedef struct raycheck_enclosed {
  raycheck_output s_lower, s_upper;                       ///< s
  raycheck_output3 point_lower, point_upper;              ///< Q
  raycheck_output3 direction_lower, direction_upper;      ///< D, the direction of length 1.
  raycheck_output3 pixel_point_lower, pixel_point_upper;  ///< P; of a given ray, its origin.
} raycheck_enclosed;

/// Numbers, correctly rounded to the array's type (raycheck_round()), or their condition numbers
/// (raycheck_condition()), which are the same at x, y and z. D and P have one answer for each ray.
typedef struct raycheck_values {
  raycheck_output s;             ///< s
  raycheck_output3 point;        ///< Q
  raycheck_output3 direction;    ///< D, the direction of length 1.
  raycheck_output3 pixel_point;  ///< P; of a given ray, its origin.
} raycheck_values;

/// The answers that raycheck_error_of() judges. Those without data are not judged.
typedef struct raycheck_answers {
  raycheck_array is_hit;  ///< Integers; 0 is a miss. Required.
  raycheck_array s;       ///< s of hits. Excuses count roundings of its type, even without data.
  raycheck_array3 point;  ///< Q of hits.
} raycheck_answers;

/// The errors of answers.
typedef struct raycheck_errors {
  raycheck_output hit_class;  ///< 1: a miss is answered for a hit, or a hit for a miss; 0: right.
  raycheck_output root;       ///< 1: s is nearer to the other root (by raycheck's rule), and is not
                              ///< the rounded s; 0: not.
  raycheck_output excused;    ///< 1: a wrong class, but right for inputs a few roundings away.
  raycheck_output s_ulp;    ///< At least |s - exact s| / ulp(exact s); infinite if s is not finite.
  raycheck_output point_u;  ///< At least |Q - exact Q| / |exact Q|, in u = 2^-53 (floats: 2^-24).
} raycheck_errors;

/// Whether rays meet spheres, and where.
/// Shape:  N rays; one sphere, N or M spheres (raycheck_pairing) -> N or N M answers.
/// Domain: every finite double.
/// Error:  classes and roots are exact. s and Q of given rays are those of the method `robust`,
///         with bounds proved in docs/proofs.md; of cameras, and where not every root >= 0 counts,
///         they are correctly rounded.
RAYCHECK_API int32_t raycheck_decide(const raycheck_rays* rays, const raycheck_spheres* spheres,
                                     const raycheck_options* options, const raycheck_decided* to,
                                     raycheck_error* error);

/// The first sphere that each ray meets.
/// Shape:  N rays, M spheres -> N answers.
/// Domain: every finite double; fewer than 2^31 spheres.
/// Error:  spheres and ties are exact; s and Q are as of raycheck_decide().
RAYCHECK_API int32_t raycheck_nearest(const raycheck_rays* rays, const raycheck_spheres* spheres,
                                      const raycheck_options* options, const raycheck_seen* to,
                                      raycheck_error* error);

/// The first sphere at each pixel of a camera's image, row by row.
/// Shape:  a camera of N pixels, M spheres -> N answers.
/// Domain: at most 2^22 columns and rows, fewer than 2^31 spheres.
/// Error:  spheres and ties are exact. s and Q have few correct digits at silhouettes; s_error
///         bounds the error of s.
RAYCHECK_API int32_t raycheck_image(const raycheck_camera* camera, const raycheck_spheres* spheres,
                                    const raycheck_options* options, const raycheck_seen* to,
                                    raycheck_error* error);

/// The doubles around s, Q, D and P. Shape and domain: those of raycheck_decide().
RAYCHECK_API int32_t raycheck_enclose(const raycheck_rays* rays, const raycheck_spheres* spheres,
                                      const raycheck_options* options, const raycheck_enclosed* to,
                                      raycheck_error* error);

/// s, Q, D and P, correctly rounded (ties to even). Shape and domain: those of raycheck_decide().
RAYCHECK_API int32_t raycheck_round(const raycheck_rays* rays, const raycheck_spheres* spheres,
                                    const raycheck_options* options, const raycheck_values* to,
                                    raycheck_error* error);

/// The condition numbers of s, Q, D and P: upper bounds, too large by at most 0.1%. Shape and
/// domain: those of raycheck_decide().
RAYCHECK_API int32_t raycheck_condition(const raycheck_rays* rays, const raycheck_spheres* spheres,
                                        const raycheck_options* options, const raycheck_values* to,
                                        raycheck_error* error);

/// The errors of answers that were computed elsewhere: upper bounds, too large by at most 2^-12 of
/// the unit and 2^-16 of themselves. Shape and domain: those of raycheck_decide(). Errors are 0
/// where the answer or the truth is a miss.
RAYCHECK_API int32_t raycheck_error_of(const raycheck_rays* rays, const raycheck_spheres* spheres,
                                       const raycheck_options* options,
                                       const raycheck_answers* answers, const raycheck_errors* to,
                                       raycheck_error* error);

#ifdef __cplusplus
}
#endif

#endif /* RAYCHECK_BATCH_H_ */
