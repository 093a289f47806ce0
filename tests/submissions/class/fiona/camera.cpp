#include "camera.h"

ray camera::shoot(int i, int j) const {
  vec3 w = normalize(eye - look);
  vec3 u = normalize(cross(up, w));
  vec3 v = cross(w, u);
  double alpha = left + (double)i / width * (right - left);
  double beta = bottom + (double)j / height * (top - bottom);
  vec3 pixel = eye - w * d + u * alpha + v * beta;
  return {eye, normalize(pixel - eye)};
}
