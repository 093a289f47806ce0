// The exact answers for the lecture's ray and sphere, and for hard rays and spheres.

#include <raycheck/cases.h>
#include <raycheck/exact.h>

#include <cinttypes>
#include <cstdio>
#include <cstring>

namespace exact = raycheck::exact;

static void print(const char* name, double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  std::printf("%s = %.17g (%016" PRIx64 ")\n", name, value, bits);
}

static void print(const char* name, const exact::Number& number) {
  print(name, number.rounded());
  std::printf("  exactly %s\n  in %s, condition %.3g\n", number.closed_form().c_str(),
              number.enclosure(100).c_str(), number.condition());
}

int main() {
  const raycheck::Ray ray{{1, 2, 3}, {2, -1, 3}};
  const raycheck::Sphere sphere{{8, 0, 13}, 3};
  const exact::Intersection met = exact::hit(ray, sphere);
  std::printf("%s\n", met.is_hit ? "hit" : "no hit");
  if (met.parameter) print("s", *met.parameter);
  if (met.point) print("Q.x", met.point->x);
  print("error of 3.0", met.parameter->ulp_error(3.0));

  raycheck::Camera camera;
  camera.eye = {8, 8, 100};
  camera.look_at = {8, 8, 54};
  camera.up = {0, 1, 0};
  camera.near_plane = -30;
  camera.left = camera.bottom = -20;
  camera.right = camera.top = 20;
  camera.width = camera.height = 16;
  const exact::Camera known(camera);
  print("P.x", known.pixel_point({3, 5}).x);
  print("D.x", known.ray({3, 5}).direction().x);
  const auto nearest = known.ray({8, 8}).nearest({{{8, 8, 54}, 12}, {{8, 8, 60}, 3}});
  if (nearest) std::printf("sphere %zu\n", nearest->index);

  // A hash of all decisions and rounded values for near-tangents of every severity.
  std::uint64_t hash = 0;
  const auto add = [&hash](double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    hash = (hash ^ bits) * 1099511628211U;
  };
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const raycheck::Case one = raycheck::make_case("tangent-ulps", 1, k, static_cast<int>(k % 54));
    for (const raycheck::Ray& ray : one.scene.rays) {
      for (const raycheck::Sphere& its : one.scene.spheres) {
        const exact::Intersection at = exact::hit(ray, its);
        add(static_cast<double>(at.hit_class));
        if (at.parameter) add(at.parameter->rounded());
      }
    }
  }
  std::printf("1000 near-tangents: %016" PRIx64 "\n", hash);
  return 0;
}
