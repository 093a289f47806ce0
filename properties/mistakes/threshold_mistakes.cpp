// Comparisons with a number where there should be none: with an epsilon that is too large instead
// of zero, or with a largest s. Of a family the first that makes the same answers, which drops the
// fewest, is named: the actual number may be beyond.

#include <array>
#include <cstdlib>
#include <utility>

#include "properties/mistakes/altered_hits.h"
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

Mistake threshold(const std::string& before, const std::string& after, const char* size,
                  std::string_view family, const ChooseHit& choose) {
  Mistake mistake = hit_mistake(before + size + after, {.choose = choose});
  mistake.family = family;
  return mistake;
}

Mistake drops_near_hits(const char* size) {
  return threshold(
      "hits with an s below about ", " (perhaps more) are dropped: the epsilon is too large", size,
      "dropped hits",
      [least = std::atof(size)](const Ray& ray, const Roots& roots, const Conventions& c) {
        const Hit hit = usual_choice(ray, roots, c);
        return hit && hit->parameter >= least ? hit : Hit();
      });
}

Mistake takes_far_root(const char* size) {
  return threshold(
      "where the near root is below about ",
      " (perhaps more) the far one is taken: the epsilon is too large", size, "far roots",
      [least = std::atof(size)](const Ray& ray, const Roots& roots, const Conventions& c) -> Hit {
        const Hit hit = usual_choice(ray, roots, c);
        if (!hit || hit->parameter >= least) return hit;
        if (c.root == scene::Root::kSmaller || !(roots.larger >= least)) return {};
        return hit_at(ray, roots.larger);
      });
}

Mistake drops_small_chords(const char* size) {
  return threshold(
      "a d^2 below about ", " (perhaps more) counts as a miss: the epsilon is too large", size,
      "dropped chords",
      [least = std::atof(size)](const Ray& ray, const Roots& roots, const Conventions& c) {
        return roots.half_chord_sq >= least ? usual_choice(ray, roots, c) : Hit();
      });
}

Mistake drops_far_hits(const char* size) {
  return threshold(
      "hits with an s above about ",
      " (perhaps less) are dropped: the largest s that counts is too small", size, "far hits",
      [most = std::atof(size)](const Ray& ray, const Roots& roots, const Conventions& c) {
        const Hit hit = usual_choice(ray, roots, c);
        return hit && hit->parameter <= most ? hit : Hit();
      });
}

}  // namespace

std::vector<Mistake> threshold_mistakes() {
  std::vector<Mistake> all;
  for (const auto& of_size : {drops_near_hits, takes_far_root, drops_small_chords}) {
    for (const char* size : kSizes) all.push_back(of_size(size));
  }
  for (const char* size : kLargeSizes) all.push_back(drops_far_hits(size));
  return all;
}

}  // namespace raycheck::properties
