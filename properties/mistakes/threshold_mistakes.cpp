// Comparisons with a number where there should be none: with an epsilon that is too large instead
// of zero, or with a largest s. Of a family the first that makes the same answers, which drops the
// fewest, is named: the actual number may be beyond.

#include <array>
#include <cstdlib>
#include <functional>
#include <span>
#include <string>

#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {
namespace {

using fast::Roots;
using scene::Conventions;
using scene::Ray;

/// The sizes that are told apart, the one that drops the fewest first.
constexpr std::array<const char*, 10> kSizes = {"1e-9", "1e-8",  "1e-7", "1e-6", "1e-5",
                                                "1e-4", "0.001", "0.01", "0.1",  "1"};
constexpr std::array<const char*, 8> kLargeSizes = {"1e9", "1e8", "1e7",  "1e6",
                                                    "1e5", "1e4", "1000", "100"};

/// A family of mistakes, with sentences before and after the size.
struct ThresholdFamily {
  const char* before;
  const char* after;
  std::string_view family;
  std::span<const char* const> sizes;
  Hit (*choose)(double size, const Ray&, const Roots&, const Conventions&);
  bool of_steps = false;  ///< s is in multiples of P - E: directions are not normalised.
};

Hit up_to(double most, const Ray& ray, const Roots& roots, const Conventions& c) {
  const Hit hit = usual_choice(ray, roots, c);
  return hit && hit->parameter <= most ? hit : Hit();
}

const ThresholdFamily kFamilies[] = {
    {"hits with an s below about ", " (perhaps more) are dropped: the epsilon is too large",
     "dropped hits", kSizes,
     [](double least, const Ray& ray, const Roots& roots, const Conventions& c) {
       const Hit hit = usual_choice(ray, roots, c);
       return hit && hit->parameter >= least ? hit : Hit();
     }},
    {"where the near root is below about ",
     " (perhaps more) the far one is taken: the epsilon is too large", "far roots", kSizes,
     [](double least, const Ray& ray, const Roots& roots, const Conventions& c) {
       const Hit hit = usual_choice(ray, roots, c);
       if (!hit || hit->parameter >= least) return hit;
       const bool takes_far = c.root != scene::Root::kSmaller && roots.larger >= least;
       return takes_far ? Hit(hit_at(ray, roots.larger)) : Hit();
     }},
    {"a d^2 below about ", " (perhaps more) counts as a miss: the epsilon is too large",
     "dropped chords", kSizes,
     [](double least, const Ray& ray, const Roots& roots, const Conventions& c) {
       return roots.half_chord_sq >= least ? usual_choice(ray, roots, c) : Hit();
     }},
    {"hits with an s above about ",
     " (perhaps less) are dropped: the largest s that counts is too small", "far hits", kLargeSizes,
     up_to},
    {"hits with an s above about ",
     " (perhaps less), in multiples of P - E, are dropped: the largest s that counts is too small",
     "far hits", kLargeSizes, up_to, true},
};

}  // namespace

std::vector<Mistake> threshold_mistakes() {
  std::vector<Mistake> all;
  for (const auto& [before, after, family, sizes, choose, of_steps] : kFamilies) {
    for (const char* size : sizes) {
      all.push_back({.sentence = std::string(before) + size + after,
                     .step = Step::kIntersect,
                     .hits = {.choose = std::bind_front(choose, std::atof(size))},
                     .family = family});
      if (!of_steps) continue;
      all.back().is_told_by_answers = false;
      all.back().rays.direction = [](auto&, auto&, const scene::Vector3& g) { return g; };
    }
  }
  return all;
}

}  // namespace raycheck::properties
