#ifndef RAYCHECK_RAPIDCHECK_H_
#define RAYCHECK_RAPIDCHECK_H_

// raycheck's rays, spheres, cameras and scenes for RapidCheck, shrunk by raycheck:
//
//     #include <raycheck/rapidcheck.h>
//     rc::check([](const raycheck::RaySphere& pair) { RC_ASSERT(...); });
//     rc::check([] {
//       const auto scene = *raycheck::gen::scene("tangent-ulps");
//       ...
//     });
//
// A failing case is shown as a scene file with the same numbers to the bit. C++17; link
// raycheck::rapidcheck.

#include <rapidcheck.h>
#include <raycheck/cases.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace raycheck {

/// A ray and a sphere that it may meet.
struct RaySphere {
  Ray ray;        ///< The length of its direction is arbitrary.
  Sphere sphere;  ///< The ray may meet or miss it.
};

namespace gen {

/// Cases of a source; severity -1: any of its severities. Errors: making a case with an unknown
/// source or severity throws std::invalid_argument; the generators below throw the same.
inline rc::Gen<Case> from(const std::string& source, int severity = -1) {
  const std::vector<Source> all = sources();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Source& one) { return one.name == source; });
  const int highest = severity >= 0 || found == all.end() ? severity : found->highest;
  const int lowest = severity >= 0 ? severity : 0;
  return [=](const rc::Random& random, int) {
    rc::Random stream = random;
    const auto among = static_cast<std::uint64_t>(highest - lowest + 1);
    const int chosen = lowest + static_cast<int>(stream.next() % (among == 0 ? 1 : among));
    return rc::shrinkable::shrinkRecur(
        make_case(source, stream.next(), 0, chosen),
        [](const Case& one) { return rc::seq::fromContainer(simpler(one)); });
  };
}

/// Scenes of a source.
inline rc::Gen<Scene> scene(const std::string& source = "cameras", int severity = -1) {
  return rc::gen::map(from(source, severity), [](Case made) { return std::move(made.scene); });
}

/// The first ray and the first sphere of a source's cases: far spheres ("distance"), origins inside
/// ("inside"). Domain: a source of given rays.
inline rc::Gen<RaySphere> ray_and_sphere(const std::string& source = "rays", int severity = -1) {
  return rc::gen::map(
      rc::gen::suchThat(
          from(source, severity),
          [](const Case& made) { return !made.scene.rays.empty() && !made.scene.spheres.empty(); }),
      [](const Case& made) {
        return RaySphere{made.scene.rays.front(), made.scene.spheres.front()};
      });
}

/// Rays that touch a sphere, or miss touching it by 2^(52 - severity) ulps of the radius.
inline rc::Gen<RaySphere> near_tangent(int severity = -1) {
  return ray_and_sphere("tangent-ulps", severity);
}

/// Scenes where a ray meets several spheres at equal or nearly equal parameters.
inline rc::Gen<Scene> tie(int severity = -1) { return scene("coincident", severity); }

}  // namespace gen

/// Shows a case to RapidCheck: as a scene file.
inline void showValue(const Case& one, std::ostream& out) { out << scene_text(one); }
/// Shows a scene to RapidCheck.
inline void showValue(const Scene& one, std::ostream& out) { out << scene_text({one, {}}); }
/// Shows a ray and a sphere to RapidCheck: as a scene of the two.
inline void showValue(const RaySphere& one, std::ostream& out) {
  Scene scene;
  scene.rays = {one.ray};
  scene.spheres = {one.sphere};
  showValue(scene, out);
}

}  // namespace raycheck

namespace rc {

template <>
struct Arbitrary<raycheck::Case> {
  static Gen<raycheck::Case> arbitrary() { return raycheck::gen::from("cameras"); }
};
template <>
struct Arbitrary<raycheck::Scene> {
  static Gen<raycheck::Scene> arbitrary() { return raycheck::gen::scene(); }
};
template <>
struct Arbitrary<raycheck::RaySphere> {
  static Gen<raycheck::RaySphere> arbitrary() { return raycheck::gen::ray_and_sphere(); }
};
template <>
struct Arbitrary<raycheck::Ray> {
  static Gen<raycheck::Ray> arbitrary() {
    return gen::map(raycheck::gen::ray_and_sphere(),
                    [](const raycheck::RaySphere& pair) { return pair.ray; });
  }
};
template <>
struct Arbitrary<raycheck::Sphere> {
  static Gen<raycheck::Sphere> arbitrary() {
    return gen::map(raycheck::gen::ray_and_sphere(),
                    [](const raycheck::RaySphere& pair) { return pair.sphere; });
  }
};
template <>
struct Arbitrary<raycheck::Camera> {
  static Gen<raycheck::Camera> arbitrary() {
    return gen::map(raycheck::gen::scene(),
                    [](const raycheck::Scene& scene) { return *scene.camera; });
  }
};

}  // namespace rc

#endif  // RAYCHECK_RAPIDCHECK_H_
