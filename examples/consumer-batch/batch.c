/* A million rays in C: what they meet, with certified errors; and how wrong the textbook's formula
   in doubles is on them. */

#include <math.h>
#include <raycheck/batch.h>
#include <stdio.h>
#include <stdlib.h>

enum { COUNT = 1000000 };
typedef struct vector {
  double x, y, z;
} vector;

static vector origins[COUNT], directions[COUNT];
static uint8_t classes[COUNT], hits[COUNT], wrong[COUNT], excused[COUNT];
static double s[COUNT], bounds[COUNT], textbook[COUNT], errors[COUNT];
static const vector centre = {0.5, -0.25, 1000};
static const double radius = 1;

static double dot(vector a, vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static void require(int32_t code, const raycheck_error* error) {
  if (code == RAYCHECK_OK) return;
  fprintf(stderr, "%s[%zu]: %s\n", error->array, error->index, error->reason);
  exit(1);
}

int main(void) {
  uint64_t state = 1;
  for (size_t k = 0; k < COUNT; ++k) {
    double random[2];
    for (int j = 0; j < 2; ++j) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      random[j] = (double)(state >> 11) * 0x1p-53 - 0.5;
    }
    directions[k] = (vector){0.5 + 2.5 * random[0], -0.25 + 2.5 * random[1], 1000};
    const vector T = centre; /* the origin is 0 */
    const double a = dot(directions[k], directions[k]), b = dot(T, directions[k]);
    const double discriminant = b * b - a * (dot(T, T) - radius * radius);
    hits[k] = discriminant >= 0;
    textbook[k] = (b - sqrt(discriminant)) / a;
  }

  const raycheck_rays rays = {
      .origin = {&origins->x, &origins->y, &origins->z, COUNT, sizeof(vector), RAYCHECK_FLOAT64},
      .direction = {&directions->x, &directions->y, &directions->z, COUNT, sizeof(vector),
                    RAYCHECK_FLOAT64}};
  const raycheck_spheres sphere = {.centre = {&centre.x, &centre.y, &centre.z, 1},
                                   .radius = {&radius, 1}};
  const raycheck_options options = {.version = RAYCHECK_BATCH_VERSION, .threads = 2};
  raycheck_error error;
  const raycheck_decided decided = {.hit_class = {classes, COUNT, 0, RAYCHECK_UINT8},
                                    .s = {s, COUNT},
                                    .s_error = {bounds, COUNT}};
  require(raycheck_decide(&rays, &sphere, &options, &decided, &error), &error);
  const raycheck_answers answers = {.is_hit = {hits, COUNT, 0, RAYCHECK_UINT8},
                                    .s = {textbook, COUNT}};
  const raycheck_errors judged = {.hit_class = {wrong, COUNT, 0, RAYCHECK_UINT8},
                                  .excused = {excused, COUNT, 0, RAYCHECK_UINT8},
                                  .s_ulp = {errors, COUNT}};
  require(raycheck_error_of(&rays, &sphere, &options, &answers, &judged, &error), &error);

  size_t met = 0, wrong_classes = 0, excuses = 0;
  double widest = 0, worst = 0;
  for (size_t k = 0; k < COUNT; ++k) {
    met += classes[k] != RAYCHECK_MISS;
    wrong_classes += wrong[k];
    excuses += excused[k];
    if (bounds[k] > widest) widest = bounds[k];
    if (errors[k] > worst) worst = errors[k];
  }
  printf("%zu of %d rays hit; s is certain to %.2g\n", met, COUNT, widest);
  printf("the textbook: %zu wrong classes, %zu of them excused; s is off by up to %.0f ulp\n",
         wrong_classes, excuses, worst);

  directions[123456].y = NAN;
  const int32_t code = raycheck_decide(&rays, &sphere, &options, &decided, &error);
  printf("%d: %s[%zu]: %s\n", (int)code, error.array, error.index, error.reason);
  return 0;
}
