#include "casting.h"

void viewing_ray(const Camera& camera, int i, int j, int width, int height, Ray& ray) {
  const double x = camera.width * (i + 0.5) / width - camera.width / 2;
  const double y = camera.height / 2 - camera.height * (j + 0.5) / height;
  ray = {camera.eye, {x, y, -camera.distance}};
}
