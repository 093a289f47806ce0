// Certificates of critical decisions that are wrong on purpose. tools/verify_certificates.py
// confirms the witness of each excused decision, and proves again for each defect that no nearby
// inputs excuse it. RAYCHECK_DECISIONS sets the number of decisions of each kind.

#include "properties/candidates/fast_candidate.h"
#include "properties/laws/law.h"
#include "tests/reference/random_cases.h"
#include "tests/tools/report/certificates.h"
#include "tools/report/certificate.h"

namespace raycheck::tools {
namespace {

using namespace properties;
using namespace reference;
using scene::Sphere;

std::size_t wanted() {
  const char* const given = std::getenv("RAYCHECK_DECISIONS");
  constexpr std::size_t kDefault = 100;
  return given == nullptr ? kDefault : std::strtoul(given, nullptr, 10);
}

scene::Conventions any_conventions(Random& random) {
  scene::Conventions conventions = reference::random_conventions(random);
  if (random.one_in(2)) conventions.root = scene::Root::kSmaller;
  conventions.tangent = random.one_in(2)   ? scene::Tangent::kHit
                        : random.one_in(2) ? scene::Tangent::kMiss
                                           : scene::Tangent::kEither;
  return conventions;
}

/// A sphere that the ray almost touches, or on whose surface it almost starts.
Sphere critical_sphere(Random& random, const ExactRay& ray) {
  Sphere sphere = reference::random_sphere(random, Sizes::kOrdinary);
  const auto enclosed = ray.enclose(128);
  const double impact_sq = sphere.radius * sphere.radius - enclosed.half_chord_sq(sphere).upper();
  const double v = enclosed.axial_distance(sphere).upper();
  const double distance_sq = random.one_in(2) ? impact_sq : impact_sq + v * v;
  sphere.radius = reference::nudged(std::sqrt(std::max(0.0, distance_sq)), random.integer(-40, 40));
  return sphere;
}

/// A sphere nearly ahead of a ray, so far away that a change of the inputs moves it by about its
/// radius.
Sphere far_sphere(Random& random, const ExactRay& ray, double change) {
  Sphere sphere;
  sphere.radius = random.between(0.1, 10);
  const double distance = sphere.radius / change * random.between(0.2, 5);
  const scene::Point3 from = ray.rounded_origin();
  const scene::UnitVector3 along = ray.rounded_direction();
  const auto aside = [&] { return random.between(-1, 1) * sphere.radius; };
  sphere.centre.x = from.x + distance * along.x + aside();
  sphere.centre.y = from.y + distance * along.y + aside();
  sphere.centre.z = from.z + distance * along.z + aside();
  return sphere;
}

/// A wrong answer: the opposite of a decision, or an answer close to that.
std::optional<double> wrong_answer(Random& random, const ExactRay& ray, const Sphere& sphere,
                                   const scene::Conventions& conventions) {
  const Intersection at = ray.intersect(sphere, conventions.root);
  double s = 0;
  if (!counts_as_hit(at.hit_class, conventions.tangent)) {
    const auto enclosed = ray.enclose(128);
    const bool is_camera = ray.source().camera != nullptr;
    s = enclosed.axial_distance(sphere).upper() / (is_camera ? 1 : enclosed.length().upper());
    if (random.one_in(4)) s = 0;
  } else {
    if (random.one_in(2)) return std::nullopt;
    const bool is_smaller = at.root == WhichRoot::kSmaller;
    s = ray.rounded_parameter(
        sphere, {at.hit_class, is_smaller ? WhichRoot::kLarger : WhichRoot::kSmaller});
  }
  if (random.one_in(3)) s = reference::nudged(s, random.integer(-40, 40));
  return std::max(0.0, s);
}

/// Spheres that the ray meets nearly at the same s, or nearly touches.
std::vector<Sphere> contending_spheres(Random& random, const ExactRay& ray) {
  const scene::Point3 from = ray.rounded_origin();
  const scene::UnitVector3 along = ray.rounded_direction();
  const double s = random.between(0, 5);
  std::vector<Sphere> spheres;
  const auto count = static_cast<std::size_t>(random.integer(2, 4));
  while (spheres.size() < count) {
    Sphere sphere = critical_sphere(random, ray);
    if (!random.one_in(4)) {
      const auto& c = sphere.centre;
      const double radius = std::hypot(from.x + s * along.x - c.x, from.y + s * along.y - c.y,
                                       from.z + s * along.z - c.z);
      sphere.radius = reference::nudged(radius, random.integer(-40, 40));
    }
    if (scene::defects(sphere).empty()) spheres.push_back(sphere);
  }
  return spheres;
}

Candidate that_sees(const std::optional<std::size_t>& sphere) {
  Candidate candidate = properties::fast_candidate(fast::kDirectRays, fast::kCross);
  candidate.nearest = [sphere](Candidate::Rays rays, Candidate::Spheres /*spheres*/,
                               const scene::Conventions& /*conventions*/) {
    return std::vector(rays.size(), sphere);
  };
  return candidate;
}

Candidate that_answers(const std::optional<double>& s) {
  Candidate candidate = properties::fast_candidate(fast::kDirectRays, fast::kCross);
  candidate.nearest = nullptr;
  candidate.intersect = [s](Candidate::Rays rays, Candidate::Spheres spheres,
                            const scene::Conventions& /*conventions*/) {
    properties::SphereHits hits;
    for (std::size_t k = 0; s && k < rays.size(); ++k) hits.push_back({k, HitAnswer{*s, {}}});
    return std::vector(spheres.size(), hits);
  };
  return candidate;
}

/// Certificates of the wrong decisions of a case, by their standing.
struct Certified {
  std::vector<Json> excused, defects;
  std::size_t undecided = 0;

  void add(const Case& the_case, const Candidate& candidate) {
    properties::Trial trial(the_case, candidate);
    for (const char* law : {"class", "nearest-root", "nearest-sphere"}) {
      if (!candidate.nearest && law == std::string("nearest-sphere")) continue;
      for (const Discrepancy& d : apply(*properties::find_law(law), trial).worst(1)) {
        const Json one = certificate(the_case.scene, trial.conventions(), d, "wrong on purpose");
        switch (d.excuse.standing()) {
          case properties::Standing::kExcused:
            excused.push_back(one);
            break;
          case properties::Standing::kDefect:
            defects.push_back(one);
            break;
          default:
            ++undecided;
        }
      }
    }
  }
};

Case any_case(Random& random, bool has_camera) {
  Case result;
  result.scene.conventions = any_conventions(random);
  if (has_camera) {
    result.scene.camera = reference::random_camera(random, Sizes::kOrdinary);
    result.pixels = {reference::random_pixel(random, *result.scene.camera)};
  } else {
    const Sizes sizes = random.one_in(4) ? Sizes::kSmallIntegers : Sizes::kOrdinary;
    result.scene.rays = {reference::random_ray(random, sizes)};
  }
  return result;
}

ExactRay ray_of(const Case& the_case) {
  const scene::Scene& scene = the_case.scene;
  if (!scene.camera) return ExactRay(scene.rays.front());
  return {reference::ExactCamera(*scene.camera, scene.conventions), the_case.pixels.front()};
}

enum class Kind { kGiven, kFar, kCamera, kChoice };

Certified critical_decisions(Kind kind, std::size_t of_each) {
  Random random(static_cast<std::uint64_t>(kind) + 1);
  Certified certified;
  for (std::size_t k = 0; k < 100 * of_each; ++k) {
    Case the_case =
        any_case(random, kind == Kind::kCamera || (kind == Kind::kChoice && random.one_in(2)));
    const ExactRay ray = ray_of(the_case);
    if (kind == Kind::kChoice) {
      auto& spheres = the_case.scene.spheres = contending_spheres(random, ray);
      const auto last = static_cast<std::int64_t>(spheres.size()) - 1;
      const auto seen = static_cast<std::size_t>(random.integer(0, last));
      certified.add(the_case, that_sees(random.one_in(4) ? std::nullopt : std::optional(seen)));
      if (certified.excused.size() >= of_each) break;
      continue;
    }
    // Far spheres are judged in single precision, too.
    const double roundoff = kind == Kind::kFar && random.one_in(2) ? 0x1p-24 : 0x1p-53;
    const Sphere sphere =
        kind == Kind::kFar ? far_sphere(random, ray, 16 * roundoff) : critical_sphere(random, ray);
    if (!scene::defects(sphere).empty()) continue;
    the_case.scene.spheres = {sphere};
    const auto answer = wrong_answer(random, ray, sphere, the_case.scene.conventions);
    Candidate candidate = that_answers(answer);
    candidate.unit_roundoff = roundoff;
    certified.add(the_case, candidate);
    if (certified.excused.size() >= of_each && certified.defects.size() >= of_each) break;
  }
  if (certified.excused.size() > of_each) certified.excused.resize(of_each);
  if (certified.defects.size() > of_each) certified.defects.resize(of_each);
  return certified;
}

/// Expects that certificates are confirmed, with these verdicts.
void expect_confirmed(const std::vector<Json>& certificates, const std::string& standing) {
  const std::vector<std::string> lines = tests::script_lines(certificates);
  for (std::size_t k = 0; k < certificates.size() && k < lines.size(); ++k) {
    EXPECT_EQ(lines[k].rfind("confirmed", 0), 0u) << lines[k] << "\n" << certificates[k];
    EXPECT_TRUE(has(lines[k], "; " + standing)) << certificates[k];
  }
}

void expect_excused_or_defects_for_anyone(Kind kind, std::size_t of_each) {
  Certified certified = critical_decisions(kind, of_each);
  ASSERT_EQ(certified.excused.size(), of_each);
  expect_confirmed(certified.excused, "right for its witness");
  if (kind == Kind::kChoice) return;
  ASSERT_EQ(certified.defects.size(), of_each);
  EXPECT_TRUE(kind != Kind::kGiven || certified.undecided == 0);
  expect_confirmed(certified.defects, "proved wrong for all inputs nearby");
  // Certificates that claim that excused decisions are defects are not confirmed.
  for (Json& one : certified.excused) one["excuse"] = nullptr;
  expect_confirmed(certified.excused, "not proved wrong for all inputs nearby");
}

TEST(CertifiedDecisions, OfGivenRaysAreIndependentlyConfirmed) {
  expect_excused_or_defects_for_anyone(Kind::kGiven, wanted());
}

TEST(CertifiedDecisions, OfSpheresAtTheLimitOfChangesAreIndependentlyConfirmed) {
  expect_excused_or_defects_for_anyone(Kind::kFar, wanted() / 5);
}

TEST(CertifiedDecisions, BetweenSpheresHaveConfirmedWitnesses) {
  expect_excused_or_defects_for_anyone(Kind::kChoice, wanted() / 5);
}

TEST(CertifiedDecisions, OfCamerasAreIndependentlyConfirmed) {
  expect_excused_or_defects_for_anyone(Kind::kCamera, wanted() / 10);
}

}  // namespace
}  // namespace raycheck::tools
