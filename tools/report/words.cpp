#include "tools/report/words.h"

#include <fmt/color.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>

#include "scene/fields.h"
#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::tools {
namespace {

using properties::Discrepancy;
using properties::Excuse;
using properties::ExcuseKind;
using properties::Standing;

/// Errors are upper bounds, and the true error may be 0. Smaller bounds are shown as "below" this.
constexpr double kSmallestShown = 1e-9;

/// Changes of the inputs up to this many u are shown in u.
constexpr double kMostRoundoffs = 1e6;

/// At most this many changed inputs of a witness are named, the most changed first.
constexpr std::size_t kMostNamed = 3;

std::string witness_text(const Discrepancy& d) {
  const reference::InputChange& change = d.excuse.witness;
  std::vector<std::size_t> changed;
  for (std::size_t k = 0; k < change.size(); ++k) {
    if (change[k] != 0) changed.push_back(k);
  }
  std::ranges::stable_sort(changed, [&](std::size_t a, std::size_t b) {
    return std::abs(change[a]) > std::abs(change[b]);
  });
  std::string text;
  for (std::size_t k = 0; k < std::min(changed.size(), kMostNamed); ++k) {
    const double share = change[changed[k]];
    text += fmt::format("{}{} * (1 {} {})", k == 0 ? "the answer is right for " : ", ",
                        input_name(d, changed[k]), share < 0 ? '-' : '+',
                        change_text(std::abs(share), d.precision));
  }
  if (changed.size() > kMostNamed) {
    text += fmt::format(" and {} changed", count_text(changed.size() - kMostNamed, "other input"));
  }
  return text;
}

constexpr std::array<std::string_view, 4> kStageNames = {"intervals", "double-doubles", "balls",
                                                         "the field"};

}  // namespace

std::string red(std::string_view text, bool colours) {
  return colours ? fmt::format(fmt::fg(fmt::terminal_color::red), "{}", text) : std::string(text);
}

std::string error_text(std::optional<double> error) {
  if (!error) return "-";
  if (*error == 0) return "0";
  if (*error < kSmallestShown) return fmt::format("<{:.0e}", kSmallestShown);
  return fmt::format("{:.3g}", *error);
}

std::string answer_text(properties::Quantity quantity, std::string_view symbol,
                        const std::vector<double>& numbers) {
  if (quantity == properties::Quantity::kNearestSphere) {
    return numbers.empty() ? "no sphere" : fmt::format("{} {}", symbol, numbers.front());
  }
  if (numbers.empty()) return "miss";
  const std::string text = scene::joined(numbers, ", ", scene::digits_and_hexfloat);
  return symbol.empty() ? text : fmt::format("{} = {}", symbol, text);
}

std::string got_text(const Discrepancy& d) {
  if (!d.got_some_sphere) return answer_text(d.quantity, d.symbol, d.got);
  return d.quantity == properties::Quantity::kClass ? "a hit" : "a sphere";
}

std::string exact_text(const Discrepancy& d) { return answer_text(d.quantity, d.symbol, d.exact); }

bool has_place(properties::Quantity quantity) {
  return quantity != properties::Quantity::kFrame &&
         quantity != properties::Quantity::kOrthonormality &&
         quantity != properties::Quantity::kRefusal;
}

std::string place_text(const properties::Place& place) {
  std::string text = place.pixel ? fmt::format("pixel ({}, {})", place.pixel->i, place.pixel->j)
                                 : fmt::format("ray {}", place.ray);
  if (place.sphere) text += fmt::format(", sphere {}", *place.sphere);
  return text;
}

std::string scene_file_text(std::string_view path, std::string_view format) {
  return !format.empty() ? fmt::format("{} (format {})", path, format) : std::string(path);
}

std::string not_needed_text(const std::vector<std::string>& not_needed) {
  if (not_needed.empty()) return "";
  return fmt::format("not needed here: {}\n", fmt::join(not_needed, ", "));
}

std::string wrong_share_text(std::uint64_t explained, std::uint64_t errors,
                             std::string_view answers) {
  if (errors == 1) {
    return fmt::format("the only wrong {} examined", answers.substr(0, answers.size() - 1));
  }
  return explained == errors
             ? fmt::format("all {} wrong {} examined", errors, answers)
             : fmt::format("{} of {} wrong {} examined", explained, errors, answers);
}

std::string explained_text(std::string_view sentence, std::uint64_t explained, std::uint64_t errors,
                           std::string_view answers) {
  return fmt::format("{}; this explains {}", sentence,
                     wrong_share_text(explained, errors, answers));
}

std::string explanations_text(const std::vector<properties::Explanation>& explanations,
                              std::string_view answers) {
  std::string text;
  for (const properties::Explanation& one : explanations) {
    text += one.explained == 0 ? one.sentence
                               : explained_text(one.sentence, one.explained, one.errors, answers);
    text += '\n';
  }
  return text;
}

std::string interval_text(const scene::ValidRoots& valid) {
  return fmt::format("{}{}, {}{}{}", valid.includes_min() ? '[' : '(', valid.t_min, valid.t_max,
                     valid.includes_max() ? ']' : ')',
                     valid.unit == scene::TUnit::kRadius   ? " radii"
                     : valid.unit == scene::TUnit::kLength ? " along the ray, in scene lengths"
                                                           : "");
}

std::string valid_roots_text(const scene::ValidRoots& valid) {
  std::string text = "s in " + interval_text(valid);
  if (valid.culling != scene::Culling::kNone) {
    text += fmt::format(", culling {}", name(valid.culling));
  }
  return text;
}

std::string conventions_text(const scene::Conventions& conventions) {
  std::string text;
  for_each_choice(conventions, [&](const char* which, auto value) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", which, name(value));
  });
  return conventions.valid.is_usual() ? text : text + ", " + valid_roots_text(conventions.valid);
}

std::string_view precision_words(scene::Precision precision) {
  return precision == scene::Precision::kDouble ? "" : ", in single precision";
}

std::string rounded_numbers_text(std::size_t count) {
  if (count == 0) return "";
  return fmt::format("{} of the scene {} not floats: judged on the rounded scene",
                     count_text(count, "number"), count == 1 ? "is" : "are");
}

std::string change_text(double relative_change, scene::Precision precision) {
  const double in_roundoffs = relative_change / scene::unit_roundoff(precision);
  const auto unit = unit_name(properties::Quantity::kHitPoint, precision);
  return in_roundoffs <= kMostRoundoffs ? fmt::format("{:.3g} {}", in_roundoffs, unit)
                                        : fmt::format("{:.3g}", relative_change);
}

std::string input_name(const Discrepancy& d, std::size_t input) {
  constexpr std::array<std::string_view, 14> kOfCamera = {
      "eye.x", "eye.y", "eye.z", "look_at.x", "look_at.y", "look_at.z", "up.x",
      "up.y",  "up.z",  "near",  "left",      "right",     "bottom",    "top"};
  constexpr std::array<std::string_view, 6> kOfRay = {"origin.x",    "origin.y",    "origin.z",
                                                      "direction.x", "direction.y", "direction.z"};
  constexpr std::array<std::string_view, 4> kOfSphere = {"centre.x", "centre.y", "centre.z",
                                                         "radius"};
  const std::size_t of_ray = d.place.pixel ? kOfCamera.size() : kOfRay.size();
  if (input < of_ray) return std::string(d.place.pixel ? kOfCamera[input] : kOfRay[input]);
  const std::size_t rest = input - of_ray;
  const std::string_view name = kOfSphere[rest % kOfSphere.size()];
  return d.quantity == properties::Quantity::kNearestSphere ||
                 d.quantity == properties::Quantity::kDepth
             ? fmt::format("spheres[{}].{}", rest / kOfSphere.size(), name)
             : std::string(name);
}

std::string standings_text(const std::function<std::uint64_t(Standing standing)>& count) {
  std::string text;
  for (std::size_t k = 0; k < properties::kStandingCount; ++k) {
    const auto standing = static_cast<Standing>(k);
    const std::uint64_t number = count(standing);
    if (number == 0) continue;
    if (!text.empty()) text += ", ";
    text += standing == Standing::kDefect ? count_text(number, name(standing))
                                          : fmt::format("{} {}", number, name(standing));
  }
  return text.empty() ? "no discrepancy" : text;
}

std::string tolerated_text(const properties::Verdict& verdict, const std::string& declared) {
  if (declared.empty() || verdict.tolerated() == 0) return {};
  return fmt::format(
      "{} of {} are right only within the declared {}: there either answer counts as right\n",
      verdict.tolerated(), count_text(verdict.compared(), "comparison"), declared);
}

std::string excuse_text(const Discrepancy& d) {
  const Excuse& excuse = d.excuse;
  switch (excuse.kind) {
    case ExcuseKind::kUndecided:
      return fmt::format(
          "it is neither proved nor refuted that the answer is right for inputs changed by {}",
          change_text(excuse.amount, d.precision));
    case ExcuseKind::kWitness:
      return witness_text(d);
    case ExcuseKind::kThreshold:
      return fmt::format("the exact s is at most the threshold {:g}", excuse.amount);
    case ExcuseKind::kIllConditioned:
      return fmt::format("ill-conditioned: the condition number {} allows this error",
                         error_text(excuse.amount));
    case ExcuseKind::kTolerance:
      return fmt::format("within the declared tolerance {:g}, where either answer is right",
                         excuse.amount);
    case ExcuseKind::kElsewhereInPixel:
      return "some point of the pixel's square may show it";
    case ExcuseKind::kOutsideDomain:
      return "a length of the scene lies outside the judged domain";
    default:
      return {};
  }
}

namespace {

/// The question that failed, as a clause; empty if it is unknown.
std::string failed_place_text(const Discrepancy& d) {
  switch (d.failed.blame) {
    case properties::Blame::kQuestion:
      return ", " + place_text(d.place);
    case properties::Blame::kAmong:
      return fmt::format(", one of {} from {} on", count_text(d.failed.count, "question"),
                         place_text(d.place));
    case properties::Blame::kTogether:
      return fmt::format(", {} from {} on: in smaller batches all are answered",
                         count_text(d.failed.count, "question"), place_text(d.place));
    default:
      return {};
  }
}

}  // namespace

std::string wrongness_text(const Discrepancy& d) {
  if (d.wrong != properties::Wrong::kNot) return std::string(name(d.wrong));
  if (std::isinf(d.error)) {
    const bool is_finite = std::ranges::all_of(d.got, [](double x) { return std::isfinite(x); });
    if (!is_finite) return "NaN or infinite";
    if (d.quantity == properties::Quantity::kOrthonormality) return "not right-handed";
  }
  return fmt::format("off by {} {}", error_text(d.error), unit_name(d.quantity, d.precision));
}

std::string discrepancy_head(const Discrepancy& d) {
  if (d.wrong == properties::Wrong::kFailed) {
    return fmt::format("no answer{}: {}", failed_place_text(d), d.what);
  }
  if (d.wrong == properties::Wrong::kRefused) return "refused: " + d.what;
  if (d.wrong == properties::Wrong::kAnswered) return "invalid input was answered: " + d.what;
  // Laws that relate answers share a quantity.
  const bool is_related = d.quantity == properties::Quantity::kInvariance && !d.law.empty();
  std::string head(is_related ? std::string_view(d.law) : info(d.quantity).name);
  if (has_place(d.quantity)) head += ", " + place_text(d.place);
  if (!d.what.empty()) head += fmt::format(", {}", d.what);
  return head + ": " + wrongness_text(d);
}

std::string discrepancy_text(const Discrepancy& d, bool colours) {
  const std::string head = discrepancy_head(d);
  const bool is_defect = d.excuse.standing() == Standing::kDefect;
  std::string text = (is_defect ? red(head, colours) : head) + "\n";
  const bool is_answer = !d.got.empty() || d.got_some_sphere;
  if (is_answer || !d.exact.empty()) {
    text += fmt::format("  got   {}\n", got_text(d));
    if (!d.exact.empty() || d.wrong != properties::Wrong::kNot) {
      // Related answers are compared with each other, unless `what` names two.
      const bool is_related = d.quantity == properties::Quantity::kInvariance && !d.symbol.empty();
      const char* const label = d.law == "growing-radius" ? "got before"
                                : is_related              ? "expected"
                                                          : "exact";
      text += fmt::format("  {} {}\n", label, exact_text(d));
    }
  }
  if (d.excluded_by) {
    text += fmt::format("  the answer s = {} lies outside the interval {}\n",
                        scene::shortest(d.got.front()), interval_text(*d.excluded_by));
  }
  // The condition number is that of the direction, not of its length.
  if (d.condition && d.quantity != properties::Quantity::kUnitDefect) {
    const bool is_small = *d.condition > 0 && *d.condition < kSmallestShown;
    text += is_small ? fmt::format("  condition number below {:.0e}\n", kSmallestShown)
                     : fmt::format("  condition number about {}\n", error_text(d.condition));
  }
  if (d.excuse.standing() != Standing::kDefect) {
    text += fmt::format("  {}: {}\n", name(d.excuse.standing()), excuse_text(d));
  }
  return text;
}

std::string single_quoted(std::string_view word) {
  return "'" + boost::replace_all_copy(std::string(word), "'", "'\\''") + "'";
}

std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=./,:@";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  if (word.find_first_of("\"$`\\!") == std::string::npos) return '"' + word + '"';
  return single_quoted(word);
}

std::string broken_law_text(std::string_view sentence, std::string_view discrepancy,
                            std::string_view causes, std::string_view replay,
                            std::string_view scene, bool is_shrunk) {
  std::string text = fmt::format("the law: {}\n{}{}", sentence, discrepancy, causes);
  if (!replay.empty()) text += fmt::format("replay: {}\n", replay);
  return text + fmt::format("the {} case, as a scene for `raycheck check`:\n{}",
                            is_shrunk ? "shrunk" : "failing", indented(scene, "  "));
}

std::string decided_by_text(const reference::DecidedBy& decided_by) {
  std::string stages;
  for (std::size_t k = 0; k < kStageNames.size(); ++k) {
    if (decided_by.stages[k] == 0) continue;
    stages +=
        fmt::format("{}{} by {}", stages.empty() ? "" : ", ", decided_by.stages[k], kStageNames[k]);
  }
  return fmt::format("{} by certified doubles, {} by exact arithmetic{}", decided_by.filter,
                     decided_by.fallback(), stages.empty() ? "" : " (" + stages + ")");
}

std::string expected_text(properties::Expected expected) {
  constexpr std::array<std::string_view, properties::kExpectedCount> kQuestions = {
      "rays that hit",
      "rays that miss",
      "hits at the smaller root",
      "hits at the larger root",
      "rays that meet several spheres",
      "rays that meet one sphere",
      "rays that meet no sphere",
      "invalid inputs",
      "values"};
  return std::string(kQuestions[static_cast<std::size_t>(expected)]);
}

std::string indented(std::string_view lines, std::string_view indent) {
  std::string text;
  bool begins = true;
  for (const char c : lines) {
    if (begins && c != '\n') text += indent;
    text += c;
    begins = c == '\n';
  }
  return text;
}

std::string count_text(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string toml_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += std::string("\\") + c;
    } else if (byte < ' ' || byte == 0x7f) {
      result += fmt::format("\\u{:04X}", byte);
    } else {
      result += c;
    }
  }
  return result + "\"";
}

}  // namespace raycheck::tools
