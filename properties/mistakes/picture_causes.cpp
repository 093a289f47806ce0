#include "properties/mistakes/picture_causes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "properties/mistakes/picture_evidence.h"
#include "reference/visibility/visibility.h"
#include "scene/plan/plan.h"

namespace raycheck::properties {
namespace {

bool is_right(const Evidence& one) { return one.all_errors() == 0; }

/// The kind that all pictures share that should show a sphere.
std::optional<CauseKind> kind_of_all(const Pictures& pictures) {
  const auto all = [&](const auto& is) {
    bool is_wrong = false;
    for (const Evidence& one : pictures) {
      if (!one.has_something_to_see()) continue;
      if (!is(one)) return false;
      is_wrong = is_wrong || !is_right(one);
    }
    return is_wrong;
  };
  if (all([](const Evidence& one) { return one.is_black(); })) return CauseKind::kBlack;
  if (all([](const Evidence& one) { return one.is_uniform(); })) return CauseKind::kUniform;
  if (all([](const Evidence& one) { return one.has_background(); })) return CauseKind::kBackground;
  return {};
}

DoubtTally tally_of(const Fault& fault, const Pictures& pictures, Arithmetic arithmetic) {
  DoubtTally tally;
  for (const Evidence& one : pictures) {
    one.tally(FaultyView(fault, one.picture().scene), arithmetic, tally);
  }
  return tally;
}

bool may_be_imprecise(const Pictures& pictures) {
  return tally_of({}, pictures, kArithmetics.back()).allows_all();
}

/// The pictures of which at least half of the pixels do not depend on roundings.
Pictures mostly_certain(const Pictures& pictures, Arithmetic arithmetic) {
  Pictures certain;
  for (const Evidence& one : pictures) {
    const DoubtTally tally = tally_of({}, {one}, arithmetic);
    if (2 * tally.doubtful <= tally.answers) certain.push_back(one);
  }
  return certain;
}

/// Finds the smallest roundings that explain the wrong pixels, without a fault or with one that
/// explains the mostly certain pictures.
bool find_imprecision(const Pictures& pictures, Causes& causes) {
  const auto is_found = [&](const Fault& fault, Arithmetic arithmetic) {
    const DoubtTally tally = tally_of(fault, pictures, arithmetic);
    if (!tally.tells()) return false;
    causes.imprecision = {arithmetic, tally.radii};
    return true;
  };
  for (const Arithmetic arithmetic : kArithmetics) {
    if (!is_found({}, arithmetic)) continue;
    causes.kind = CauseKind::kImprecise;
    return true;
  }
  // Larger roundings never leave more pictures mostly certain. If they leave as many, the result is
  // the same.
  std::size_t known = pictures.size();
  std::vector<Suspect> found;
  for (const Arithmetic arithmetic : kArithmetics) {
    const Pictures certain = mostly_certain(pictures, arithmetic);
    if (certain.size() == pictures.size()) continue;
    if (certain.size() != known) found = find_suspects(certain).all;
    known = certain.size();
    if (found.empty() || !is_found(found.front().fault, arithmetic)) continue;
    for (const Suspect& suspect : found) causes.alternatives.push_back(suspect.fault);
    causes.kind = CauseKind::kExplained;
    return true;
  }
  return false;
}

/// Whether a fault makes these pictures without excuses, except for the share kMostLeftOfAll of the
/// pixels. Ignores pictures whose wrong pixels are all excused.
bool makes_nearly_all(const Fault& fault, const Pictures& pictures, std::uint64_t errors) {
  return static_cast<double>(count_otherwise(pictures, fault)) <=
         static_cast<double>(errors) * kMostLeftOfAll + static_cast<double>(pictures.size());
}

/// The number of pixels of pictures with width and height exchanged, if all pictures that are not
/// square are exchanged; otherwise 0.
std::uint64_t pixels_exchanged(std::span<const ShownPicture> shown) {
  std::uint64_t pixels = 0;
  for (const ShownPicture& one : shown) {
    const Camera& camera = *one.scene.camera;
    if (one.sides_exchanged) {
      pixels += static_cast<std::uint64_t>(camera.width * camera.height);
    } else if (camera.width != camera.height) {
      return 0;
    }
  }
  return pixels;
}

/// Of kinds with the same numbers (s and distance, if rays start at the eye) the first is named.
constexpr std::array kDepths = {Depth::kDistance, Depth::kS, Depth::kZ, Depth::kImagePlane};
using OfDepths = std::array<std::uint64_t, kDepths.size()>;

/// Counts the pixels whose numbers are not those of each kind. Right ones differ from these doubles
/// by roundings, far below kMostOff, unless they are ill-conditioned.
void count_off(const ShownPicture& shown, OfDepths& off) {
  constexpr double kMostOff = 1e-4;
  const Scene& scene = shown.scene;
  const Camera& camera = *scene.camera;
  std::vector<std::int32_t> spheres(shown.depths.size());
  std::vector<double> s(spheres.size()), x(s), y(s), z(s);
  reference::Visibility(scene, scene::plan_scene(scene, scene.conventions, scene::Wanted::kNearest))
      .nearest(0, camera.height, {spheres, s, x, y, z});
  const scene::Vector3 axis = camera.look_at - camera.eye;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    if (spheres[k] == reference::kNoSphere || !shown.image[k]) continue;
    const scene::Vector3 to = scene::Point3{x[k], y[k], z[k]} - camera.eye;
    const double along =
        (to.x * axis.x + to.y * axis.y + to.z * axis.z) / std::hypot(axis.x, axis.y, axis.z);
    const std::array<double, kDepths.size()> numbers = {std::hypot(to.x, to.y, to.z), s[k], along,
                                                        along / std::abs(camera.near)};
    for (std::size_t kind = 0; kind < numbers.size(); ++kind) {
      const double error = std::abs(static_cast<double>(shown.depths[k]) - numbers[kind]);
      off[kind] += error <= kMostOff * std::abs(numbers[kind]) ? 0 : 1;
    }
  }
}

/// Finds out whether the numbers of depth pictures, whose pixels are right, are of another kind.
void find_other_depth(std::span<const ShownPicture> shown, Causes& causes) {
  OfDepths off{};
  for (const ShownPicture& one : shown) {
    if (!one.depths.empty()) count_off(one, off);
  }
  causes.declared = shown.front().depth;
  const std::uint64_t wrong =
      off[static_cast<std::size_t>(std::ranges::find(kDepths, causes.declared) - kDepths.begin())];
  const auto best = std::ranges::min_element(off);
  if (wrong < kFewestWrongPixels ||
      static_cast<double>(*best) > kMostLeftOfAll * static_cast<double>(wrong)) {
    return;
  }
  causes.kind = CauseKind::kOtherDepth;
  causes.depth = kDepths[static_cast<std::size_t>(best - off.begin())];
  causes.errors = wrong;
  causes.explained = wrong - *best;
}

std::string_view name(Depth depth) { return kDepthNames[static_cast<std::size_t>(depth)]; }

}  // namespace

Causes picture_causes(std::span<const ShownPicture> shown) {
  Causes causes;
  causes.exchanged = pixels_exchanged(shown);
  causes.of_depths =
      std::ranges::any_of(shown, [](const ShownPicture& one) { return !one.depths.empty(); });
  Pictures pictures;
  for (const ShownPicture& one : shown) {
    if (!one.sides_exchanged) pictures.emplace_back(one);
  }
  std::uint64_t all_errors = 0, errors = 0;
  for (const Evidence& one : pictures) {
    all_errors += one.all_errors();
    errors += one.errors();
  }
  if (all_errors == 0) {
    if (causes.of_depths) find_other_depth(shown, causes);
    return causes;
  }
  causes.errors = causes.explained = errors > 0 ? errors : all_errors;
  if (const auto kind = kind_of_all(pictures)) {
    // If roundings may also be the cause, the cause is unknown.
    const bool is_known = *kind == CauseKind::kBlack || !may_be_imprecise(pictures);
    causes.kind = is_known ? *kind : CauseKind::kUnknown;
    return causes;
  }
  std::stable_sort(pictures.begin(), pictures.end(),
                   [](const Evidence& a, const Evidence& b) { return a.errors() > b.errors(); });
  const auto [found, are_too_many] = find_suspects(pictures);
  if (are_too_many) {
    causes.kind = CauseKind::kUnknown;
    causes.explained = 0;
    causes.show_too_little = true;
    return causes;
  }
  const bool is_exact =
      !found.empty() && makes_nearly_all(found.front().fault, pictures, all_errors);
  if (!is_exact && find_imprecision(pictures, causes)) return causes;
  if (!found.empty()) {
    causes.kind = CauseKind::kExplained;
    for (const Suspect& suspect : found) causes.alternatives.push_back(suspect.fault);
    causes.explained -= std::min(causes.errors, found.front().left);
    return causes;
  }
  causes.kind = std::all_of(pictures.begin(), pictures.end(),
                            [](const Evidence& one) { return is_right(one) || one.is_black(); })
                    ? CauseKind::kBlack
                : std::ranges::all_of(pictures, &Evidence::may_be_elsewhere_in_pixels)
                    ? CauseKind::kElsewhereInPixels
                    : CauseKind::kUnknown;
  if (causes.kind == CauseKind::kUnknown) causes.explained = 0;
  return causes;
}

std::uint64_t pixels_left(const ShownPicture& picture, const Fault& fault, Arithmetic arithmetic) {
  DoubtTally tally;
  Evidence(picture).tally(FaultyView(fault, picture.scene), arithmetic, tally);
  return tally.not_allowed;
}

std::vector<Explanation> explanations(const Causes& causes) {
  std::vector<Explanation> all;
  const auto say = [&](const std::string& sentence) {
    all.push_back({sentence, causes.errors, causes.explained});
  };
  const std::string roundings = causes.imprecision ? causes.imprecision->sentence() : "";
  if (causes.exchanged > 0) all.push_back({kSidesExchanged, causes.exchanged, causes.exchanged});
  switch (causes.kind) {
    case CauseKind::kBlack:
      say(causes.of_depths ? "every pixel of the picture is a miss"
                           : "the picture is black: it shows no sphere");
      break;
    case CauseKind::kUniform:
    case CauseKind::kBackground:
      say(causes.of_depths ? "no pixel is a miss: pixels without a sphere have another number than "
                             "the one declared"
          : causes.kind == CauseKind::kUniform
              ? "the picture has one colour, whatever the scene"
              : "no pixel is black: pixels without a sphere have another colour");
      break;
    case CauseKind::kExplained:
      say(sentence_of(causes.alternatives) + (roundings.empty() ? "" : "; and " + roundings));
      break;
    case CauseKind::kImprecise:
      say(roundings);
      break;
    case CauseKind::kElsewhereInPixels:
      say("pixels are sampled elsewhere in their squares: each wrong pixel may show what another "
          "point of its square does");
      break;
    case CauseKind::kOtherDepth:
      say("the numbers of the picture are " + std::string(name(causes.depth)) +
          ", and are declared to be " + std::string(name(causes.declared)));
      break;
    case CauseKind::kUnknown:
      if (causes.show_too_little) say(std::string(kTooLittleShown));
      break;
    case CauseKind::kNothingWrong:
      break;
  }
  return all;
}

}  // namespace raycheck::properties
