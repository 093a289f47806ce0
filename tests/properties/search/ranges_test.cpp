#include "properties/search/ranges.h"

#include "properties/cases/random.h"
#include "properties/laws/certificate.h"
#include "reference/exact_ray.h"
#include "scene/fields.h"
#include "scene/interruption.h"
#include "scene/validate.h"
#include "tests/campaigns.h"
#include "tests/properties/one_ray.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

const Law& kClassLaw = *find_law("class");
const Candidate kByCross = fast_candidate(fast::kDirectRays, fast::kCross);

const Case kInFront = one_ray({{0, 0, 0}, {0, 0, 1}}, {{0, 0, 5}, 0.25});

bool breaks(const Candidate& candidate, const Case& the_case) {
  if (!scene::defects(the_case.scene).empty()) return false;
  return !Trials(the_case, candidate).apply(kClassLaw).holds();
}

const NumberRange& range_called(const Ranges& ranges, std::string_view name) {
  for (const NumberRange& range : ranges.numbers) {
    if (range.name == name) return range;
  }
  throw std::logic_error("no such number");
}

/// The number with this name in a case, found without named_numbers().
double& number_in(Case& the_case, std::string_view name) {
  scene::Scene& scene = the_case.scene;
  if (name == "sphere 0 radius") return scene.spheres[0].radius;
  scene::Ray& ray = scene.rays[0];
  const bool is_direction = name.find("direction") != name.npos;
  const auto of = [&](auto& triple) -> double& {
    return name.ends_with(" x") ? triple.x : name.ends_with(" y") ? triple.y : triple.z;
  };
  if (name.starts_with("sphere")) return of(scene.spheres[0].centre);
  return is_direction ? of(ray.direction) : of(ray.origin);
}

/// Whether the law breaks at both ends of a range, and does not break at the next numbers outside.
bool is_tight(const Candidate& candidate, const Case& shrunk, const NumberRange& range) {
  const auto breaks_at = [&](double x) {
    Case moved = shrunk;
    number_in(moved, range.name) = x;
    return breaks(candidate, moved);
  };
  const auto beyond = [&](double x, double toward) {
    return scene::next_after(candidate.precision, x, toward);
  };
  const auto [least, greatest] = range.span;
  return breaks_at(least) && breaks_at(greatest) && !breaks_at(beyond(least, -HUGE_VAL)) &&
         !breaks_at(beyond(greatest, HUGE_VAL));
}

TEST(Ranges, EndAtTheLastDoubleBelowTheCandidatesThreshold) {
  const Candidate candidate = that_misses([](const auto& sphere) { return sphere.radius < 0.5; });
  const Ranges found = ranges_of(kClassLaw, candidate, kInFront);
  const NumberRange& radius = range_called(found, "sphere 0 radius");
  EXPECT_EQ(radius.span.greatest, std::nextafter(0.5, 0));
  EXPECT_EQ(radius.span.least, 0);  // The ray goes through the point.
  EXPECT_EQ(radius.value, 0.25);
  EXPECT_FALSE(radius.is_any);
  EXPECT_FALSE(radius.certified);
  EXPECT_GT(radius.samples, 2 * kPointsBetween);
  // Computed by hand: a ray along the axis meets the sphere if its centre is at most r from the
  // axis.
  const NumberRange& across = range_called(found, "sphere 0 centre x");
  EXPECT_NEAR(across.span.greatest, 0.25, 1e-14);
  EXPECT_NEAR(across.span.least, -0.25, 1e-14);
  EXPECT_EQ(found.not_tried, 0);
  for (const NumberRange& range : found.numbers) {
    if (range.is_any || range.is_exact()) continue;
    EXPECT_TRUE(is_tight(candidate, kInFront, range)) << range.name;
  }
  for (const double off : {-1.0, 1.0}) {  // is_tight() notices a range that is off by one number
    NumberRange wrong = radius;
    wrong.span.greatest = std::nextafter(radius.span.greatest, off);
    EXPECT_FALSE(is_tight(candidate, kInFront, wrong)) << off;
  }
}

TEST(Ranges, CountFloatsForACandidateInSinglePrecision) {
  Candidate candidate = that_misses([](const auto& sphere) { return sphere.radius < 0.5; });
  candidate.unit_roundoff = 0x1p-24;
  candidate = judged_in(scene::Precision::kSingle, std::move(candidate));
  const Ranges found = ranges_of(kClassLaw, candidate, kInFront);
  const double greatest = range_called(found, "sphere 0 radius").span.greatest;
  EXPECT_EQ(greatest, static_cast<double>(std::nextafter(0.5F, 0.0F)));
}

TEST(Ranges, EndBeforeANumberThatDoesNotBreakTheLaw) {
  const Candidate candidate = that_misses([](const auto& sphere) {
    return sphere.radius < 0.5 && !(sphere.radius > 0.385 && sphere.radius < 0.43);
  });
  Case near_hole = kInFront;
  near_hole.scene.spheres[0].radius = 0.499;
  const NumberRange radius =
      range_called(ranges_of(kClassLaw, candidate, near_hole), "sphere 0 radius");
  EXPECT_EQ(radius.span, (Span{0.43, std::nextafter(0.5, 0)}));
}

TEST(Ranges, ReportNumbersThatMayBeAnythingAndThoseThatMatterExactly) {
  const Candidate blind = that_misses([](const auto&) { return true; });
  const Case inside = one_ray({{0, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, 1});
  const Ranges any = ranges_of(kClassLaw, blind, inside);
  EXPECT_TRUE(range_called(any, "ray 0 direction x").is_any);
  EXPECT_LE(range_called(any, "ray 0 direction x").span.least, -0x1p199);
  EXPECT_FALSE(range_called(any, "ray 0 origin x").is_any);
  const Candidate odd = that_misses([](const auto& sphere) { return sphere.radius == 0.25; });
  const NumberRange exact = range_called(ranges_of(kClassLaw, odd, kInFront), "sphere 0 radius");
  EXPECT_TRUE(exact.is_exact());
  EXPECT_EQ(exact.span, (Span{0.25, 0.25}));
  EXPECT_FALSE(exact.is_any);
}

/// Code whose answers are all wrong breaks the law everywhere, by false hits or by misses.
TEST(Ranges, KeepTheKindOfDefect) {
  Candidate opposite = that_misses([](const auto&) { return false; });
  opposite.intersect = [](const auto&... asked) {
    auto answers = kByCross.intersect(asked...);
    for (SphereHits& hits : answers) {
      hits = hits.empty() ? SphereHits{{0, {1, {0, 0, 1}}}} : SphereHits{};
    }
    return answers;
  };
  Case at_side = kInFront;  // The ray passes at this distance.
  at_side.scene.spheres[0].centre.x = 0.9;
  const auto range = [&](double radius) {
    at_side.scene.spheres[0].radius = radius;
    EXPECT_TRUE(breaks(opposite, at_side));
    return range_called(ranges_of(kClassLaw, opposite, at_side), "sphere 0 radius").span;
  };
  const Span small = range(0.25), large = range(2);
  EXPECT_NEAR(small.greatest, 0.9, 1e-14);
  EXPECT_LT(small.greatest, 0.9);
  EXPECT_NEAR(large.least, 0.9, 1e-14);
  EXPECT_GT(large.least, 0.9);
}

TEST(Ranges, KeepTheirBudgetOfQuestionsAndAreReproducible) {
  int asked = 0;
  Candidate candidate = that_misses([](const auto&) { return true; });
  const auto misses = candidate.intersect;
  candidate.intersect = [&](auto... of) {
    ++asked;
    return misses(of...);
  };
  Case many = kInFront;
  many.scene.spheres.resize(40, many.scene.spheres[0]);
  const Ranges first = ranges_of(kClassLaw, candidate, many);
  EXPECT_EQ(first.questions, kMostQuestions);
  EXPECT_LE(asked, kMostQuestions + 1);
  EXPECT_GT(first.not_tried, 0);
  std::size_t numbers = 0;
  for_each_number(many.scene, [&](double&) { ++numbers; });
  EXPECT_EQ(first.numbers.size() + first.not_tried, numbers);
  const Ranges second = ranges_of(kClassLaw, candidate, many);
  ASSERT_EQ(first.numbers.size(), second.numbers.size());
  for (std::size_t k = 0; k < first.numbers.size(); ++k) {
    EXPECT_EQ(first.numbers[k].name, second.numbers[k].name);
    EXPECT_EQ(first.numbers[k].span, second.numbers[k].span);
    EXPECT_EQ(first.numbers[k].samples, second.numbers[k].samples);
  }
}

TEST(Ranges, EndEarlyOnAnInterrupt) {
  const Candidate blind = that_misses([](const auto&) { return true; });
  for (const int polls : {0, 2000}) {
    int polled = 0;
    const std::function<bool()> interrupted = [&] { return ++polled > polls; };
    const scene::Interruptible interruptible(interrupted);
    const Ranges found = ranges_of(kClassLaw, blind, kInFront);
    EXPECT_LT(found.numbers.size(), 10u) << polls;
    EXPECT_EQ(found.numbers.size() + found.not_tried, 10u) << polls;
    EXPECT_EQ(found.numbers.empty(), polls == 0);
  }
}

TEST(Ranges, NameEveryNumberOfACamera) {
  Case the_case = chosen_source("plain-cameras").make(1);
  the_case.scene.spheres = {{the_case.scene.camera->look_at, 1000}};
  const Candidate blind = that_misses([](const auto&) { return true; });
  ASSERT_TRUE(breaks(blind, the_case));
  const Ranges found = ranges_of(kClassLaw, blind, the_case);
  std::vector<double> numbers;
  for_each_number(the_case.scene, [&](double& x) { numbers.push_back(x); });
  ASSERT_EQ(found.numbers.size(), numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) EXPECT_EQ(found.numbers[k].value, numbers[k]);
  EXPECT_EQ(found.numbers.front().name, "camera eye x");
  EXPECT_EQ(found.numbers[9].name, "camera near");
  EXPECT_EQ(found.numbers.back().name, "sphere 0 radius");
}

TEST(Ranges, AreSoughtOnlyForBrokenLawsAndCheapQuestions) {
  EXPECT_TRUE(ranges_of(kClassLaw, kByCross, kInFront).numbers.empty());
  Candidate candidate = that_misses([](const auto&) { return true; });
  const Verdict missed = run_case(kClassLaw, candidate, kInFront).failure->verdict;
  EXPECT_TRUE(has_ranges(candidate, missed));
  candidate.image = [](const auto&, const auto&) { return ImageAnswer{}; };
  EXPECT_FALSE(has_ranges(candidate, missed));
  candidate.image = {};
  candidate.intersect = [](auto...) -> std::vector<SphereHits> { throw std::runtime_error("no"); };
  const Verdict failed = run_case(kClassLaw, candidate, kInFront).failure->verdict;
  EXPECT_FALSE(has_ranges(candidate, failed));
}

// Certificates.

/// Some numbers of a span, among them the ends and the numbers next to these.
std::vector<double> some_of(const Span& span, int count, Random& random) {
  std::vector<double> some = {span.least, span.greatest, std::nextafter(span.least, span.greatest),
                              std::nextafter(span.greatest, span.least)};
  while (static_cast<int>(some.size()) < count) {
    const double x = random.between(span.least, span.greatest);
    if (x >= span.least && x <= span.greatest) some.push_back(x);
  }
  return some;
}

/// Of `count` numbers in a range, the number at which the method's hit class is exact, or the law
/// holds.
int count_right(const Candidate& candidate, const fast::IntersectMethod& method, const Case& shrunk,
                const NumberRange& range, int count, Random& random) {
  int right = 0;
  for (const double x : some_of(*range.certified, count, random)) {
    Case moved = shrunk;
    number_in(moved, range.name) = x;
    const scene::Ray& ray = moved.scene.rays[0];
    const scene::Sphere& sphere = moved.scene.spheres[0];
    const auto exact = reference::ExactRay(ray).intersect(sphere, moved.scene.conventions.root,
                                                          {reference::Engine::kFieldOnly});
    const bool is_hit = reference::counts_as_hit(exact.hit_class, moved.scene.conventions.tangent);
    const bool answer =
        method.intersect_one(ray, sphere, moved.scene.conventions.hit_rule()).has_value();
    right += is_hit == answer || !breaks(candidate, moved) ? 1 : 0;
  }
  return right;
}

/// A case with a far sphere for which the lecture's differences of squares are wrong.
std::optional<Case> far_failure(const Candidate& candidate, std::uint64_t seed) {
  CampaignOptions options = options_of(120, {"distance@11"});
  options.seed = seed;
  const auto failure = run_campaign(kClassLaw, candidate, options).failure;
  if (!failure || failure->shrunk.scene.camera) return {};
  return failure->shrunk;
}

TEST(CertifiedRanges, BreakTheLawAtEveryNumberTried) {
  Random random(1);
  int certified = 0, whole = 0;
  for (const auto* method : {&fast::kLecture, &fast::kQuadratic, &fast::kStableQuadratic}) {
    const Candidate candidate = fast_candidate(fast::kDirectRays, *method);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const auto shrunk = far_failure(candidate, seed);
      if (!shrunk) continue;
      for (const NumberRange& range : ranges_of(kClassLaw, candidate, *shrunk).numbers) {
        if (!range.certified) continue;
        ++certified;
        whole += range.certified == range.span ? 1 : 0;
        EXPECT_GE(range.certified->least, range.span.least);
        EXPECT_LE(range.certified->greatest, range.span.greatest);
        EXPECT_EQ(count_right(candidate, *method, *shrunk, range, 200, random), 0)
            << method->name << ", " << range.name;
      }
    }
  }
  EXPECT_GT(certified, 40);
  EXPECT_GT(whole, 10);
}

/// count_right() notices a range that continues where the law holds.
TEST(CertifiedRanges, AreRefutedIfTheLawHoldsInThem) {
  Random random(1);
  const Candidate candidate = fast_candidate(fast::kDirectRays, fast::kLecture);
  const auto shrunk = far_failure(candidate, 1);
  ASSERT_TRUE(shrunk);
  int refuted = 0;
  for (NumberRange range : ranges_of(kClassLaw, candidate, *shrunk).numbers) {
    if (!range.certified || range.is_any) continue;
    range.certified->greatest = std::nextafter(range.span.greatest, HUGE_VAL);
    refuted += count_right(candidate, fast::kLecture, *shrunk, range, 4, random) > 0 ? 1 : 0;
  }
  EXPECT_GT(refuted, 5);
}

TEST(CertifiedRanges, NeedTheCandidatesClassAndTheTruth) {
  const Candidate lecture = fast_candidate(fast::kDirectRays, fast::kLecture);
  const auto shrunk = far_failure(lecture, 1);
  ASSERT_TRUE(shrunk);
  const DefectKind false_hit{Quantity::kClass, Wrong::kFalseHit};
  const DefectKind missed{Quantity::kClass, Wrong::kMissed};
  const auto certain = [&](const Candidate& candidate, const Case& one, DefectKind kind) {
    return is_certain(kClassLaw, candidate, {one, one}, kind);
  };
  const bool is_missed = certain(lecture, *shrunk, missed);
  EXPECT_NE(certain(lecture, *shrunk, false_hit), is_missed);
  const DefectKind kind = is_missed ? missed : false_hit;
  Candidate unsure = lecture;
  unsure.classes_in = [](const auto&...) { return scene::PossibleClasses{true, true}; };
  EXPECT_FALSE(certain(unsure, *shrunk, kind));
  Candidate right = lecture;
  right.classes_in = [=](const auto&...) { return scene::PossibleClasses{is_missed, !is_missed}; };
  EXPECT_FALSE(certain(right, *shrunk, kind));
  EXPECT_FALSE(certain(lecture, kInFront, missed));
  EXPECT_FALSE(certain(lecture, kInFront, false_hit));
  EXPECT_FALSE(certain(kByCross, *shrunk, kind));
  EXPECT_FALSE(is_certain(*find_law("nearest-root"), lecture, {*shrunk, *shrunk}, kind));
  EXPECT_FALSE(certain(lecture, *shrunk, {Quantity::kClass, Wrong::kNot}));
  Case with_point = *shrunk;
  with_point.scene.spheres.push_back({{1, 2, 3}, 0});
  EXPECT_TRUE(certain(lecture, *shrunk, kind));
  EXPECT_FALSE(certain(lecture, with_point, kind));  // its distance may leave the domain
  Candidate after_one = lecture;
  after_one.declared.valid->t_min = 1;
  EXPECT_FALSE(certain(after_one, *shrunk, kind));
}

}  // namespace
}  // namespace raycheck::properties
