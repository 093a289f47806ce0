// Laws for candidates whose hit, for a ray that starts inside a sphere, is the start of the ray or
// the near root.

#include "properties/search/campaign.h"
#include "tests/properties/one_ray.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

using contract::FromInside;
using Answer = std::optional<HitAnswer>;
const Answer kMiss;

/// From x along the axis, forward or backward, with the unit sphere around 0.
Case from(double x, double direction = 1) {
  return one_ray({{x, 0, 0}, {direction, 0, 0}}, {{0, 0, 0}, 1});
}
/// From 1/2: roots -3/2 and 1/2.
const Case kInside = from(0.5);
const Answer kStart = HitAnswer{0, {0.5, 0, 0}}, kNear = HitAnswer{-1.5, {-1, 0, 0}},
             kFar = HitAnswer{0.5, {1, 0, 0}};

struct Judged {
  std::uint64_t right, wrong, defects;
  std::string left_out;
  bool operator==(const Judged&) const = default;
};
std::ostream& operator<<(std::ostream& to, const Judged& its) {
  return to << its.right << " right, " << its.wrong << " wrong, " << its.defects << " defects, "
            << its.left_out;
}

Judged judged(std::string_view law, Case the_case, Candidate candidate, FromInside from_inside,
              const scene::Conventions& conventions = {}) {
  candidate.interface.from_inside = from_inside;
  the_case.scene.conventions = conventions;
  const Verdict found = judge(law, the_case, candidate);
  return {found.compared() - found.discrepancies(), found.discrepancies(),
          found.count(Standing::kDefect), found.reason_left_out()};
}
Judged judged(std::string_view law, const Case& the_case, const Answer& answer,
              FromInside from_inside, const scene::Conventions& conventions = {}) {
  return judged(law, the_case, that_answers(answer), from_inside, conventions);
}

const std::vector<scene::Conventions> kConventions = [] {
  std::vector<scene::Conventions> all(5);
  all[1].root = scene::Root::kSmaller;
  all[2].valid.t_max = 0.25;  // the segment ends inside
  all[3].valid.ends = scene::Ends::kOpen;
  all[4].valid.culling = scene::Culling::kBackFaces;
  return all;
}();

TEST(FromInside, IsTheStartOrTheNearRootUnderAllConventions) {
  const Judged right{1, 0, 0, ""}, defect{0, 1, 1, ""};
  for (const scene::Conventions& by : kConventions) {
    for (const auto& [from_inside, its] :
         {std::pair(FromInside::kStart, kStart), {FromInside::kNearRoot, kNear}}) {
      for (const Answer& answer : {kStart, kNear, kFar}) {
        EXPECT_EQ(judged("class", kInside, answer, from_inside, by), right);
        EXPECT_EQ(judged("nearest-root", kInside, answer, from_inside, by),
                  answer->parameter == its->parameter                              ? right
                  : from_inside == FromInside::kNearRoot && answer->parameter == 0 ? right
                                                                                   : defect);
      }
      EXPECT_EQ(judged("class", kInside, kMiss, from_inside, by), defect);
    }
  }
}

TEST(FromInside, HasAnSAndAPoint) {
  const auto discrepancies = [](const char* law, const Answer& answer, FromInside from_inside) {
    return judged(law, kInside, answer, from_inside).wrong;
  };
  EXPECT_EQ(discrepancies("parameter", kNear, FromInside::kNearRoot), 0u);
  EXPECT_EQ(discrepancies("parameter", kStart, FromInside::kNearRoot), 1u);
  EXPECT_EQ(discrepancies("hit-point", kNear, FromInside::kNearRoot), 0u);
  EXPECT_EQ(discrepancies("hit-point", kStart, FromInside::kStart), 0u);
  EXPECT_EQ(discrepancies("hit-point", HitAnswer{0, {0.5 + 1e-12, 0, 0}}, FromInside::kStart), 1u);
  EXPECT_EQ(discrepancies("parameter", kStart, FromInside::kStart), 0u);
  for (const auto& [s, is_wrong] : {std::pair(-0x1p-53, false), {0x1p-53, false}, {0.5, true}}) {
    Candidate candidate = that_answers(HitAnswer{s, {0.5 + s, 0, 0}});
    candidate.interface.returns = Returns::kPoint;  // s is its projection
    const Judged found = judged("nearest-root", kInside, candidate, FromInside::kStart);
    EXPECT_EQ(found.defects, is_wrong ? 1u : 0u) << s;
  }
}

/// A ray that starts on the sphere, up to roundings, may start inside or outside.
TEST(FromInside, IsExcusedWhereRoundingsDecideWhetherItIsInside) {
  const auto at = [](double s) { return Answer(HitAnswer{s, {}}); };
  for (const auto& [from_inside, is_start] :
       {std::pair(FromInside::kStart, true), {FromInside::kNearRoot, false}}) {
    for (const scene::Conventions& by : kConventions) {
      const bool is_cut = by.valid.t_max < 1 || by.root == scene::Root::kSmaller ||
                          by.valid.culling == scene::Culling::kBackFaces;
      const auto defects = [&](double x, double direction, const Answer& answer) {
        std::uint64_t count = 0;
        for (const char* law : {"class", "nearest-root"}) {
          count += judged(law, from(x, direction), answer, from_inside, by).defects;
        }
        return count;
      };
      for (const double x : {1 - 0x1p-53, 1.0, 1 + 0x1p-52}) {
        // Leaving the sphere: from inside, or past it.
        EXPECT_EQ(defects(x, 1, is_start ? at(0) : at(-2)), 0u) << x << is_start;
        EXPECT_EQ(defects(x, 1, kMiss), 0u) << x << is_start;
        // Entering it: from inside, or from outside.
        EXPECT_EQ(defects(x, -1, at(0)), 0u) << x << is_start;
        if (by.valid.ends == scene::Ends::kClosed && !is_cut) {
          EXPECT_EQ(defects(x, -1, at(0x1p-52)), 0u) << x << is_start;
        }
      }
      for (const double apart : {-0x1p-30, 0x1p-30}) {
        const Answer inside = is_start ? at(0) : at(-2 - apart);
        EXPECT_EQ(defects(1 + apart, 1, inside), apart < 0 ? 0u : 1u) << apart << is_start;
        EXPECT_EQ(defects(1 + apart, 1, kMiss), apart < 0 ? 1u : 0u) << apart << is_start;
      }
      // From deep inside no other answer is excused.
      EXPECT_GT(defects(0.5, 1, kMiss), 0u);
      EXPECT_GT(defects(0.5, 1, kFar), 0u);
    }
  }
}

/// The exact answers by a declaration, except to rays that start at x > `limit`, which hit at
/// roots.
Candidate follower(FromInside from_inside, double limit = kInfinity) {
  Candidate candidate;
  candidate.refuses = false;
  candidate.interface.from_inside = from_inside;
  candidate.intersect = [=](Candidate::Rays rays, Candidate::Spheres spheres, const auto& by) {
    std::vector<SphereHits> all(spheres.size());
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      for (std::size_t ray = 0; ray < rays.size(); ++ray) {
        const reference::ExactRay exact(rays[ray]);
        const auto its = rays[ray].origin.x > limit ? FromInside::kRoot : from_inside;
        const auto at = exact_intersection(exact, spheres[k], by, its);
        if (!reference::counts_as_hit(at.hit_class, by.tangent)) continue;
        const bool is_start = its == FromInside::kStart && starts_inside(exact, spheres[k]);
        all[k].push_back({ray, is_start ? HitAnswer{0, rays[ray].origin}
                                        : HitAnswer{exact.rounded_parameter(spheres[k], at),
                                                    exact.rounded_point(spheres[k], at)}});
      }
    }
    return all;
  };
  return candidate;
}

TEST(FromInside, KeepsTheLawsThatRelateAnswers) {
  Case several = kInside;
  several.scene.rays.push_back({{-5, 0.5, 0}, {1, 0, 0}});
  several.scene.spheres.push_back({{0.25, 0, 0}, 0.5});
  for (const auto from_inside : {FromInside::kStart, FromInside::kNearRoot}) {
    for (const char* law : {"class", "nearest-root", "parameter", "backward-error", "hit-point",
                            "scaling", "axes", "growing-radius"}) {
      const Judged found = judged(law, several, follower(from_inside), from_inside);
      EXPECT_GT(found.right, 0u) << law;
      EXPECT_EQ(found.wrong, 0u) << law;
    }
    EXPECT_GT(judged("scaling", several, follower(from_inside, 1), from_inside).defects, 0u);
  }
}

/// Several spheres may hold the start.
TEST(FromInside, LeavesTheNearestSphereUnjudged) {
  Case several = kInside;
  several.scene.spheres.push_back({{5, 0, 0}, 1});
  Candidate candidate;
  candidate.nearest = [](Candidate::Rays rays, auto&&...) {
    return std::vector(rays.size(), std::optional<std::size_t>(1));
  };
  for (const auto from_inside : {FromInside::kStart, FromInside::kNearRoot}) {
    const Judged found = judged("nearest-sphere", several, candidate, from_inside);
    EXPECT_EQ(found.right + found.wrong, 0u);
    EXPECT_TRUE(has(found.left_out, "rays that start inside a sphere"));
  }
  EXPECT_EQ(judged("nearest-sphere", several, candidate, FromInside::kRoot).defects, 1u);
}

TEST(FromInside, IsDeclaredOnlyWhereTheStartIsARootThatMayCount) {
  for (const auto& [contract, count] : {std::pair("from_inside start", 0u),
                                        {"from_inside near-root; t_min -inf", 0u},
                                        {"from_inside start; t_min 1e-4", 1u},
                                        {"from_inside near-root; roots as-asked", 1u}}) {
    contract::Declarations declared;
    contract::declare_all(contract, declared);
    EXPECT_EQ(contract::defects(declared).size(), count) << contract;
  }
}

}  // namespace
}  // namespace raycheck::properties
