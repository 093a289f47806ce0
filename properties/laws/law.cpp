#include "properties/laws/law.h"

#include <array>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>

#include "properties/laws/law_list.h"

namespace raycheck::properties {
namespace {

const std::array<Law, 29> kLaws = {kFrameLaw,          kPixelPointLaw,    kBoundsLaw,
                                   kImagePlaneLaw,     kCentrePixelLaw,   kPixelZeroZeroLaw,
                                   kDensityLaw,        kSquarePixelsLaw,  kUnitDirectionLaw,
                                   kDirectionLaw,      kRayOriginLaw,     kClassLaw,
                                   kRootLaw,           kParameterLaw,     kBackwardErrorLaw,
                                   kHitPointLaw,       kFocalAndPixelLaw, kNearestSphereLaw,
                                   kVisibleSphereLaw,  kImageLaw,         kPlanLeftOutLaw,
                                   kPlanRectanglesLaw, kPlanRootsLaw,     kScalingLaw,
                                   kAxesLaw,           kLookAtLaw,        kUpLaw,
                                   kGrowingRadiusLaw,  kRefusalLaw};

}  // namespace

std::span<const Law> laws() { return kLaws; }

const Law* find_law(std::string_view name) {
  for (const Law& law : laws()) {
    if (law.name == name) return &law;
  }
  return nullptr;
}

namespace {

Verdict verdict_of(const Law& law, const Trial& trial, Wrong wrong, const char* message) {
  Verdict verdict;
  trial.judge(
      verdict, law.name, Quantity::kRefusal, Place{}, wrong, [] { return false; },
      [&](Discrepancy& discrepancy) { discrepancy.what = message; });
  return verdict;
}

}  // namespace

Verdict apply(const Law& law, Trial& trial) {
  try {
    return law.judge(trial);
  } catch (const std::invalid_argument& error) {
    return verdict_of(law, trial, Wrong::kRefused, error.what());
  } catch (const std::exception& error) {
    return verdict_of(law, trial, Wrong::kFailed, error.what());
  }
}

}  // namespace raycheck::properties
