// Instructive cases: each file of tests/regressions/ is judged by every law. The exact answers here
// were computed independently of this project, with rational arithmetic.

#include <regex>

#include "properties/candidates/fast_candidate.h"
#include "properties/laws/law.h"
#include "scene/files/scene_file.h"
#include "tests/names.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

using reference::HitClass;

std::filesystem::path folder() {
  return std::filesystem::path(RAYCHECK_SOURCE_DIR) / "tests" / "regressions";
}

Case load(const std::string& stem) {
  Case result{scene::load_scene(folder() / (stem + ".toml")).scene, {}};
  if (result.scene.camera) result.pixels = all_pixels(*result.scene.camera);
  return result;
}

/// The exact answer for a file's first ray and first sphere.
struct Exact {
  HitClass hit_class;
  double s = 0;
};
const std::map<std::string, Exact> kExact = {
    {"axial-distance-minus-zero", {HitClass::kMiss}},
    {"exact-tie", {HitClass::kHit, 4}},
    {"far-point-textbook-finds-a-hit", {HitClass::kMiss}},
    {"far-sphere-textbook-loses-digits", {HitClass::kHit, 0x1.d9d3a802e8f76p+14}},
    {"far-sphere-lecture-misses", {HitClass::kHit, 9999999.9687750097}},
    {"grazing-345-exact", {HitClass::kTangent, 2}},
    {"grazing-345-rounded", {HitClass::kHit, 0x1.3fffffdc3910dp+3}},
    {"nearest-by-one-ulp", {HitClass::kHit, 4}},
    {"origin-at-centre", {HitClass::kHit, 1}},
    {"origin-inside", {HitClass::kHit, 0.8660254037844386}},
    {"origin-on-surface", {HitClass::kHit, 0}},
    {"origin-on-surface-leaving", {HitClass::kHit, 0}},
    {"planet-horizon", {HitClass::kHit, 4654.1799293292679}},
    {"planet-horizon-one-ulp-flatter", {HitClass::kMiss}},
    {"scale-1e160", {HitClass::kHit, 4.0460607985830547e160}},
    {"scale-subnormal", {HitClass::kHit, 0x0.0000000010208p-1022}},
    {"sphere-one-ulp-behind", {HitClass::kMiss}},
    {"tangent", {HitClass::kTangent, 5}},
    {"tangent-one-ulp-inside", {HitClass::kHit, 4.9999999850988388}},
    {"tangent-one-ulp-outside", {HitClass::kMiss}}};

/// Candidates, and the laws that each breaks by file; on all other files it breaks no law.
using Broken = std::map<std::string, std::set<std::string>>;
const std::set<std::string> kOfHits = {"backward-error", "hit-point", "parameter"};
const std::map<std::string, Broken> kBroken = {
    {"direct/cross", {}},
    {"direct/perpendicular", {}},
    {"focal/cross", {}},
    {"lecture/cross", {{"far-eye-lecture-loses-directions", {"direction"}}}},
    {"direct/lecture",
     {{"far-sphere-lecture-misses", {"class", "exchange"}},
      {"far-sphere-textbook-loses-digits", {"hit-point"}}}},
    {"direct/quadratic",
     {{"far-point-textbook-finds-a-hit", {"class", "exchange"}},
      {"far-sphere-lecture-misses", kOfHits},
      {"far-sphere-textbook-loses-digits", kOfHits}}},
    {"direct/stable-quadratic",
     {{"far-point-textbook-finds-a-hit", {"class", "exchange"}},
      {"far-sphere-lecture-misses", kOfHits},
      {"far-sphere-textbook-loses-digits", kOfHits}}}};

std::vector<std::string> stems() {
  std::vector<std::string> result;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    if (entry.path().extension() == ".toml") result.push_back(entry.path().stem().string());
  }
  std::sort(result.begin(), result.end());
  return result;
}

Candidate candidate_named(const std::string& name) {
  for (const fast::PixelRayMethod* rays : fast::pixel_ray_methods()) {
    for (const fast::IntersectMethod* intersect : fast::intersect_methods()) {
      Candidate candidate = fast_candidate(*rays, *intersect);
      if (candidate.name == name) return candidate;
    }
  }
  throw std::invalid_argument("no candidate is called " + name);
}

/// The inputs on which the method of this name exceeds its bound.
template <class Methods>
std::string_view not_kept_by(const Methods& methods, const std::string& name) {
  const auto method = std::find_if(methods.begin(), methods.end(),
                                   [&](const auto* one) { return one->name == name; });
  return method == methods.end() ? throw std::invalid_argument(name) : (*method)->not_kept;
}

std::set<std::string> broken_laws(const Case& the_case, const Candidate& candidate) {
  std::set<std::string> broken;
  Trial trial(the_case, candidate);
  for (const Law& law : laws()) {
    if (!apply(law, trial).holds()) broken.emplace(law.name);
  }
  return broken;
}

TEST(Regressions, HaveCommentsThatSayWhyTheyAreHard) {
  EXPECT_GE(stems().size(), 20u);
  for (const std::string& stem : stems()) {
    const std::string text = contents(folder() / (stem + ".toml"));
    EXPECT_EQ(text.substr(0, 2), "# ") << stem;
    EXPECT_GT(text.find('\n'), 30u) << stem;
  }
}

TEST(Regressions, HaveTheExactAnswersOfAnIndependentComputation) {
  const Candidate none;
  std::size_t rays = 0;
  for (const std::string& stem : stems()) {
    const Case the_case = load(stem);
    if (the_case.scene.camera) continue;
    ++rays;
    ASSERT_TRUE(kExact.contains(stem)) << stem;
    const Exact& expected = kExact.at(stem);
    Trial trial(the_case, none);
    const reference::Intersection& got = trial.exact_intersection(0, 0);
    EXPECT_EQ(got.hit_class, expected.hit_class) << stem;
    if (got.hit_class == HitClass::kMiss) continue;
    EXPECT_EQ(trial.exact_ray(0).rounded_parameter(the_case.scene.spheres[0], got), expected.s)
        << stem;
  }
  EXPECT_EQ(rays, kExact.size());
}

TEST(Regressions, CatchExactlyTheListedMethods) {
  for (const auto& [name, broken] : kBroken) {
    const Candidate candidate = candidate_named(name);
    for (const std::string& stem : stems()) {
      const auto expected = broken.find(stem);
      EXPECT_EQ(broken_laws(load(stem), candidate),
                expected == broken.end() ? std::set<std::string>() : expected->second)
          << name << " on " << stem;
    }
  }
}

TEST(Regressions, FindEitherOfTwoEqualSpheres) {
  const Case the_case = load("exact-tie");
  const Candidate none;
  Trial trial(the_case, none);
  const auto nearest =
      trial.exact_ray(0).nearest(the_case.scene.spheres, the_case.scene.conventions);
  ASSERT_TRUE(nearest.has_value());
  EXPECT_EQ(nearest->ties, (std::vector<std::size_t>{0, 1}));
}

// tests/regressions/worst/: for each method the worst known input from `raycheck worst --by bound`,
// for ordinary rays (the parameter) or cameras (the direction).

/// The pixels that a saved case names in its comment.
std::vector<scene::Pixel> pixels_named_in(const std::string& text) {
  std::vector<scene::Pixel> pixels;
  const std::regex pair(R"(\((\d+), (\d+)\))");
  std::smatch line;
  if (!std::regex_search(text, line, std::regex("# pixels:.*"))) return pixels;
  const std::string named = line.str();
  for (std::sregex_iterator at(named.begin(), named.end(), pair), end; at != end; ++at) {
    pixels.push_back({std::stoll((*at)[1]), std::stoll((*at)[2])});
  }
  return pixels;
}

class WorstKnown : public testing::TestWithParam<std::string> {};

TEST_P(WorstKnown, HasTheStatedErrorWithinTheBound) {
  const std::string stem = GetParam();
  const std::string method = stem.substr(stem.find('-') + 1);
  const bool makes_rays = stem.rfind("rays-", 0) == 0;
  const Candidate candidate = candidate_named(makes_rays ? method + "/cross" : "direct/" + method);
  const std::filesystem::path path = folder() / "worst" / (stem + ".toml");
  const std::string text = contents(path);
  const Case the_case{scene::load_scene(path).scene, pixels_named_in(text)};
  Trial trial(the_case, candidate, {.conditioning = true});
  const Verdict verdict = apply(*find_law(makes_rays ? "direction" : "parameter"), trial);
  const Quantity quantity = makes_rays ? Quantity::kDirection : Quantity::kParameter;
  ASSERT_TRUE(verdict.tallies().contains(quantity));
  const Tally& tally = verdict.tallies().at(quantity);
  std::smatch stated;
  ASSERT_TRUE(std::regex_search(text, stated, std::regex("off by (\\S+) ")));
  EXPECT_NEAR(*tally.max() / std::stod(stated[1]), 1, 0.005) << *tally.max();
  const std::string_view not_kept = makes_rays ? not_kept_by(fast::pixel_ray_methods(), method)
                                               : not_kept_by(fast::intersect_methods(), method);
  if (not_kept.empty()) {
    EXPECT_LE(*tally.max_over_growth, trial.bound(quantity));
  }
}

std::vector<std::string> worst_stems() {
  std::vector<std::string> result;
  for (const auto* method : fast::pixel_ray_methods()) {
    result.push_back("rays-" + std::string(method->name));
  }
  for (const auto* method : fast::intersect_methods()) {
    result.push_back("intersect-" + std::string(method->name));
  }
  return result;
}

INSTANTIATE_TEST_SUITE_P(Methods, WorstKnown, testing::ValuesIn(worst_stems()), by_name);

}  // namespace
}  // namespace raycheck::properties
