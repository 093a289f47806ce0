#pragma once

#include "properties/candidate.h"
#include "tests/standard.h"

namespace raycheck::caught {

// What they are made of.
using namespace properties;
using namespace scene;

/// How a ray meets a sphere.
struct Sighting {
  std::optional<properties::HitAnswer> hit;  ///< Correctly rounded.
  double to_tangency = 0;  ///< |b - r| / r of the impact parameter b, to first order.
  double middle = 0;       ///< s where the line is nearest to the centre.
};

/// What a ray meets, the spheres in their order.
struct Sight {
  std::vector<Sighting> spheres;
  std::optional<std::size_t> nearest;
};

/// Answers that are remembered for a while, by what was asked.
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
  static constexpr std::size_t kMost = 24;  ///< A case and what laws make of it.
  std::deque<std::pair<std::tuple<Asked...>, Answer>> kept_;
};

/// The truth about rays and spheres; the last answers are remembered.
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

/// Where a correctly rounded answer is as near as the bounds ask: quotients of such lengths are
/// normal doubles.
inline constexpr properties::Domain kRoundedDomain = {.smallest_length = 0x1p-500,
                                                      .largest_length = 0x1p500,
                                                      .smallest_camera_length = 0x1p-250,
                                                      .largest_camera_length = 0x1p250};

/// What is seen of the spheres, changed; the nearest is the one of the least s.
using ChangeSight = std::function<void(Sight&)>;

/// Has a candidate answer, in all that it decides, what is true but for a change.
void answer_by_sights(properties::Candidate& candidate, const std::shared_ptr<Sights>& sights,
                      const std::shared_ptr<Sights::Pixels>& looked_at, const ChangeSight& change);

/// `exact`: every answer is the exact one, correctly rounded, and remembered for a while. It is
/// held to what anyone else's code is held to: the bounds of direct/cross, with no domain, and no
/// promise of exact classes. An image shows the pixels that are `looked_at`, and nothing else.
properties::Candidate exact_candidate(const std::shared_ptr<Sights>& sights,
                                      const std::shared_ptr<Sights::Pixels>& looked_at);

}  // namespace raycheck::caught
