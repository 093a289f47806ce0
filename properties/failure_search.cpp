#include "properties/failure_search.h"

#include <algorithm>
#include <utility>

#include "properties/trial.h"

namespace raycheck::properties {
namespace {

/// A part of a batch has its share of the time for a reply, and no less than this one; what is
/// asked alone has all of it.
constexpr double kLeastShare = 0.1;

std::shared_ptr<TrialPart> part_of(const Trial& whole, std::size_t from, std::size_t to) {
  const bool by_ray = whole.ray_count() > 1;
  Case part{whole.scene(), whole.pixels()};
  const auto keep = [&](auto& list) {
    const auto first = list.begin();
    list = {first + static_cast<std::ptrdiff_t>(from), first + static_cast<std::ptrdiff_t>(to)};
  };
  if (!by_ray) {
    keep(part.scene.spheres);
  } else if (part.scene.camera) {
    keep(part.pixels);
  } else {
    keep(part.scene.rays);
  }
  const std::uint64_t all = count_asked(whole, !by_ray);
  TrialOptions options = whole.options();
  options.truth = nullptr;
  const bool is_one = to - from == 1 && (!by_ray || part.scene.spheres.size() <= 1);
  const double share = options.share * static_cast<double>(to - from) / static_cast<double>(all);
  options.share = is_one ? 1 : std::max(kLeastShare, share);
  return std::make_shared<TrialPart>(std::move(part), by_ray ? from : 0, by_ray ? 0 : from,
                                     whole.candidate(), options);
}

}  // namespace

std::uint64_t count_asked(const Trial& trial, bool by_sphere) {
  const std::size_t spheres = trial.scene().spheres.size();
  return trial.ray_count() * (by_sphere ? std::max<std::size_t>(1, spheres) : 1);
}

const std::vector<std::shared_ptr<TrialPart>>& FailedParts::halves(const Trial& whole) {
  if (halves_.empty()) {
    const std::size_t all = count_asked(whole, whole.ray_count() <= 1);
    halves_ = {part_of(whole, 0, all / 2), part_of(whole, all / 2, all)};
  }
  return halves_;
}

Place TrialPart::place(Place of_part) const {
  if (!of_part.pixel) of_part.ray += first_ray;
  if (of_part.sphere) *of_part.sphere += first_sphere;
  return of_part;
}

}  // namespace raycheck::properties
