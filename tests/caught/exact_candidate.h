#pragma once

#include "properties/candidate.h"
#include "tests/standard.h"

namespace raycheck::caught {

// For the types of candidates.
using namespace properties;
using namespace scene;

/// How a ray meets a sphere.
struct Sighting {
  std::optional<properties::HitAnswer> hit;  ///< Correctly rounded.
  double to_tangency = 0;  ///< |b - r| / r of the impact parameter b, to first order.
  double middle = 0;       ///< s of the line's point nearest to the centre.
};

/// The hits of a ray, in the order of the spheres.
struct Sight {
  std::vector<Sighting> spheres;
  std::optional<std::size_t> nearest;
};

/// A cache of answers, by question.
template <class Answer, class... Asked>
class Remembered {
 public:
  template <class Make>
  const Answer& operator()(const Make& make, const Asked&... asked) {
    for (const auto& [key, answer] : kept_) {
      if (key == std::tie(asked...)) return answer;
    }
    if (kept_.size() == kMost) kept_.pop_front();
    kept_.emplace_back(std::tuple(asked...), make());
    return kept_.back().second;
  }

 private:
  /// Room for a case and the variants that laws make of it.
  static constexpr std::size_t kMost = 24;
  std::deque<std::pair<std::tuple<Asked...>, Answer>> kept_;
};

/// The truth about rays and spheres, with a cache of the latest answers.
class Sights {
 public:
  using Rays = std::vector<scene::Ray>;
  using Spheres = std::vector<scene::Sphere>;
  using Pixels = std::vector<scene::Pixel>;
  const std::vector<Sight>& of(const Rays& rays, const Spheres& spheres,
                               const scene::Conventions& conventions);
  const std::vector<Sight>& of(const scene::Scene& scene, const scene::Conventions& conventions,
                               const Pixels& pixels);

 private:
  Remembered<std::vector<Sight>, Rays, Spheres, scene::Conventions> of_rays_;
  Remembered<std::vector<Sight>, scene::Scene, scene::Conventions, Pixels> of_pixels_;
};

/// The domain in which correctly rounded answers are within the bounds, because quotients of such
/// lengths are normal doubles.
inline constexpr properties::Domain kRoundedDomain = {.smallest_length = 0x1p-500,
                                                      .largest_length = 0x1p500,
                                                      .smallest_camera_length = 0x1p-250,
                                                      .largest_camera_length = 0x1p250};

/// Changes the hits of the spheres. The nearest sphere is the one with the least s.
using ChangeSight = std::function<void(Sight&)>;

/// Makes all decisions of a candidate follow the truth with this change.
void answer_by_sights(properties::Candidate& candidate, const std::shared_ptr<Sights>& sights,
                      const std::shared_ptr<Sights::Pixels>& looked_at, const ChangeSight& change);

/// `exact`: every answer is exact, correctly rounded, and cached. It is judged like third-party
/// code: by the bounds of direct/cross, without a domain and without a promise of exact hit
/// classes. An image shows only the pixels `looked_at`.
properties::Candidate exact_candidate(const std::shared_ptr<Sights>& sights,
                                      const std::shared_ptr<Sights::Pixels>& looked_at);

}  // namespace raycheck::caught
