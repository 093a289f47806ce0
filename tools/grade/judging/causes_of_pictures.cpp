#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "properties/mistakes/picture_causes.h"
#include "properties/mistakes/picture_evidence.h"
#include "tools/grade/judging/item_trial.h"

namespace raycheck::tools {
namespace {

using properties::CauseKind;
using properties::Causes;
using properties::Fault;
using properties::ImageAnswer;
using properties::Mistake;
using properties::ShownPicture;

bool shows_something(const ImageAnswer& image) {
  return std::ranges::any_of(image, [](auto& sphere) { return sphere.has_value(); }) &&
         std::ranges::any_of(image, [](auto& sphere) { return !sphere; });
}

/// Whether the picture has the right size.
bool is_picture(const FailedCase& one) { return one.shown && !one.shown->sides_exchanged; }

/// The numbers of an item's wrong pixels, and of those that a fault does not explain.
struct Agreement {
  std::uint64_t wrong = 0, left = 0;
  /// Whether, under the fault, a failing case shows both a sphere and background.
  bool shows = false;
  bool explains(std::size_t pictures) const {
    return static_cast<double>(left) <=
           static_cast<double>(wrong) * properties::kMostLeftOfAll + static_cast<double>(pictures);
  }
};

Agreement agreement(const Fault& fault, const ItemTrial& trial, bool masks_only) {
  Agreement found;
  const auto seen = [masks_only](ImageAnswer image) {
    return masks_only ? mask_of(std::move(image)) : image;
  };
  for (const FailedCase& one : trial.failed) {
    if (!is_picture(one)) continue;
    const scene::Scene& scene = one.shown->scene;
    const ImageAnswer& image = one.shown->image;
    const ImageAnswer made = predicted(fault, scene);
    found.left += properties::count_otherwise(seen(image), seen(made));
    found.wrong += properties::count_otherwise(
        seen(image), seen(properties::exact_image(scene, scene.conventions)));
    found.shows = found.shows || shows_something(made);
  }
  return found;
}

/// If, under a fault, at least this many failing pictures show something, the fault also explains
/// black pictures. A fault that makes nearly all pictures black explains too little to be charged
/// to other items.
constexpr int kFewestShown = 3;

bool shows_enough(const Fault& fault, const std::vector<ItemTrial>& trials) {
  int shown = 0;
  for (const ItemTrial& trial : trials) {
    for (const FailedCase& one : trial.failed) {
      if (is_picture(one) && shows_something(predicted(fault, one.shown->scene))) ++shown;
    }
  }
  return shown >= kFewestShown;
}

/// The cause of an item: the smallest part of a fault that explains all its errors.
ItemCause cause_of(const Fault& fault, const ItemTrial& trial, bool masks_only) {
  std::vector<Fault> parts;
  for (const Mistake* mistake : fault) parts.push_back({mistake});
  if (fault.size() > 1) parts.push_back(fault);
  for (const Fault& part : parts) {
    const Agreement found = agreement(part, trial, masks_only);
    if (found.explains(trial.failed.size())) return {part, {}, found.shows};
  }
  return {};
}

/// The causes that explain all pictures or, if there are none, all pictures except those of bonus
/// items, which require more than right formulas.
Causes causes_of(const Rubric& rubric, const std::vector<ItemTrial>& trials) {
  const auto of = [&](bool with_bonus) {
    std::vector<ShownPicture> pictures;
    for (std::size_t k = 0; k < trials.size(); ++k) {
      if (rubric.items[k].bonus && !with_bonus) continue;
      pictures.insert(pictures.end(), trials[k].pictures.begin(), trials[k].pictures.end());
    }
    return properties::picture_causes(pictures);
  };
  const Causes all = of(true);
  if (all.kind == CauseKind::kUnknown) return of(false);
  if (!all.imprecision || all.alternatives.empty()) return all;
  // Roundings may explain the bonus items in addition to the mistakes of the other items. Together
  // with a further mistake that only bonus items show, they would explain nearly anything.
  const Causes ordinary = of(false);
  const bool is_more = !ordinary.alternatives.empty() &&
                       all.alternatives.front().size() > ordinary.alternatives.front().size();
  return is_more ? ordinary : all;
}

/// A camera whose numbers all differ, to find out how a mistake reads them.
scene::Camera numbered_camera() {
  scene::Camera camera;
  camera.near = -3;
  camera.left = -1.25;
  camera.right = 2.5;
  camera.bottom = -0.75;
  camera.top = 1.75;
  camera.width = 5;
  camera.height = 4;
  return camera;
}

/// How code with a mistake reads near and the bounds.
struct Reading {
  bool turns_near = false;     ///< Whether near gets the opposite sign.
  bool orders_bounds = false;  ///< Whether the bounds are read in another order.
};

Reading reading_of(const Mistake& mistake) {
  if (!mistake.camera) return {};
  const scene::Camera given = numbered_camera();
  scene::Camera read = given;
  mistake.camera(read, {});
  const std::array<double, 4> bounds = {given.left, given.right, given.bottom, given.top};
  const std::array<double, 4> taken = {read.left, read.right, read.bottom, read.top};
  if (taken == bounds) return {read.near == -given.near, false};
  return {false, std::ranges::is_permutation(taken, bounds)};
}

/// Whether correct code for another form of driver files might draw the same pictures. Dialects
/// differ in the sign of d and in the order of the bounds.
bool is_of_driver_files(const Causes& causes) {
  return std::ranges::any_of(causes.alternatives, [](const Fault& fault) {
    return std::ranges::any_of(fault, [](const Mistake* mistake) {
      const Reading reading = reading_of(*mistake);
      return reading.turns_near || reading.orders_bounds;
    });
  });
}

/// A near with the wrong sign in one dialect is right in the other, which orders the bounds
/// differently. If the dialect was found by trial, the sentence names both possibilities.
const Mistake* worded_for(const scene::FileFormat& format, const Mistake* mistake) {
  if (!format.has_forms() || !reading_of(*mistake).turns_near) return mistake;
  const auto worded = [&](const char* sentence) {
    Mistake other = *mistake;
    other.sentence = sentence;
    return other;
  };
  static const Mistake kBoundsOfA = worded(
      "near is d itself, as in driver files from 2019 on, but the bounds are read in the order of "
      "2017 and 2018");
  static const Mistake kBoundsOfB = worded(
      "near is -d, as in driver files of 2017 and 2018, but the bounds are read in the order of "
      "2019 and later");
  return format.has("distance") ? &kBoundsOfA : &kBoundsOfB;
}

/// How an item fails.
struct FailedHow {
  /// At least one picture is wrong, exchanged, missing.
  bool wrong = false, exchanged = false, failed = false;
};

FailedHow failed_how(const ItemTrial& trial) {
  FailedHow how;
  for (const FailedCase& one : trial.failed) {
    (!one.shown ? how.failed : one.shown->sides_exchanged ? how.exchanged : how.wrong) = true;
  }
  return how;
}

/// The sentence for pictures that do not depend on the scene; empty if they do.
std::string sentence_of_kind(Causes causes) {
  causes.exchanged = 0;
  const std::vector<properties::Explanation> said = properties::explanations(causes);
  return said.empty() || said.front().explained == 0 ? "" : said.front().sentence;
}

bool masks_only(const Item& item) { return item.pictures && item.pictures->masks_only; }

/// Finds and names the roundings that explain an item's wrong pictures, alone or together with a
/// part of the fault.
ItemCause name_imprecision(const Causes& causes, bool masks_only, ItemTrial& trial) {
  if (!causes.imprecision) return {};
  std::vector<Fault> faults = {{}};
  if (!causes.alternatives.empty()) faults.push_back(causes.alternatives.front());
  for (const Fault& fault : faults) {
    std::uint64_t left = 0;
    for (const FailedCase& one : trial.failed) {
      if (!is_picture(one)) continue;
      ShownPicture shown = *one.shown;
      if (masks_only) shown.image = mask_of(std::move(shown.image));
      left += properties::pixels_left(shown, fault, causes.imprecision->arithmetic);
    }
    const std::uint64_t wrong = agreement({}, trial, masks_only).wrong;
    if (left > 0) continue;
    std::vector<std::string> sentences;
    if (!fault.empty()) sentences = properties::sentences_of(causes.alternatives);
    sentences.push_back(causes.imprecision->sentence());
    trial.grade.mistakes.push_back({std::move(sentences), wrong, wrong});
    return {fault, {OtherCause::kRoundings}, true};
  }
  return {};
}

/// Finds and names the cause of an item's wrong pictures.
ItemCause name_cause(const Causes& causes, bool is_shown, bool masks_only, ItemTrial& trial) {
  if (causes.kind == CauseKind::kImprecise) return name_imprecision(causes, masks_only, trial);
  if (causes.kind != CauseKind::kExplained) {
    const std::string sentence = sentence_of_kind(causes);
    const std::uint64_t wrong = agreement({}, trial, masks_only).wrong;
    if (!sentence.empty()) trial.grade.mistakes.push_back({{sentence}, wrong, wrong});
    return {};
  }
  const Fault& fault = causes.alternatives.front();
  ItemCause cause = cause_of(fault, trial, masks_only);
  if (cause.fault.empty()) return name_imprecision(causes, masks_only, trial);
  cause.is_all = cause.is_all || is_shown;
  const Agreement found = agreement(cause.fault, trial, masks_only);
  // A part of a fault has its own sentence; the sentence of the whole fault has all alternatives.
  std::vector<Fault> alternatives = causes.alternatives;
  if (cause.fault.size() < fault.size()) {
    alternatives.clear();
    const auto place = std::ranges::find(fault, cause.fault.front()) - fault.begin();
    for (const Mistake* one :
         properties::mistakes_at(static_cast<std::size_t>(place), causes.alternatives)) {
      alternatives.push_back({one});
    }
  }
  trial.grade.mistakes.push_back({properties::sentences_of(alternatives), found.wrong,
                                  found.wrong - std::min(found.wrong, found.left)});
  return cause;
}

}  // namespace

std::vector<ItemCause> causes_of_pictures(const Rubric& rubric, FormKnown form_known,
                                          const scene::FileFormat& format,
                                          std::vector<ItemTrial>& trials) {
  std::vector<ItemCause> item_causes(trials.size());
  Causes causes = causes_of(rubric, trials);
  if (form_known == FormKnown::kNot && is_of_driver_files(causes)) return item_causes;
  if (form_known == FormKnown::kFound) {
    for (Fault& fault : causes.alternatives) {
      for (const Mistake*& mistake : fault) mistake = worded_for(format, mistake);
    }
  }
  const bool is_shown =
      causes.kind == CauseKind::kExplained && shows_enough(causes.alternatives.front(), trials);
  const ShapeOfFailures shape =
      form_known == FormKnown::kNot
          ? ShapeOfFailures()
          : shape_of_failures(rubric, trials, causes.kind == CauseKind::kUnknown);
  for (std::size_t k = 0; k < trials.size(); ++k) {
    ItemTrial& trial = trials[k];
    if (trial.grade.state != ItemState::kFails || trial.failed.empty()) continue;
    ItemCause& cause = item_causes[k];
    const FailedHow how = failed_how(trial);
    cause.is_all = true;
    const bool wrong_by_shape = how.wrong && shape.of_wrong_ones &&
                                std::ranges::all_of(trial.failed, [&](const FailedCase& one) {
                                  return shape.cause->is(one.item_case.the_case.scene);
                                });
    if (how.wrong && !wrong_by_shape) {
      cause = name_cause(causes, is_shown, masks_only(rubric.items[k]), trial);
    }
    const auto add = [&](OtherCause other, const std::string& sentence) {
      cause.others.push_back(other);
      trial.grade.mistakes.push_back({{sentence}});
    };
    if (how.exchanged) {
      cause.is_all = cause.is_all && causes.exchanged > 0;
      if (causes.exchanged > 0) add(OtherCause::kSidesExchanged, properties::kSidesExchanged);
    }
    if (how.failed || wrong_by_shape) {
      // The shape must also hold for all scenes that were skipped.
      const auto& others = trial.not_asked;
      cause.is_all = cause.is_all && shape.cause && std::ranges::all_of(others, shape.cause->is);
      if (shape.cause) add(OtherCause::kShapeOfScenes, shape.cause->sentence);
    }
  }
  return item_causes;
}

}  // namespace raycheck::tools
