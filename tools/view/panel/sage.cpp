#include <fmt/core.h>

#include <cmath>
#include <cstdint>

#include "tools/view/panel/panel.h"

namespace raycheck::tools {
namespace {

/// A finite double as a rational: "8", "-3/2^1", "5*2^60".
std::string rational(double value) {
  if (value == 0) return "0";
  int exponent = 0;
  double mantissa = std::frexp(value, &exponent);
  while (mantissa != std::trunc(mantissa)) {
    mantissa *= 2;
    --exponent;
  }
  const auto whole = static_cast<std::int64_t>(mantissa);
  if (exponent == 0) return fmt::format("{}", whole);
  constexpr int kMostDigits = 53;  // Of whole numbers that are written out.
  if (exponent > 0 && std::abs(value) < std::ldexp(1.0, kMostDigits)) {
    return fmt::format("{}", static_cast<std::int64_t>(value));
  }
  return exponent > 0 ? fmt::format("{}*2^{}", whole, exponent)
                      : fmt::format("{}/2^{}", whole, -exponent);
}

template <class Triple>
std::string vector(const Triple& v) {
  return fmt::format("vector([{}, {}, {}])", rational(v.x), rational(v.y), rational(v.z));
}

std::string camera_input(const scene::Scene& scene, const scene::Pixel& pixel) {
  const scene::Camera& camera = *scene.camera;
  const scene::Conventions& conventions = scene.conventions;
  const bool centres = conventions.samples == scene::Samples::kCentres;
  const bool top_first = conventions.rows == scene::Rows::kTopFirst;
  std::string text;
  text += fmt::format("E = {}; A = {}; up = {}\n", vector(camera.eye), vector(camera.look_at),
                      vector(camera.up));
  text += fmt::format("n = {}; left = {}; right = {}; bottom = {}; top = {}\n",
                      rational(camera.near), rational(camera.left), rational(camera.right),
                      rational(camera.bottom), rational(camera.top));
  text += fmt::format("w = {}; h = {}; i = {}; j = {}\n", camera.width, camera.height, pixel.i,
                      pixel.j);
  text += "W = (E - A)/(E - A).norm()\n";
  text += "U = up.cross_product(W); U = U/U.norm(); V = W.cross_product(U)\n";
  text += centres ? "alpha = left + (i + 1/2)/w*(right - left)\n"
                  : "alpha = left + i/(w - 1)*(right - left)\n";
  const char* const from = top_first ? "top" : "bottom";
  const char* const to = top_first ? "bottom" : "top";
  text += fmt::format("beta = {0} + {2}*({1} - {0})\n", from, to,
                      centres ? "(j + 1/2)/h" : "j/(h - 1)");
  text += "P = E + n*W + alpha*U + beta*V; D = (P - E)/(P - E).norm()\n";
  text +=
      conventions.origin == scene::Origin::kPixel ? "L = P; length = 1\n" : "L = E; length = 1\n";
  return text;
}

}  // namespace

std::string sage_input(const ExplainReport& report) {
  std::string text;
  if (report.pixel) {
    text = camera_input(report.scene, *report.pixel);
  } else {
    text = fmt::format("L = {}; direction = {}\n", vector(report.ray.origin),
                       vector(report.ray.direction));
    text += "length = direction.norm(); D = direction/length\n";
  }
  if (!report.sphere) return text + "show([D])\n";
  const scene::Sphere& sphere = report.scene.spheres[*report.sphere];
  text += fmt::format("C = {}; r = {}\n", vector(sphere.centre), rational(sphere.radius));
  text += "T = C - L; v = T.dot_product(D); d2 = r^2 - (T.dot_product(T) - v^2)\n";
  const SphereReport& exact = report.spheres[*report.sphere];
  if (!exact.parameter) return text + "show([D, T, v, d2])\n";
  const bool smaller = exact.intersection.root == reference::WhichRoot::kSmaller;
  text += fmt::format("s = (v {} sqrt(d2))/length; Q = L + s*length*D\n", smaller ? "-" : "+");
  return text + "show([D, T, v, d2, s, Q])\n";
}

}  // namespace raycheck::tools
