#include "properties/mistakes/answer_explanation.h"

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/candidates/fast_candidate.h"
#include "properties/cases/case_source.h"
#include "properties/mistakes/causes.h"
#include "properties/mistakes/fault.h"
#include "properties/mistakes/imprecision.h"
#include "properties/mistakes/mistakes.h"
#include "properties/search/campaign.h"
#include "tests/campaigns.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

std::vector<Case> cases_of(std::initializer_list<const char*> sources, std::uint64_t count) {
  std::vector<Case> cases;
  for (const char* name : sources) {
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
      cases.push_back(find_case_source(name)->make(0, seed));
    }
  }
  return cases;
}

/// Cases with lengths and distances of each size in the groups of mistakes.
const std::vector<Case>& fixed_cases() {
  static const std::vector<Case> kCases = [] {
    std::vector<Case> cases =
        cases_of({"cameras", "plain-cameras", "crowds", "rays", "ties", "inside"}, 40);
    for (int power = 4; power <= 36; power += 2) {
      const auto seed = static_cast<std::uint64_t>(power);
      for (const char* name : {"scale", "camera-scale", "direction-length"})
        cases.push_back(find_case_source(name)->make(power, seed));
      cases.push_back(find_case_source("surface")->make(16, seed));
      cases.push_back(find_case_source("distance")->make(power / 4, seed));
      cases.push_back(find_case_source("tangency")->make(power / 4, seed));
    }
    return cases;
  }();
  return kCases;
}

Candidate candidate_of(std::string_view sentence) {
  const Mistake* mistake = find_mistake(sentence);
  if (mistake == nullptr) throw std::invalid_argument(std::string(sentence));
  return mistake->candidate;
}

using Sentences = std::vector<std::string>;

Sentences sentences_for(const Candidate& candidate,
                        const std::vector<Case>& cases = fixed_cases()) {
  Sentences sentences;
  for (const Explanation& explanation : explanations(answer_causes(cases, candidate))) {
    EXPECT_GT(explanation.errors, 0u);
    EXPECT_LE(explanation.explained, explanation.errors);
    if (explanation.sentence == kTooFewErrors) {
      EXPECT_LT(explanation.errors, kFewestErrorsOfACause);
      EXPECT_EQ(explanation.explained, 0u);
      sentences.push_back(explanation.sentence);
      continue;
    }
    // Other answers are wrong for another reason.
    if (explanation.sentence != kNotNumbers) {
      EXPECT_GE(static_cast<double>(explanation.explained),
                kExplainedShare * static_cast<double>(explanation.errors));
    }
    sentences.push_back(explanation.sentence);
  }
  return sentences;
}

/// A candidate that follows one convention even if the scene says otherwise.
template <class Value>
Candidate following(Value scene::Conventions::*member, Value value) {
  Candidate candidate = fast_candidate(fast::kDirectRays, *fast::intersect_methods().front());
  const auto overridden = [=](scene::Conventions conventions) {
    conventions.*member = value;
    return conventions;
  };
  const auto follow = [&](auto& function) {
    function = [=, answer = function](auto camera_or_rays, const auto& given,
                                      auto pixels_or_conventions) {
      if constexpr (std::is_convertible_v<decltype(given), scene::Conventions>) {
        return answer(camera_or_rays, overridden(given), pixels_or_conventions);
      } else {
        return answer(camera_or_rays, given, overridden(pixels_or_conventions));
      }
    };
  };
  follow(candidate.pixel_points);
  follow(candidate.pixel_rays);
  follow(candidate.focal_rays);
  follow(candidate.intersect);
  follow(candidate.nearest);
  if constexpr (std::is_same_v<Value, scene::Origin>) {
    candidate.pixel_rays = candidate.focal_rays =
        value == scene::Origin::kPixel ? candidate.pixel_rays : candidate.focal_rays;
  }
  return candidate;
}

/// A candidate that declares which roots count, and answers as if all did.
Candidate counting_all(scene::ValidRoots declared) {
  Candidate candidate = fast_candidate(fast::kDirectRays, *fast::intersect_methods().front());
  candidate.declared.valid = declared;
  return candidate;
}

/// A candidate that declares that no root counts beyond s = 4, and drops hits at a distance of more
/// than 4.
Candidate cut_at_a_length() {
  Candidate candidate = counting_all({.t_max = 4});
  answer_by(candidate, [ask = hits_of(candidate)](Candidate::Rays rays, const scene::Sphere& sphere,
                                                  const scene::Conventions& conventions) {
    std::vector<Hit> hits = ask(rays, sphere, conventions);
    for (std::size_t k = 0; k < hits.size(); ++k) {
      const auto& [x, y, z] = rays[k].direction;
      if (hits[k] && hits[k]->parameter * std::hypot(x, y, z) > 4) hits[k].reset();
    }
    return hits;
  });
  return candidate;
}

struct Undeclared {
  Candidate candidate;
  std::string text;
};

/// The other hit class of exact tangents is excused: nearby inputs have it.
TEST(Conventions, ThatAreFollowedButNotDeclaredAreNamed) {
  const Undeclared all[] = {
      {following(&scene::Conventions::rows, scene::Rows::kTopFirst), "rows = top-first"},
      {following(&scene::Conventions::samples, scene::Samples::kEdges), "samples = edges"},
      {following(&scene::Conventions::samples, scene::Samples::kCorners), "samples = corners"},
      {following(&scene::Conventions::origin, scene::Origin::kFocal), "origin = focal"},
      {following(&scene::Conventions::root, scene::Root::kNearest), "root = nearest"},
      {counting_all({.t_min = 0, .t_max = 1}), "t_max = infinity"},
      {counting_all({.t_min = -std::numeric_limits<double>::infinity()}), "t_min = 0"},
      {cut_at_a_length(), "t_unit = length"},
  };
  for (const auto& [candidate, text] : all) {
    SCOPED_TRACE(text);
    std::size_t broken = 0;
    const auto judged = laws_that([](const Law& law) { return law.judges_values; });
    const auto results = run_campaigns(judged, candidate, options_of(400, {}, Level::kOrdinary));
    for (std::size_t k = 0; k < judged.size(); ++k) {
      if (results[k].finding() != Finding::kBroken) continue;
      ++broken;
      const auto found = causes(*judged[k], telling_cases(results[k], kCasesOfACause), candidate);
      ASSERT_EQ(found.size(), 1u) << judged[k]->name;
      EXPECT_EQ(found[0].sentence,
                "right under " + text + ", which the candidate does not declare");
      EXPECT_EQ(found[0].explained, found[0].errors);
      EXPECT_GT(found[0].errors, 0u);
    }
    EXPECT_GT(broken, 0u);
  }
  // Code that is right under no convention gets no such cause.
  const Candidate wrong = candidate_of("no ray ever hits a sphere");
  const auto of_class = laws_named({"class"});
  const auto result = run_campaigns(of_class, wrong, options_of(400, {}, Level::kOrdinary));
  for (const Explanation& one : causes(*of_class[0], telling_cases(result[0], 12), wrong)) {
    EXPECT_EQ(one.sentence.find("declare"), std::string::npos) << one.sentence;
  }
}

/// Wrong answers that are not judged under a convention, and misses, which any radius may explain,
/// are no evidence of it.
TEST(Conventions, AreNotNamedIfNothingShowsThem) {
  Candidate candidate = candidate_of("where b^2 - 4ac = 0, s is 0: the hit is the ray's origin");
  candidate.declared.tangent = scene::Tangent::kEither;
  candidate.declared.valid = scene::ValidRoots{.t_max = 1};
  const Law& of_class = *find_law("class");
  std::vector<Case> cases;
  for (int k = 0; k < 12; ++k) {
    Case one = find_case_source("rays")->make(0, static_cast<std::uint64_t>(k));
    one.scene.spheres = {{{0, 0, -1}, 32}};
    const double z = k;
    one.scene.rays = {{{32, 0, z}, {0, 0, 1}}, {{100, 0, z}, {0, 0, 1}}};
    cases.push_back(one);
  }
  const std::vector<Explanation> found = causes(of_class, cases, candidate);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].sentence.find("right under"), std::string::npos) << found[0].sentence;
  EXPECT_EQ(found[0].errors, 12u);
}

/// Mistakes hit at roots from inside; a candidate that declares other hits there is examined
/// outside.
TEST(Causes, AreSoughtOutsideSpheresThatAreDeclaredSolid) {
  const char* const solid = "spheres are solid: from inside s is 0";
  const char* const half = "s is half of the right one";
  Candidate candidate = candidate_of(solid);
  EXPECT_EQ(sentences_for(candidate), Sentences{solid});
  candidate.interface.from_inside = contract::FromInside::kStart;
  EXPECT_EQ(sentences_for(candidate), Sentences{});
  answer_by(candidate, [ask = hits_of(candidate)](auto rays, auto& sphere, auto& conventions) {
    std::vector<Hit> hits = ask(rays, sphere, conventions);
    for (std::size_t k = 0; k < hits.size(); ++k) {
      if (hits[k]) hits[k] = hit_at(rays[k], hits[k]->parameter / 2);
    }
    return hits;
  });
  EXPECT_EQ(sentences_for(candidate), Sentences{half});
}

/// Doubles with a radius that is slightly wrong are not computed in floats.
TEST(Causes, OfErrorsToOneSideAreNotRoundings) {
  for (const double factor : {1 + 1e-5, 1 - 1e-6}) {
    Candidate candidate = fast_candidate(fast::kDirectRays, fast::kCross);
    answer_by(candidate, [ask = hits_of(candidate), factor](auto rays, scene::Sphere sphere,
                                                            auto& conventions) {
      sphere.radius *= factor;
      return ask(rays, sphere, conventions);
    });
    for (const char* name : {"class", "parameter", "hit-point"}) {
      const auto of = laws_named({name});
      const auto result = run_campaigns(of, candidate, options_of(400, {}, Level::kOrdinary));
      if (result[0].finding() != Finding::kBroken) continue;
      for (const Explanation& one :
           causes(*of[0], telling_cases(result[0], kCasesOfACause), candidate)) {
        EXPECT_EQ(one.sentence.find("single precision"), std::string::npos) << one.sentence;
      }
    }
  }
}

/// The count includes cases that are left out because roots are close to a declared end, and small
/// errors beside answers that are NaN.
TEST(Causes, CountAllWrongAnswers) {
  const Law& of_class = *find_law("class");
  Candidate far = candidate_of("spheres are solid: from inside s is 0");
  far.declared.valid = scene::ValidRoots{.t_max = 50};
  const auto some = causes(of_class, fixed_cases(), far);
  ASSERT_EQ(some.size(), 1u);
  EXPECT_EQ(some[0].sentence, "spheres are solid: from inside s is 0");
  EXPECT_LT(some[0].explained, some[0].errors);
  Candidate rough = fast_candidate(fast::kDirectRays, fast::kCross);
  answer_by(rough, [ask = hits_of(rough)](auto rays, auto& sphere, auto& conventions) {
    std::vector<Hit> hits = ask(rays, sphere, conventions);
    for (Hit& hit : hits) {
      if (!hit) continue;
      const bool is_far = hit->parameter > 4;
      hit->parameter =
          is_far ? std::numeric_limits<double>::quiet_NaN() : hit->parameter * (1 + 1e-9);
    }
    return hits;
  });
  const auto both = causes(*find_law("parameter"), fixed_cases(), rough);
  ASSERT_EQ(both.size(), 1u);
  EXPECT_EQ(both[0].sentence, kNotNumbers);
  EXPECT_LT(both[0].explained, both[0].errors);
}

TEST(Mistakes, HaveDistinctSentences) {
  std::set<std::string> sentences;
  for (const Mistake& mistake : mistakes()) EXPECT_TRUE(sentences.insert(mistake.sentence).second);
  EXPECT_GE(sentences.size(), 60u);
}

/// The indices of the mistakes that are made before the rays are complete, or after.
std::vector<std::size_t> indices(bool on_the_way) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < mistakes().size(); ++k) {
    if (mistakes()[k].is_offered == never_of_functions) continue;
    if ((mistakes()[k].step < Step::kIntersect) == on_the_way) result.push_back(k);
  }
  return result;
}

void expect_among(const Sentences& sentences, const std::string& sentence) {
  EXPECT_TRUE(
      std::any_of(sentences.begin(), sentences.end(),
                  [&](const std::string& one) {
                    return (", or: " + one + ", or: ").find(", or: " + sentence + ", or: ") !=
                           std::string::npos;
                  }))
      << sentence << ": " << testing::PrintToString(sentences);
}

class EachMistake : public testing::TestWithParam<std::size_t> {
 protected:
  const Mistake& mistake() const { return mistakes()[GetParam()]; }
};

/// The mistake, or the one of its group that was named, since cases may not distinguish sizes.
const Mistake& as_named(const Mistake& mistake, const Sentences& sentences) {
  const auto is_alike = [&](const Mistake& other) {
    return &other == &mistake || (!other.group.empty() && other.group == mistake.group);
  };
  const Mistake* const named = sentences.empty() ? nullptr : find_mistake(sentences.front());
  return named != nullptr && is_alike(*named) ? *named : mistake;
}

/// A candidate that can make the mistake: if necessary, one that returns distances or declares
/// which roots count. Empty if only pictures show the mistake.
std::optional<Candidate> who_may_make(const Mistake& mistake) {
  for (const Returns returns : {Returns::kHit, Returns::kDistance}) {
    for (const scene::ValidRoots& valid : {scene::ValidRoots{}, scene::ValidRoots{.t_max = 4}}) {
      Candidate candidate = mistake.candidate;
      candidate.interface.returns = returns;
      candidate.declared.valid = valid;
      if (mistake.is_offered == nullptr || mistake.is_offered(candidate)) return candidate;
    }
  }
  return {};
}

TEST_P(EachMistake, IsExplainedOnlyByItsSentence) {
  // Mistakes in cameras and in spheres are searched for separately, and single rays do not show
  // pixels outside the image.
  const auto says = [&](const char* words) {
    return mistake().sentence.find(words) != std::string::npos;
  };
  const auto candidate = who_may_make(mistake());
  if (!candidate) return;
  const Sentences sentences = sentences_for(*candidate);
  if ((says("numbers are r") && mistake().camera) || says("it has a line for each column")) {
    return expect_among(sentences, mistake().sentence);
  }
  EXPECT_EQ(sentences, Sentences{as_named(mistake(), sentences).sentence});
}

INSTANTIATE_TEST_SUITE_P(OnTheWay, EachMistake, testing::ValuesIn(indices(true)));
INSTANTIATE_TEST_SUITE_P(OfHits, EachMistake, testing::ValuesIn(indices(false)));

using EachMistakeInRays = EachMistake;

TEST_P(EachMistakeInRays, IsAmongTheExplanationsOfOnlyRays) {
  if (!who_may_make(mistake())) return;
  Candidate candidate;
  candidate.pixel_rays = mistake().candidate.pixel_rays;
  candidate.focal_rays = mistake().candidate.focal_rays;
  const Sentences sentences = sentences_for(candidate);
  expect_among(sentences, as_named(mistake(), sentences).sentence);
}

INSTANTIATE_TEST_SUITE_P(Classic, EachMistakeInRays, testing::ValuesIn(indices(true)));

using EachMistakeInHits = EachMistake;

TEST_P(EachMistakeInHits, IsAmongTheExplanationsOfOnlyNearestSpheres) {
  const auto may = who_may_make(mistake());
  Candidate candidate;
  candidate.interface.returns = may->interface.returns;
  candidate.declared = may->declared;
  candidate.nearest = mistake().candidate.nearest;
  const Sentences sentences = sentences_for(candidate);
  if (sentences == Sentences{std::string(kTooFewErrors)}) return;
  if (mistake().hit) {
    EXPECT_EQ(sentences, Sentences());
  } else {
    expect_among(sentences, as_named(mistake(), sentences).sentence);
  }
}

using EachMistakeInPicks = EachMistake;

TEST_P(EachMistakeInPicks, IsAmongTheExplanationsOfOnlyPicks) {
  if (!who_may_make(mistake())) return;
  // Rays with the direction 0 get no answer.
  for (const char* zero : {"the axes are lost: all are zero", "are taken for 0"}) {
    if (mistake().sentence.find(zero) != std::string::npos) return;
  }
  Candidate candidate;
  candidate.pick = [made = mistake().candidate](
                       const scene::Camera& camera, const scene::Conventions& by,
                       Candidate::Pixels pixels, Candidate::Spheres spheres) {
    return made.intersect(made.rays_from(by.origin)(camera, by, pixels), spheres, by);
  };
  const Sentences sentences = sentences_for(candidate);
  if (sentences == Sentences{std::string(kTooFewErrors)}) return;
  expect_among(sentences, as_named(mistake(), sentences).sentence);
}

INSTANTIATE_TEST_SUITE_P(Classic, EachMistakeInPicks, testing::ValuesIn(indices(true)));
INSTANTIATE_TEST_SUITE_P(Classic, EachMistakeInHits, testing::ValuesIn(indices(false)));

/// Exceptions: for methods that compute d^2 as a difference, lost digits are reported, and for
/// overflows "not a number".
TEST(AnswerExplanation, IsEmptyForARightCandidateOnHardCases) {
  const std::set<std::string_view> differences = {"quadratic", "stable-quadratic", "lecture",
                                                  "kahan"};
  for (const auto* rays : fast::pixel_ray_methods()) {
    for (const auto* intersect : fast::intersect_methods()) {
      if (rays != &fast::kDirectRays && intersect != &fast::kCross) continue;
      const Candidate candidate = fast_candidate(*rays, *intersect);
      for (const CaseSource& source : case_sources()) {
        for (int severity = 0; severity <= (source.severities ? source.severities->highest : 0);
             ++severity) {
          std::vector<Case> cases;
          for (std::uint64_t seed = 1; seed <= 5; ++seed)
            cases.push_back(source.make(severity, seed));
          for (const std::string& sentence : sentences_for(candidate, cases)) {
            const bool is_lost = differences.contains(intersect->name) &&
                                 sentence.starts_with("d^2 loses its digits");
            const bool is_eye = rays->name == std::string_view("lecture") &&
                                sentence.starts_with("E is added to P and subtracted again");
            EXPECT_TRUE(is_lost || is_eye || sentence == kNotNumbers)
                << candidate.name << " " << source.name << severity << ": " << sentence;
          }
        }
      }
    }
  }
}

TEST(AnswerExplanation, OfTwoMistakesAtOnceNamesBoth) {
  const auto both = [](const char* one, const char* other) {
    return candidate_with(std::array{find_mistake(one), find_mistake(other)});
  };
  const std::vector<Case> cases = cases_of({"cameras", "plain-cameras", "rays"}, 12);
  const auto expect_both = [&](const Candidate& candidate, const char* sentence) {
    expect_among(sentences_for(candidate, cases), sentence);
  };
  Candidate candidate = both("rows are upside down", "top is taken from right");
  candidate.frame = nullptr;
  candidate.pixel_points = nullptr;
  expect_both(candidate, "rows are upside down; and top is taken from right");
  candidate = both("i/w and j/h place the pixels", "directions are not normalised: D = P - E");
  candidate.pixel_points = nullptr;
  expect_both(candidate,
              "i/w and j/h place the pixels; and directions are not normalised: D = P - E");
  const char* const centred =
      "the image plane is taken to be centred: left is -right and bottom is -top";
  candidate = both(centred, "i/w and j/h place the pixels");
  expect_both(candidate, (std::string(centred) + "; and i/w and j/h place the pixels").c_str());
  expect_both(
      both("s >= 0 is not tested: spheres behind the origin are hit", "s is half of the right one"),
      "s >= 0 is not tested: spheres behind the origin are hit; and s is half of the right "
      "one");
  // Two formulas give the same answers.
  candidate = candidate_of("U has the wrong sign");
  candidate.frame = [right = candidate_of("V is up itself, not made perpendicular to W").frame,
                     left = candidate.frame](const scene::Camera& camera) {
    return FrameAnswer{left(camera).U, right(camera).V, left(camera).W};
  };
  EXPECT_EQ(sentences_for(candidate), Sentences());
}

// Both together shift only the rows, and so explain a shift that is neither of them.
TEST(AnswerExplanation, DoesNotPlacePixelsTwice) {
  EXPECT_FALSE(can_be_together(
      *find_mistake("i/w and j/h place the pixels"),
      *find_mistake("(i+1)/w and (j+1)/h place the pixels, j counted from the other end")));
}

TEST(AnswerExplanation, OfOnlyRaysDoesNotNameHits) {
  Candidate candidate;
  candidate.focal_rays = candidate_of("directions are not normalised: D = P - E").focal_rays;
  EXPECT_EQ(sentences_for(candidate), Sentences{"directions are not normalised: D = P - E"});
}

/// A case with two rays to a large sphere; one hits it.
Case large_sphere() {
  Case the_case;
  the_case.scene.spheres = {{{0, 0, 1e5}, 5e4}};
  the_case.scene.rays = {{{}, {0, 0.1, 1}}, {{}, {0, 0.7, 1}}};
  return the_case;
}

TEST(AnswerExplanation, OfOneWrongAnswerNeedsItsNumbers) {
  for (const char* miss : {"no ray ever hits a sphere",
                           "r^2 is an integer of 32 bits: it wraps around from a radius of 46,341 "
                           "on"}) {
    EXPECT_EQ(sentences_for(candidate_of(miss), {large_sphere()}),
              Sentences{std::string(kTooFewErrors)});
  }
  const char* far = "the far root is taken for the near one";
  EXPECT_EQ(sentences_for(candidate_of(far), {large_sphere()}), Sentences{far});
}

TEST(AnswerExplanation, IsFoundForEachPart) {
  Candidate candidate = candidate_of("rows are upside down");
  candidate.intersect = candidate_of("the far root is taken for the near one").intersect;
  candidate.nearest = candidate_of("the last sphere in the file wins").nearest;
  const std::vector<AnswerCause> causes = answer_causes(fixed_cases(), candidate);
  ASSERT_EQ(causes.size(), 3u);
  EXPECT_EQ(causes[0].step, Step::kPixelPoint);
  EXPECT_EQ(causes[1].step, Step::kIntersect);
  EXPECT_EQ(causes[2].step, Step::kNearest);
  EXPECT_EQ(sentences_for(candidate),
            (Sentences{"rows are upside down", "the far root is taken for the near one",
                       "the last sphere in the file wins"}));
  // A wrong root is reason enough for a wrong sphere.
  candidate.nearest = candidate_of("the far root is taken for the near one").nearest;
  EXPECT_EQ(sentences_for(candidate),
            (Sentences{"rows are upside down", "the far root is taken for the near one"}));
  candidate.intersect = nullptr;
  candidate.nearest = candidate_of("the last sphere in the file wins").nearest;
  EXPECT_EQ(sentences_for(candidate),
            (Sentences{"rows are upside down", "the last sphere in the file wins"}));
}

/// The candidate returns the last sphere in the file, hit or not. "The last sphere in the file
/// wins" explains only part of that.
TEST(AnswerExplanation, ContradictsFewAnswers) {
  Candidate candidate;
  candidate.nearest = [](Candidate::Rays rays, Candidate::Spheres spheres, const auto&) {
    const std::optional<std::size_t> last =
        spheres.empty() ? std::nullopt : std::optional(spheres.size() - 1);
    return std::vector(rays.size(), last);
  };
  EXPECT_EQ(sentences_for(candidate), Sentences());
}

TEST(AnswerExplanation, OfNaNNamesAMistakeThatMakesNaN) {
  constexpr const char* kLost = "the axes are lost: all are zero";
  Candidate candidate;
  candidate.pixel_rays = candidate.focal_rays = [](const auto&, const auto&, auto pixels) {
    return std::vector<scene::Ray>(pixels.size(), {{kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}});
  };
  EXPECT_EQ(sentences_for(candidate), Sentences{"the answer is NaN or infinite"});
  candidate.pixel_rays = candidate_of(kLost).pixel_rays;
  candidate.focal_rays = candidate_of(kLost).focal_rays;
  EXPECT_EQ(sentences_for(candidate), Sentences{kLost});
}

TEST(AnswerExplanation, NamesOtherCausesBesideNaN) {
  constexpr const char* kWrong = "s >= 0 is not tested: spheres behind the origin are hit";
  Candidate candidate = candidate_of(kWrong);
  candidate.nearest = nullptr;
  const auto all = sentences_for(candidate);
  candidate.intersect = [count = 0, ask = candidate.intersect](
                            Candidate::Rays rays, Candidate::Spheres spheres,
                            const scene::Conventions& conventions) mutable {
    std::vector<SphereHits> hits = ask(rays, spheres, conventions);
    for (SphereHits& its : hits) {
      for (RayHit& one : its) {
        if (++count % 20 == 0) one.hit = {kNaN, {kNaN, kNaN, kNaN}};
      }
    }
    return hits;
  };
  EXPECT_EQ(all, Sentences{kWrong});
  EXPECT_EQ(sentences_for(candidate), (Sentences{kWrong, "the answer is NaN or infinite"}));
  const auto found = explanations(answer_causes(fixed_cases(), candidate));
  EXPECT_EQ(found[1].errors, found[0].errors + found[1].explained);
}

TEST(AnswerExplanation, SkipsCasesOnWhichTheCandidateFails) {
  Candidate candidate = candidate_of("U and W have the wrong sign, as by W = A - E");
  int asked = 0;
  candidate.frame = [&asked, base = candidate.frame](const scene::Camera& camera) {
    if (++asked % 3 == 0) throw std::runtime_error("it exited with 1");
    if (asked % 3 == 1) throw std::invalid_argument("camera.up");
    return base(camera);
  };
  EXPECT_EQ(sentences_for(candidate), Sentences{"U and W have the wrong sign, as by W = A - E"});
}

TEST(AnswerExplanation, OfACandidateInSinglePrecisionIsFound) {
  const auto rounded = [](scene::Vector3 v) {
    for (double* x : {&v.x, &v.y, &v.z})
      *x = static_cast<double>(static_cast<float>(*x) * 1.00001F);
    return v;
  };
  for (const char* sentence : {"V has the wrong sign", "the axes are those of the world"}) {
    Candidate candidate = candidate_of(sentence);
    candidate.frame = [rounded, base = candidate.frame](const scene::Camera& camera) {
      FrameAnswer axes = base(camera);
      for (scene::UnitVector3* axis : {&axes.U, &axes.V, &axes.W}) {
        const scene::Vector3 coarse = rounded({axis->x, axis->y, axis->z});
        *axis = {coarse.x, coarse.y, coarse.z};
      }
      return axes;
    };
    EXPECT_EQ(sentences_for(candidate), Sentences{sentence});
  }
}

/// direct/cross with every hit changed.
template <class Change>
Candidate with_hits(const Change& change) {
  Candidate candidate = fast_candidate(fast::kDirectRays, fast::kCross);
  answer_by(candidate, [ask = hits_of(candidate), change](
                           Candidate::Rays rays, const scene::Sphere& sphere, const auto& asked) {
    std::vector<Hit> hits = ask(rays, sphere, asked);
    for (std::size_t k = 0; k < hits.size(); ++k) {
      if (hits[k]) change(rays[k], sphere, hits[k]);
    }
    return hits;
  });
  return candidate;
}

/// Roundings of d^2 move s, but do not move Q off the ray.
TEST(AnswerExplanation, OfAWrongPointDoesNotNameRoundings) {
  const Candidate candidate = with_hits([](const auto& ray, const auto& sphere, Hit& hit) {
    hit->point = hit_at(ray, sphere.radius).point;
  });
  EXPECT_EQ(sentences_for(candidate), Sentences());
}

/// Code that misses only far spheres does not miss everything, and has no wrong sign.
TEST(AnswerExplanation, OfMissedFarSpheresNamesNoMistakeThatMissesNearOnes) {
  const Candidate candidate = with_hits([](const auto& ray, const auto& sphere, Hit& hit) {
    const scene::Vector3 T = sphere.centre - ray.origin;
    if (std::hypot(T.x, T.y, T.z) > 100 * sphere.radius) hit.reset();
  });
  const CampaignResult result = run_campaign(*find_law("class"), candidate, {});
  ASSERT_EQ(result.finding(), Finding::kBroken);
  EXPECT_TRUE(causes(*find_law("class"), telling_cases(result, kCasesOfACause), candidate).empty());
}

/// From a point on the sphere, s is half the chord: neither a root nor lost digits.
TEST(AnswerExplanation, OfAPointBetweenTheRootsDoesNotNameRoundings) {
  const scene::Sphere sphere = {{0, 0, 5}, 3};
  const scene::Ray ray = {{0, 0, 2}, {0.6, 0, 0.8}};
  const PossibleHit hit = possible_hit(Arithmetic::kDifference, ray, sphere, {});
  EXPECT_TRUE(hit.allows(0));
  EXPECT_TRUE(hit.allows(4.8));
  EXPECT_FALSE(hit.allows(2.4));
  EXPECT_FALSE(hit.allows(4.9));
}

Sentences sentences_of_hits(const AskSphere& ask) {
  Candidate candidate = fast_candidate(fast::kDirectRays, fast::kCross);
  answer_by(candidate, ask);
  Sentences sentences;
  const CampaignResult result = run_campaign(*find_law("parameter"), candidate, {});
  const auto telling = [&](std::size_t round) {
    return telling_cases(result, kCasesOfACause, round);
  };
  for (const Explanation& one : causes(*find_law("parameter"), telling, candidate)) {
    sentences.push_back(one.sentence);
  }
  return sentences;
}

Sentences sentences_of_roots(const MakeRoots& roots) {
  return sentences_of_hits(hits_by({.roots = roots}));
}

using SquareOfChord = double (*)(const scene::Vector3& L, const scene::Vector3& C,
                                 const scene::Vector3& T, double v, double r);

double dot(const scene::Vector3& a, const scene::Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The roots v - d and v + d for another d^2.
MakeRoots roots_of(SquareOfChord square) {
  return [square](const scene::Ray& ray, const scene::Sphere& sphere) {
    const scene::Vector3 L = {ray.origin.x, ray.origin.y, ray.origin.z}, D = ray.direction;
    const scene::Vector3 C = {sphere.centre.x, sphere.centre.y, sphere.centre.z};
    const scene::Vector3 T = sphere.centre - ray.origin;
    const double size = std::sqrt(dot(D, D)), v = dot(T, D) / size;
    const double d_sq = square(L, C, T, v, sphere.radius), d = std::sqrt(d_sq);
    return fast::Roots{v, d_sq, (v - d) / size, (v + d) / size};
  };
}

TEST(AnswerExplanation, OfLostDigitsNamesTheTermAndTheDistance) {
  const auto expect = [](SquareOfChord square, const char* said) {
    const Sentences sentences = sentences_of_roots(roots_of(square));
    ASSERT_EQ(sentences.size(), 1u) << said;
    EXPECT_TRUE(sentences.front().starts_with(said)) << sentences.front();
  };
  expect([](auto&, auto&, auto& T, double v, double r) { return r * r - (dot(T, T) - v * v); },
         "d^2 loses its digits, because it is the difference of much larger numbers; "
         "r^2 - |T x D|^2 keeps them (the wrong cases examined are at 10^");
  // (r + l)(r - l)
  expect(
      [](auto&, auto&, auto& T, double v, double r) {
        const double l = std::sqrt(dot(T, T) - v * v);
        return (r + l) * (r - l);
      },
      "d^2 loses its digits, because it is the difference of much larger numbers; "
      "r^2 - |T x D|^2 keeps them (the wrong cases examined are at 10^");
  expect([](auto& L, auto& C, auto&, double v,
            double r) { return r * r - (dot(C, C) - 2 * dot(L, C) + dot(L, L) - v * v); },
         "|C - L|^2 loses its digits far from the world's origin");
  Candidate in_floats = fast_candidate(fast::kDirectRays, fast::kCross);
  in_floats.precision = scene::Precision::kSingle;
  answer_by(in_floats, hits_by({.roots = roots_of([](auto& L, auto& C, auto&, double v, double r) {
                                  const auto f = [](double x) { return static_cast<float>(x); };
                                  return double{f(r * r) - (f(dot(C, C)) - f(2 * dot(L, C)) +
                                                            f(dot(L, L)) - f(v * v))};
                                })}));
  std::vector<Case> far;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    far.push_back(find_case_source("far-world")->make(3, seed));
  }
  const Sentences of_floats = sentences_for(in_floats, far);
  ASSERT_EQ(of_floats.size(), 1u) << testing::PrintToString(of_floats);
  EXPECT_TRUE(of_floats.front().starts_with("in floats |C - L|^2 loses its digits"))
      << of_floats.front();
}

/// Cases in which other roots count are left out. If most cases are left out, nothing is named.
TEST(AnswerExplanation, OfLostDigitsNeedsMostCases) {
  Candidate candidate = fast_candidate(fast::kDirectRays, fast::kCross);
  answer_by(candidate, hits_by({.roots = roots_of([](auto&, auto&, auto& T, double v, double r) {
                                  return r * r - (dot(T, T) - v * v);
                                })}));
  std::vector<Case> cases = cases_of({"rays"}, 20);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    cases.push_back(find_case_source("inside")->make(0, seed));
    cases.push_back(find_case_source("distance")->make(3, seed));
  }
  EXPECT_EQ(sentences_for(candidate, cases).size(), 1u);
  candidate.declared.valid = scene::ValidRoots{.t_max = 1, .culling = scene::Culling::kNone};
  EXPECT_EQ(sentences_for(candidate, cases), Sentences());
}

/// For origins on the sphere, roots are tiny, and nearby inputs have others.
TEST(AnswerExplanation, IsEmptyForErrorsWithinTheRoundingOfTheInput) {
  const Candidate candidate = with_hits([](const auto& ray, const auto&, Hit& hit) {
    if (hit->parameter < 1e-12) *hit = hit_at(ray, 2 * hit->parameter);
  });
  std::vector<Case> cases = cases_of({"rays", "cameras"}, 20);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    cases.push_back(find_case_source("surface")->make(15, seed));
  }
  EXPECT_EQ(sentences_for(candidate, cases), Sentences());
}

/// Some easy cases give NaN; harder ones lose digits.
TEST(AnswerExplanation, NamesAnotherCauseAtAnotherLevel) {
  const MakeRoots naive = roots_of(
      [](auto&, auto&, auto& T, double v, double r) { return r * r - (dot(T, T) - v * v); });
  const auto roots = [naive](const scene::Ray& ray, const scene::Sphere& sphere) {
    const scene::Vector3 T = sphere.centre - ray.origin;
    const bool is_far = std::sqrt(dot(T, T)) > 1e4 * sphere.radius;
    fast::Roots its = is_far ? naive(ray, sphere) : fast::kCross.roots(ray, sphere);
    if (!is_far && ray.direction.x > 0 && ray.direction.y > 0) its.smaller = its.larger = kInfinity;
    return its;
  };
  const Sentences sentences = sentences_of_roots(roots);
  ASSERT_EQ(sentences.size(), 2u) << testing::PrintToString(sentences);
  EXPECT_EQ(sentences.front(), kNotNumbers);
  EXPECT_TRUE(sentences.back().starts_with("d^2 loses its digits")) << sentences.back();
}

TEST(AnswerExplanation, NamesAnEyeThatIsAddedAndSubtracted) {
  Case far = cases_of({"plain-cameras"}, 1).front();
  scene::Camera& camera = far.scene.camera.emplace();
  camera.eye = {1e4, 2e3, 3e3};
  camera.look_at = {1e4, 2e3, 2990};
  camera.up = {0, 1, 0};
  camera.near = camera.left = camera.bottom = -1;
  camera.right = camera.top = 1;
  camera.width = camera.height = 8;
  far.pixels = all_pixels(camera);
  far.scene.conventions.origin = scene::Origin::kFocal;
  Candidate candidate;
  candidate.focal_rays = [points = fast_candidate(fast::kDirectRays, fast::kCross).pixel_points](
                             const scene::Camera& given, const auto&... asked) {
    std::vector<scene::Ray> rays;
    for (const scene::Point3& P : points(given, asked...)) {
      const scene::Vector3 g = P - given.eye;
      const double size = std::sqrt(dot(g, g));
      rays.push_back({given.eye, {g.x / size, g.y / size, g.z / size}});
    }
    return rays;
  };
  const Sentences sentences = sentences_for(candidate, {far});
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_TRUE(sentences.front().starts_with("E is added to P and subtracted again"));
  EXPECT_EQ(sentences_for(candidate, cases_of({"cameras"}, 40)), Sentences());
}

TEST(AnswerExplanation, NamesAQThatCancelsByTheLargerRoot) {
  const auto by_q = [](double sign) {
    return [sign](const scene::Ray& ray, const scene::Sphere& sphere) {
      fast::Roots roots = fast::kCross.roots(ray, sphere);
      const scene::Vector3 T = sphere.centre - ray.origin, D = ray.direction;
      const double t = std::hypot(T.x, T.y, T.z), size = std::hypot(D.x, D.y, D.z);
      const double d = std::sqrt(roots.half_chord_sq), r = sphere.radius;
      const double q = roots.axial_distance + sign * std::copysign(d, roots.axial_distance);
      if (q == 0) return roots;
      std::tie(roots.smaller, roots.larger) = std::minmax({q / size, (t - r) * (t + r) / q / size});
      return roots;
    };
  };
  EXPECT_EQ(sentences_of_roots(by_q(1)), Sentences());
  EXPECT_EQ(sentences_of_roots(by_q(-1)),
            Sentences{"q = b + sgn(b) sqrt(b^2 - ac) has the wrong inner sign: it cancels"});
}

TEST(AnswerExplanation, IsJudgedUnderTheDeclaredConventions) {
  Candidate candidate = candidate_of("pixels are sampled at their centres");
  EXPECT_EQ(sentences_for(candidate), Sentences{"pixels are sampled at their centres"});
  candidate.declared.samples = scene::Samples::kCentres;
  EXPECT_EQ(sentences_for(candidate), Sentences());
  candidate.declared.samples = scene::Samples::kCorners;
  EXPECT_EQ(sentences_for(candidate), Sentences{"pixels are sampled at their centres"});
  candidate = candidate_of("i/w and j/h place the pixels");
  EXPECT_EQ(sentences_for(candidate), Sentences{"i/w and j/h place the pixels"});
  candidate.declared.samples = scene::Samples::kCorners;
  EXPECT_EQ(sentences_for(candidate), Sentences());
}

}  // namespace
}  // namespace raycheck::properties
