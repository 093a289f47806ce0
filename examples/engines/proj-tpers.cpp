// PROJ's tilted perspective, +proj=tpers, from the plane to the sphere (proj_trans, PJ_INV): the
// point of the unit sphere that is seen from the height +h above +lat_0, +lon_0, looking at the
// centre, with the azimuth +azi up. The plane touches the sphere below the eye; its unit is the
// radius, +R. Debian: libproj-dev; -lproj. Source: https://proj.org, "Tilted perspective"; its
// errors are not documented. Points beside the globe are errors,
// and so are eyes on it.

#include <proj.h>

#include <cmath>
#include <cstdio>

#include "adapter.h"

using namespace raycheck;

static constexpr double kDegrees = 180 / M_PI;

static std::optional<Hit> pick(const Camera& camera, const Conventions&, Pixel pixel,
                               const Sphere&) {
  const Vector e = camera.eye, up = camera.up;
  const double across = std::hypot(e.x, e.y), distance = std::hypot(e.x, e.y, e.z);
  const double lat = std::atan2(e.z, across), lon = std::atan2(e.y, e.x), h = distance - 1;
  if (!(h > 0)) return std::nullopt;
  const Vector east = {-std::sin(lon), std::cos(lon), 0};
  const Vector north = {-std::sin(lat) * std::cos(lon), -std::sin(lat) * std::sin(lon),
                        std::cos(lat)};
  const double azimuth = std::atan2(dot(up, east), dot(up, north));
  char text[256];
  std::snprintf(text, sizeof text,
                "+proj=tpers +R=1 +tilt=0 +azi=%.17g +h=%.17g +lat_0=%.17g +lon_0=%.17g",
                azimuth * kDegrees, h, lat * kDegrees, lon * kDegrees);
  PJ* const projection = proj_create(nullptr, text);
  if (projection == nullptr) return std::nullopt;
  const double near = -camera.near_plane, i = static_cast<double>(pixel.i) + 0.5,
               j = static_cast<double>(pixel.j) + 0.5;
  const double x = camera.left + i / static_cast<double>(camera.width) * 2 * camera.right;
  const double y = camera.bottom + j / static_cast<double>(camera.height) * 2 * camera.top;
  const PJ_COORD found =
      proj_trans(projection, PJ_INV, proj_coord(x / near * h, y / near * h, 0, 0));
  proj_destroy(projection);
  if (found.lp.lam == HUGE_VAL) return std::nullopt;
  const double cos_phi = std::cos(found.lp.phi);
  return Hit{.point = {cos_phi * std::cos(found.lp.lam), cos_phi * std::sin(found.lp.lam),
                       std::sin(found.lp.phi)}};
}

RAYCHECK_CANDIDATE(.rows = Rows::bottom_first, .samples = Samples::centres, .origin = Origin::focal,
                   .root = Root::smaller, .tangent = Tangent::either, .pick = pick,
                   .level = Level::ordinary, .returns = Returns::point,
                   .contract = "placement unit; view centre; windows symmetric")
