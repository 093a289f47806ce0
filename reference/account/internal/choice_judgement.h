#pragma once

// Whether a claim about what a ray meets first is right, for given or changed inputs. Internal to
// reference/.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "reference/account/nearby_choice.h"

namespace raycheck::reference {

struct ChoiceQuestion {
  const ExactRay& ray;
  std::span<const scene::Sphere> spheres;
  std::vector<std::size_t> contenders;  ///< The spheres that matter.
  const Neighbourhood& around;
  const FirstMet& claim;
};

/// Whether a claim is right, or a sphere that makes it wrong; neither if that cannot be told.
struct Judgement {
  bool is_right = false;
  std::optional<std::size_t> offender;
};

/// By exact decisions.
Judgement judge(const ChoiceQuestion& question);
/// By balls.
Judgement judge_changed(const ChoiceQuestion& question, const InputChange& change);

}  // namespace raycheck::reference
