#include "tools/external/pictures/dry_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "properties/mistakes/shown_picture.h"
#include "tools/external/pictures/dry_pictures.h"

namespace raycheck::tools {
namespace {

/// A second attempt may take this many times the rubric's time limit.
constexpr double kMoreTime = 4;

/// With this likeness to the truth, the program certainly reads the form.
constexpr double kSurelyAlike = 0.95;

/// In a pure colour, the other channels are at most this share of the largest.
constexpr double kNoChannel = 0.4;

/// The result of drawing the symmetric scene in one form.
struct Attempt {
  DriverForm form;
  std::optional<MadePicture> made;
  Refusal failure;  ///< Why there is no picture.
  Progress progress = Progress::kPicture;
  double like = 0;
  double seconds = 0;
  bool reads() const { return progress == Progress::kSpheres; }
  bool is_sure() const { return like >= kSurelyAlike; }
};

class DryRunner {
 public:
  DryRunner(Renderer renderer, const DriverRule& rule, const properties::RunControl& control)
      : renderer_(std::move(renderer)), rule_(rule), control_(control) {
    renderer_.driver = rule.form;
  }

  DryRun run() {
    Attempt chosen = find_form();
    DryRun found;
    found.driver = chosen.made ? chosen.form : rule_.form;
    found.seconds = chosen.seconds;
    found.progress = chosen.progress;
    const std::optional<DriverForm> other = form_read_instead(chosen);
    if (other) found.notes.push_back(unread_note(*other));
    if (!chosen.made) {
      found.refusal = chosen.progress == Progress::kTimeUp ? with_more_time(chosen, found)
                      : fails_by_fractions()               ? by_fractions(chosen)
                                                           : chosen.failure;
      return found;
    }
    found.picture_name = chosen.made->other_name;
    if (!chosen.reads()) found.said = chosen.made->said;
    if (tells_by_) {
      found.notes.push_back(
          fmt::format("it shows spheres in their colours only in scene files of form {}, not {}",
                      tells_by_->text(), rule_.form.text()));
    } else if (rule_.is_asked_for && !(chosen.form == rule_.form || unsteady_ == rule_.form)) {
      found.notes.push_back(unread_note(chosen.form));
    }
    if (unsteady_) {
      found.notes.push_back(
          fmt::format("it draws the same driver file of form {} differently each time: a variable "
                      "is not initialised",
                      unsteady_->text()));
    }
    if (!chosen.made->other_name.empty() && renderer_.is_told_name()) {
      found.notes.push_back(
          fmt::format("it writes {} and ignores the given file name", chosen.made->other_name));
    }
    if (chosen.made->picture.is_lossy) {
      found.notes.emplace_back(
          "it writes a JPEG, which does not keep colours exactly: pixels whose colour is unclear, "
          "at "
          "edges of spheres, are not judged");
    }
    if (!chosen.made->ended.empty()) {
      found.notes.push_back(
          fmt::format("it makes its picture, but then it {}", chosen.made->ended));
    }
    if (!chosen.reads()) {
      if (chosen.made->picture.pixels.empty()) return found;
      if (is_shaded_around(chosen.made->picture)) {
        found.refusal = Refusal{
            "its background has more than one colour: all pixels whose rays hit nothing must "
            "have the same colour, or spheres cannot be told from the background",
            {}};
      } else if (is_uniform(chosen.made->picture) && !other) {
        found.shows_nothing =
            fmt::format("its picture is {} in {} tried",
                        is_black(chosen.made->picture) ? "black" : "of one colour",
                        tried_ == 1 ? "the one form" : fmt::format("the {} forms", tried_));
      }
      return found;
    }
    found.colours.background = background_of(chosen.made->picture);
    if (!(found.colours.background == Colour{})) {
      const auto& [red, green, blue] = found.colours.background;
      found.notes.push_back(
          fmt::format("its background is not black but ({}, {}, {})", red, green, blue));
    }
    find_colours(found);
    leave_out_light(found);
    return found;
  }

 private:
  static bool is_uniform(const ReadPicture& picture) {
    return std::ranges::adjacent_find(picture.pixels, [](auto& a, auto& b) { return !(a == b); }) ==
           picture.pixels.end();
  }
  static bool is_black(const ReadPicture& picture) {
    return is_uniform(picture) && picture.pixels.front() == Colour{};
  }

  static Progress progress_of(FailureKind kind) {
    if (kind == FailureKind::kTimeUp) return Progress::kTimeUp;
    return kind == FailureKind::kBadReply ? Progress::kNoPicture : Progress::kFailed;
  }
  /// Output of one line becomes part of the reason; longer output is shown below the reason.
  static Refusal refusal_of(const ProcessFailure& failure) {
    if (failure.output().find('\n') == std::string::npos) return {failure.what(), {}};
    return {failure.why(), failure.output()};
  }

  /// Draws the symmetric scene in a form.
  Attempt attempt(const DriverForm& form) {
    ++tried_;
    return attempt_of(scene_, form);
  }
  /// Draws a scene that looks like the symmetric one.
  Attempt attempt_of(const scene::Scene& scene, const DriverForm& form) {
    Attempt made;
    made.form = form;
    const SpentTime& spent = *renderer_.program.spent;
    const SpentTime::Time before = spent.so_far();
    const std::vector<Colour> white(scene.spheres.size(), {255, 255, 255});
    try {
      made.made = rendered(renderer_, driver_text(scene, form, white), size_);
      made.like = likeness(made.made->picture, truth_);
      if (made.like >= kShownAlike) made.progress = Progress::kSpheres;
    } catch (const ProcessFailure& failure) {
      made.failure = refusal_of(failure);
      made.progress = progress_of(failure.kind());
      timed_out_ += made.progress == Progress::kTimeUp ? 1 : 0;
    } catch (const std::system_error& error) {  // the machine's fault, which `surroundings` records
      made.failure = {error.what(), {}};
      made.progress = Progress::kNoPicture;
    }
    made.seconds = spent.seconds_since(before);
    return made;
  }

  Attempt find_form() {
    Attempt first = attempt(rule_.form);
    if (const auto found = steady(first)) {
      if (rule_.form.format->has_forms() || !rule_.tries_others || tells_spheres(*found)) {
        return *found;
      }
      return that_tells_spheres(*found);
    }
    return rule_.tries_others ? best_of_all(std::move(first)) : first;
  }

  bool tells_spheres(const Attempt& read) {
    DryRun found;
    found.driver = read.form;
    found.colours.background = background_of(read.made->picture);
    find_colours(found);
    return found.colours.tells_spheres;
  }

  /// A program that expects more numbers of a colour than a form has draws the spheres, but not in
  /// their colours. Returns the first variant in whose pictures colours identify the spheres.
  Attempt that_tells_spheres(const Attempt& read) {
    for (const DriverForm& form : known_forms(rule_.form)) {
      if (form == rule_.form) continue;
      if (control_.interrupted() || timed_out_ >= kMostTimeouts) break;
      const auto found = steady(attempt(form));
      if (!found || !tells_spheres(*found)) continue;
      tells_by_ = form;
      return *found;
    }
    return read;
  }

  /// Given a form that is certainly read: returns the fullest similar form that is also read, else
  /// that form. (A program may not initialise values that it does not find.) Empty if the form is
  /// not certainly read, or if repeated pictures differ.
  std::optional<Attempt> steady(const Attempt& read) {
    if (!read.is_sure()) return {};
    if (rule_.tries_others && !(rule_.is_asked_for && read.form == rule_.form)) {
      for (const DriverForm& form : fuller_forms(read.form)) {
        const Attempt next = attempt(form);
        if (next.is_sure() && is_drawn_again(form)) return next;
      }
    }
    if (is_drawn_again(read.form)) return read;
    unsteady_ = read.form;
    return {};
  }

  /// Whether a second picture of the same driver file shows the scene, too.
  bool is_drawn_again(const DriverForm& form) {
    const std::vector<Colour> white(scene_.spheres.size(), {255, 255, 255});
    try {
      const MadePicture again = rendered(renderer_, driver_text(scene_, form, white), size_, 2);
      return likeness(again.picture, truth_) >= kSurelyAlike;
    } catch (const ProcessFailure&) {
      return false;
    } catch (const std::system_error&) {  // the machine's fault, which `surroundings` records
      return false;
    }
  }

  /// The attempt in the first form that is certainly read and gives the same picture twice. If
  /// there is none, that with the best likeness; if no form is read, that with the most progress.
  /// If several are equal, the rule's form.
  Attempt best_of_all(Attempt best) {
    for (const DriverForm& form : known_forms(rule_.form)) {
      if (form == rule_.form) continue;
      if (control_.interrupted() || timed_out_ >= kMostTimeouts) break;
      Attempt next = attempt(form);
      if (const auto found = steady(next)) return *found;
      const bool is_better = next.reads() ? next.like > best.like : next.progress > best.progress;
      if (is_better) best = std::move(next);
    }
    return best;
  }

  /// If the rule allows only one form, and the program does not read it: a form that it reads.
  std::optional<DriverForm> form_read_instead(const Attempt& chosen) {
    if (rule_.tries_others || chosen.reads() || chosen.progress == Progress::kTimeUp) {
      return {};
    }
    const Attempt other = best_of_all(chosen);
    if (!other.reads()) return {};
    return other.form;
  }
  std::string unread_note(const DriverForm& other) const {
    return fmt::format("it does not read driver files of form {}, but of form {}",
                       rule_.form.text(), other.text());
  }

  /// Why a picture times out, and whether more time helps.
  Refusal with_more_time(const Attempt& slow, DryRun& found) {
    const double seconds = renderer_.program.limits.seconds;
    renderer_.program.limits.seconds = kMoreTime * seconds;
    const auto began = std::chrono::steady_clock::now();
    const Attempt again = attempt(slow.form);
    if (!again.made) return slow.failure;
    // A program that was stopped before it had used its CPU time was waiting: it needs wall time.
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began;
    const double needed = again.seconds > seconds ? again.seconds : passed.count();
    found.needed_seconds = needed;
    return {fmt::format("it needs more time: {:.1f} s for a picture of {} x {} pixels, but "
                        "reply_seconds allows {}",
                        needed, scene_.camera->width, scene_.camera->height, seconds),
            {}};
  }

  /// The colour in which the program draws spheres of a given colour; empty if it fails or draws
  /// none.
  std::optional<Colour> shown(const Colour& colour, const DryRun& found) {
    const scene::Scene scene = middle_spheres();
    const std::vector<Colour> colours(scene.spheres.size(), colour);
    try {
      const ReadPicture picture =
          rendered(renderer_, driver_text(scene, found.driver, colours), size_).picture;
      const std::size_t middle = picture.pixels.size() / 2;
      if (picture.pixels.empty() || picture.pixels[middle] == found.colours.background) return {};
      return picture.pixels[middle];
    } catch (const std::runtime_error&) {
      return {};
    }
  }

  /// Finds which channels show red, green and blue. If it draws no sphere in any colour, the fault
  /// is another one, and nothing follows.
  void find_colours(DryRun& found) {
    if (renderer_.depth) return;  // hits are white, a colour that no sphere has
    constexpr std::array<Colour, 3> kPure = {Colour{255, 0, 0}, {0, 255, 0}, {0, 0, 255}};
    std::array<std::optional<Colour>, 3> seen;
    for (std::size_t k = 0; k < kPure.size(); ++k) seen[k] = shown(kPure[k], found);
    if (std::ranges::none_of(seen, [](const auto& one) { return one.has_value(); })) {
      return;
    }
    std::array<std::size_t, 3> channels{};
    for (std::size_t k = 0; k < kPure.size(); ++k) {
      const std::array<int, 3> parts =
          seen[k] ? std::array<int, 3>{seen[k]->red, seen[k]->green, seen[k]->blue}
                  : std::array<int, 3>{};
      const auto most = std::ranges::max_element(parts);
      channels[k] = static_cast<std::size_t>(most - parts.begin());
      const auto others =
          std::ranges::count_if(parts, [&](int part) { return part <= kNoChannel * *most; });
      found.colours.tells_spheres = found.colours.tells_spheres && *most > 0 && others == 2;
    }
    const bool all_differ =
        channels[0] != channels[1] && channels[1] != channels[2] && channels[0] != channels[2];
    found.colours.tells_spheres = found.colours.tells_spheres && all_differ;
    if (!found.colours.tells_spheres) {
      found.notes.emplace_back("its colours do not identify the spheres");
    } else if (channels != ColourHabit{}.channels) {
      found.colours.channels = channels;
      found.notes.emplace_back("it exchanges red, green and blue");
    }
  }

  /// Whether a program that makes no picture of other scenes makes one if all numbers are integers.
  bool fails_by_fractions() {
    constexpr std::size_t kMostForms = 30;
    const scene::Scene whole = whole_scene();
    std::vector<DriverForm> forms = known_forms(rule_.form);
    forms.resize(std::min(forms.size(), rule_.tries_others ? kMostForms : 1));
    return std::ranges::any_of(forms, [&](const DriverForm& form) {
      return !control_.interrupted() && timed_out_ < kMostTimeouts &&
             attempt_of(whole, form).made.has_value();
    });
  }
  static Refusal by_fractions(const Attempt& failed) {
    const auto& [why, said] = failed.failure;
    return {"it reads numbers as integers, and fails if a number has a fraction",
            said.empty() ? why : said};
  }

  bool fails_on(const scene::Scene& scene, const DriverForm& form) const {
    try {
      rendered(renderer_, driver_text(scene, form), {scene.camera->width, scene.camera->height});
      return false;
    } catch (const ProcessFailure& failure) {
      return failure.kind() != FailureKind::kCannotExpress;
    } catch (const std::runtime_error&) {
      return true;
    }
  }

  /// Drops the light if the program fails because of it, since the light is not judged.
  void leave_out_light(DryRun& found) {
    if (!rule_.tries_others || found.driver.light == DriverLight::kNone) return;
    DriverForm unlit = found.driver;
    unlit.light = DriverLight::kNone;
    for (const scene::Scene& scene : ordinary_scenes()) {
      if (control_.interrupted()) return;
      if (!fails_on(scene, found.driver)) continue;
      if (fails_on(scene, unlit) || !attempt(unlit).reads()) return;
      found.driver = unlit;
      found.notes.emplace_back(
          "it fails on driver files with a light, so it is given files without");
      return;
    }
  }

  /// After this many time-outs no further form is tried.
  static constexpr int kMostTimeouts = 3;

  Renderer renderer_;
  const DriverRule& rule_;
  const properties::RunControl& control_;
  const scene::Scene scene_ = symmetric_scene();
  const PictureSize size_ = {scene_.camera->width, scene_.camera->height};
  const properties::ImageAnswer truth_ = properties::exact_image(scene_, scene_.conventions);
  int tried_ = 0, timed_out_ = 0;
  std::optional<DriverForm> tells_by_;  ///< The form chosen for its colours.
  std::optional<DriverForm> unsteady_;  ///< The last form whose two pictures differ.
};

}  // namespace

DryRun dry_run(Renderer renderer, const DriverRule& rule, const properties::RunControl& control) {
  return DryRunner(std::move(renderer), rule, control).run();
}

bool makes_a_picture(const Renderer& renderer, const DriverRule& rule) {
  constexpr std::size_t kMostForms = 4;
  const scene::Scene scene = symmetric_scene();
  const PictureSize size = {scene.camera->width, scene.camera->height};
  std::vector<DriverForm> forms = known_forms(rule.form);
  forms.resize(std::min(forms.size(), rule.tries_others ? kMostForms : 1));
  return std::ranges::any_of(forms, [&](const DriverForm& form) {
    Renderer reading = renderer;
    reading.driver = form;
    try {
      rendered(reading, driver_text(scene, form, ColourHabit{.tells_spheres = false}), size);
      return true;
    } catch (const std::runtime_error&) {
      return false;
    }
  });
}

}  // namespace raycheck::tools
