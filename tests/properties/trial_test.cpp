#include "properties/trial.h"

#include "properties/candidates/fast_candidate.h"
#include "properties/mistakes/altered_hits.h"
#include "properties/sphere_choice.h"
#include "reference/visibility/visibility.h"
#include "tests/properties/one_ray.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

using scene::Conventions;

Candidate direct_cross() { return fast_candidate(fast::kDirectRays, fast::kCross); }

Case camera_case() {
  Case result;
  result.scene.camera = scene::Camera{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, -2, {}, -1, 1, -1, 1, 3, 3};
  result.scene.spheres = {{{0, 0, -10}, 3}, {{0, 0, -20}, 3}};
  result.pixels = {{1, 1}, {0, 2}};
  return result;
}

template <class Answer, class... Arguments>
void fail(CandidateFunction<Answer(Arguments...)>& function) {
  function = [](Arguments...) -> Answer { throw InternalError("injected"); };
}

/// The error is in a law, or in code between a law and a candidate.
TEST(Trial, BlamesNoInternalErrorOnTheCandidate) {
  Candidate candidate = direct_cross();
  fail(candidate.frame), fail(candidate.pixel_points), fail(candidate.pixel_rays);
  fail(candidate.focal_rays), fail(candidate.intersect), fail(candidate.nearest);
  fail(candidate.plan), fail(candidate.visible);
  const Case given = camera_case();
  int tried = 0;
  for (const Law& law : laws()) {
    Trial trial(given, candidate);
    if (law.per == Per::kImage || !scene_suits(law.needs, trial)) continue;
    EXPECT_THROW(apply(law, trial), InternalError) << law.name;
    ++tried;
  }
  EXPECT_EQ(tried, 29);
}

/// This holds for any type of exception.
TEST(Trial, BlamesExceptionsOfACandidateOnIt) {
  Candidate candidate = direct_cross();
  candidate.intersect = [](auto&&...) -> std::vector<SphereHits> { throw 7; };
  const Case given = camera_case();
  Trial trial(given, candidate);
  const Verdict verdict = apply(*find_law("class"), trial);
  ASSERT_FALSE(verdict.holds());
  EXPECT_EQ(verdict.worst(1).front().wrong, Wrong::kFailed);
}

TEST(Trial, CountsASphereThatDoesNotExistAsAFailure) {
  Candidate candidate = direct_cross();
  candidate.nearest = [](Candidate::Rays rays, auto&&...) {
    return std::vector<std::optional<std::size_t>>(rays.size(), 2);
  };
  candidate.visible = [](auto&&, auto&&, Candidate::Pixels pixels) {
    return std::vector<std::optional<SeenAnswer>>(pixels.size(), SeenAnswer{2, 1});
  };
  candidate.image = [](auto&&...) { return ImageAnswer(9, 2); };
  const Case given = camera_case();
  for (const char* law : {"nearest-sphere", "visible-sphere", "image"}) {
    Trial trial(given, candidate);
    const Verdict verdict = apply(*find_law(law), trial);
    ASSERT_FALSE(verdict.holds()) << law;
    EXPECT_EQ(verdict.worst(1).front().wrong, Wrong::kFailed) << law;
  }
}

TEST(Trial, AsksTheCandidateOnceForAllLaws) {
  Candidate candidate = direct_cross();
  int points = 0, rays = 0, hits = 0;
  const auto count = [](auto& function, int& calls) {
    function = [&calls, base = function](auto&&... args) {
      ++calls;
      return base(args...);
    };
  };
  count(candidate.pixel_points, points);
  count(candidate.pixel_rays, rays);
  count(candidate.intersect, hits);
  const Case the_case = camera_case();
  Trial trial(the_case, candidate);
  EXPECT_EQ(points + rays + hits, 0);
  for (const Law& law : laws()) {
    if (law.judges_values) apply(law, trial);
  }
  EXPECT_EQ(points, 1);
  EXPECT_EQ(rays, 1);
  EXPECT_EQ(hits, 1);
}

TEST(Trial, JudgesUnderTheDeclaredConventions) {
  Candidate candidate = direct_cross();
  Case the_case = camera_case();
  the_case.scene.conventions.root = scene::Root::kSmaller;
  EXPECT_EQ(Trial(the_case, candidate).conventions(), the_case.scene.conventions);
  candidate.declared.rows = scene::Rows::kTopFirst;
  candidate.declared.samples = scene::Samples::kCentres;
  candidate.declared.origin = scene::Origin::kFocal;
  candidate.declared.tangent = scene::Tangent::kMiss;
  const Conventions expected = {scene::Rows::kTopFirst, scene::Samples::kCentres,
                                scene::Origin::kFocal, scene::Root::kSmaller,
                                scene::Tangent::kMiss};
  EXPECT_EQ(Trial(the_case, candidate).conventions(), expected);
  EXPECT_TRUE(judge("direction", the_case, candidate).holds());
  candidate.focal_rays = nullptr;
  EXPECT_FALSE(Trial(the_case, candidate).has_rays());
  EXPECT_FALSE(judge("direction", the_case, candidate).reason_left_out().empty());
}

/// The sphere reaches from 0 to 2 along the ray. Small changes may move the near root before or
/// behind the origin, but the other root stays ahead.
TEST(Trial, ExcusesAtASurfaceTheOtherRootAndNoMiss) {
  const Case surface = one_ray({{-1, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, 1});
  const Verdict missed = judge("class", surface, that_answers({}));
  ASSERT_EQ(missed.discrepancies(), 1u);
  EXPECT_EQ(missed.worst(1).front().excuse, (Excuse{ExcuseKind::kNone, kExcusedChange}));
  const Verdict leaving = judge("nearest-root", surface, that_answers(HitAnswer{2, {1, 0, 0}}));
  ASSERT_EQ(leaving.discrepancies(), 1u);
  const Excuse excuse = leaving.worst(1).front().excuse;
  EXPECT_EQ(excuse.kind, ExcuseKind::kWitness);
  EXPECT_EQ(excuse.amount, kExcusedChange);
  // The origin is inside if the radius becomes larger than its x.
  EXPECT_GT(excuse.witness.at(9), excuse.witness.at(0));
  for (const double share : excuse.witness) EXPECT_LE(std::abs(share), kExcusedChange);
}

/// The smaller root is behind the origin by a rounding. An answer at this root is wrong by a chord.
/// Only the law `nearest-root` judges that, however much the two answers differ.
TEST(Trial, ComparesNoAnswersAtTheOtherRoot) {
  const Case inside = one_ray({{-0x1.fffffffffffffp-1, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, 1});
  for (const bool is_at_other : {true, false}) {
    Candidate candidate;
    candidate.intersect = [&](Candidate::Rays rays, Candidate::Spheres, const Conventions&) {
      const scene::Vector3& d = rays[0].direction;
      const double turned = d.x == 1 ? 1 : 2;
      return std::vector(1, SphereHits{{0, {is_at_other ? -0x1p-53 * turned : turned, {}}}});
    };
    const Verdict axes = judge("axes", inside, candidate);
    EXPECT_EQ(axes.discrepancies() == 0, is_at_other);
    EXPECT_EQ(judge("nearest-root", inside, candidate).discrepancies() == 0, !is_at_other);
  }
}

/// If two answers contradict each other, the wrong one is shown with the truth.
TEST(Trial, ShowsWhichOfTwoRelatedAnswersIsWrong) {
  Case near = one_ray({{0, 0, 0}, {1, 0, 0}}, {{0x1p-9, 0, 0}, 0x1p-10});
  for (const double least : {0x1p-9, 0x1p-12}) {
    Candidate candidate = direct_cross();
    answer_by(candidate, [&, ask = hits_of(candidate)](auto rays, auto& sphere, auto& conventions) {
      std::vector<Hit> hits = ask(rays, sphere, conventions);
      if (hits[0] && hits[0]->parameter < least) hits[0].reset();
      return hits;
    });
    const Discrepancy shown = judge("scaling", near, candidate).worst(1).at(0);
    const bool is_first = least > 0x1p-10;
    EXPECT_EQ(shown.wrong, Wrong::kMissed);
    EXPECT_TRUE(shown.got.empty());
    EXPECT_EQ(shown.what,
              is_first ? "right only with lengths scaled by 2^120" : "lengths scaled by 2^-120");
    EXPECT_EQ(shown.exact, std::vector{is_first ? 0x1p-10 : 0x1p-130});
  }
}

TEST(Trial, JudgesATangentByItsConvention) {
  const HitAnswer hit{5, {0, 1, 0}};
  for (const auto& [tangent, answer_is_right, judged] :
       {std::tuple(scene::Tangent::kHit, true, true),
        std::tuple(scene::Tangent::kMiss, false, true),
        std::tuple(scene::Tangent::kEither, true, false)}) {
    Case tangent_case = at_height(1);
    tangent_case.scene.conventions.tangent = tangent;
    const Verdict of_hit = judge("class", tangent_case, that_answers(hit));
    EXPECT_EQ(of_hit.compared(), judged ? 1u : 0u);
    EXPECT_EQ(of_hit.discrepancies(), answer_is_right ? 0u : 1u);
  }
}

TEST(Trial, ComparesAnErrorWithTheChosenBoundOrTheCandidates) {
  Candidate candidate = that_answers(HitAnswer{4 + 0x1p-48, {-1, 0, 0}});  // 8 ulp of 4 off
  const Case the_case = at_height(0);
  EXPECT_TRUE(judge("parameter", the_case, candidate).holds());
  EXPECT_FALSE(judge("parameter", the_case, candidate, {.max_error = 3}).holds());
  candidate.max_error[static_cast<std::size_t>(Quantity::kParameter)] = 3;
  const Verdict verdict = judge("parameter", the_case, candidate);
  EXPECT_FALSE(verdict.holds());
  EXPECT_EQ(verdict.worst(1).at(0).error, 4);
  EXPECT_TRUE(judge("parameter", the_case, candidate, {.max_error = 5}).holds());
}

TEST(Trial, GivesNoExcuseAgainstAPromiseOfExactHitClasses) {
  Candidate candidate = that_answers(HitAnswer{5, {0, 1, 0}});
  candidate.smallest_length = 10;
  const Case outside = at_height(std::nextafter(1.0, 2.0));
  EXPECT_EQ(judge("class", outside, candidate).worst(1).at(0).excuse.kind,
            ExcuseKind::kOutsideDomain);
  candidate.smallest_length = 0;
  EXPECT_EQ(judge("class", outside, candidate).worst(1).at(0).excuse.kind, ExcuseKind::kWitness);
  candidate.exact_class = true;
  EXPECT_FALSE(judge("class", outside, candidate).holds());
  candidate.smallest_length = 10;
  EXPECT_FALSE(judge("class", outside, candidate).holds());
}

TEST(Trial, AppliesAnUnconditionalBoundAtEveryConditionNumber) {
  Case the_case = camera_case();
  the_case.scene.camera->eye = {1, 2, 4};
  the_case.scene.camera->up = {1, 2, 4 + 0x1p-30};
  Candidate candidate = direct_cross();
  // U leans towards W.
  candidate.frame = [base = candidate.frame](const scene::Camera& camera) {
    FrameAnswer frame = base(camera);
    frame.U = {frame.U.x + 0x1p-40 * frame.W.x, frame.U.y + 0x1p-40 * frame.W.y,
               frame.U.z + 0x1p-40 * frame.W.z};
    return frame;
  };
  EXPECT_FALSE(judge("frame", the_case, candidate).holds());
  candidate.is_unconditional = {};
  EXPECT_TRUE(judge("frame", the_case, candidate).holds());
}

TEST(Trial, AddsTheDomainOfCamerasIfThereIsACamera) {
  Candidate candidate;
  candidate.smallest_camera_length = 100;
  EXPECT_FALSE(is_inside_domain(candidate, camera_case().scene));
  EXPECT_TRUE(is_inside_domain(candidate, at_height(0).scene));
}

TEST(Trial, CountsAFailureAsADiscrepancy) {
  Candidate throwing;
  throwing.intersect = [](auto&&...) -> std::vector<SphereHits> {
    throw std::invalid_argument("I will not");
  };
  const auto that_lists = [](const std::vector<SphereHits>& lists) {
    Candidate candidate;
    candidate.intersect = [lists](auto&&...) { return lists; };
    return candidate;
  };
  Wrong expected = Wrong::kRefused;  // of the first, by its invalid_argument
  for (const Candidate& candidate : {throwing, that_lists({}), that_lists({{}, {}}),
                                     that_lists({{{1, {}}}}), that_lists({{{0, {}}, {0, {}}}})}) {
    const Verdict verdict = judge("class", at_height(0), candidate);
    EXPECT_FALSE(verdict.holds());
    EXPECT_EQ(verdict.worst(1).at(0).wrong, expected);
    expected = Wrong::kFailed;
    EXPECT_FALSE(verdict.worst(1).at(0).what.empty());
  }
}

TEST(Trial, RefusesAnInvalidCase) {
  Case the_case = at_height(0);
  the_case.scene.spheres[0].radius = -1;
  EXPECT_THROW(Trial(the_case, direct_cross()), std::invalid_argument);
}

/// The errors of a candidate that returns these spheres for three rays: one through the centres of
/// spheres 0, 1 and 2 (1 and 2 are equal), one that touches sphere 0, and one that misses all.
std::vector<NearestHitError> errors_of(const std::vector<std::optional<std::size_t>>& nearest,
                                       scene::Tangent tangent = scene::Tangent::kHit) {
  Case the_case;
  the_case.scene.rays = {{{0, 0, 0}, {1, 0, 0}}, {{0, 2, 0}, {1, 0, 0}}, {{0, 9, 0}, {1, 0, 0}}};
  the_case.scene.spheres = {{{20, 0, 0}, 2}, {{10, 0, 0}, 1}, {{10, 0, 0}, 1}};
  the_case.scene.conventions.tangent = tangent;
  Candidate candidate = fast_candidate(fast::kDirectRays, fast::kRobust);
  candidate.nearest = [&](const auto&...) { return nearest; };
  Trial trial(the_case, candidate);
  const std::int32_t touched = tangent == scene::Tangent::kMiss ? reference::kNoSphere : 0;
  return nearest_hit_errors(trial, std::vector<std::int32_t>{1, touched, reference::kNoSphere});
}

/// If several spheres are equally near, each is right.
TEST(NearestHitError, IsMeasuredWhereTheSphereIsRight) {
  for (const std::size_t nearest : {1u, 2u}) {
    const auto errors = errors_of({nearest, 0, std::nullopt});
    ASSERT_EQ(errors.size(), 3u);
    for (const NearestHitError& error : errors) EXPECT_EQ(error.wrong, Wrong::kNot);
    EXPECT_EQ(errors[0].ulp, 0);
    EXPECT_EQ(errors[1].ulp, 0);
    EXPECT_FALSE(errors[2].ulp);
  }
}

TEST(NearestHitError, SaysHowAnAnswerIsWrong) {
  // The convention determines whether a tangent is excused or not judged.
  for (const auto& [tangent, standing] : {std::pair(scene::Tangent::kHit, Standing::kExcused),
                                          {scene::Tangent::kEither, Standing::kNotJudged}}) {
    const auto errors = errors_of({0, std::nullopt, 1}, tangent);
    EXPECT_EQ(errors[0].wrong, Wrong::kWrongSphere);
    EXPECT_EQ(errors[1].wrong, Wrong::kMissed);
    EXPECT_EQ(errors[2].wrong, Wrong::kFalseHit);
    for (const NearestHitError& error : errors) EXPECT_FALSE(error.ulp);
    EXPECT_EQ(errors[0].standing, Standing::kDefect);
    EXPECT_EQ(errors[1].standing, standing);
    EXPECT_EQ(errors[2].standing, Standing::kDefect);
  }
}

}  // namespace
}  // namespace raycheck::properties
