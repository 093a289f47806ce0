// g++ case.cpp -lproj -o case
// The unit sphere, seen by a camera that looks at its centre.
#include <proj.h>
#include <cmath>
#include <cstdio>
int main() {
  const double degrees = 180 / M_PI, across = std::hypot({ex}, {ey}), h = std::hypot({ex}, {ey}, {ez}) - 1;
  const double lat = std::atan2({ez}, across), lon = std::atan2({ey}, {ex});
  const double east = {uy} * std::cos(lon) - {ux} * std::sin(lon);
  const double north = {uz} * std::cos(lat) - std::sin(lat) * ({ux} * std::cos(lon) + {uy} * std::sin(lon));
  char text[256];
  std::snprintf(text, sizeof text, "+proj=tpers +R=1 +tilt=0 +azi=%.17g +h=%.17g +lat_0=%.17g +lon_0=%.17g",
                std::atan2(east, north) * degrees, h, lat * degrees, lon * degrees);
  const double x = {left} + ({i} + 0.5) / {width} * 2 * {right}, y = {bottom} + ({j} + 0.5) / {height} * 2 * {top};
  const PJ_COORD at = proj_trans(proj_create(nullptr, text), PJ_INV, proj_coord(x / {near} * h, y / {near} * h, 0, 0));
  const double lambda = at.lp.lam, phi = at.lp.phi;
  if (lambda == HUGE_VAL) return !std::puts("miss");
  std::printf("%.17g %.17g %.17g\n", std::cos(phi) * std::cos(lambda), std::cos(phi) * std::sin(lambda), std::sin(phi));
}
