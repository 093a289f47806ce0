#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/decision.h"
#include "properties/excuse.h"
#include "properties/failures.h"
#include "properties/quantity.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// The questions to blame for a failure.
enum class Blame {
  kNone,      ///< Not a failure, or not searched for.
  kQuestion,  ///< One question, which fails when it is asked separately.
  kAmong,     ///< One of several, without a search for it.
  kTogether,  ///< Several asked at once: asked in parts, they are answered.
  kAnything   ///< It fails on every question.
};
inline constexpr std::array<std::string_view, 5> kBlameNames = {"none", "question", "among",
                                                                "together", "anything"};
constexpr auto& names_of(Blame /*of*/) { return kBlameNames; }

/// Where a candidate failed.
struct FailureSite {
  Blame blame = Blame::kNone;
  std::uint64_t count = 0;  ///< The number of questions to blame, from the discrepancy's place on.
  /// The single question as a scene; empty unless there is exactly one.
  std::optional<Scene> scene;
  std::optional<CodeLine> line = {};  ///< In the candidate's source, if known.
  bool timed_out = false;             ///< It gave no reply in time.
  void serialize(auto& archive) { archive(blame, count, scene, line, timed_out); }
};

/// An answer that differs from the truth by more than allowed.
struct Discrepancy {
  std::string law;
  Quantity quantity = Quantity::kFrame;
  Place place;
  std::string what;  ///< Which part: "U", "corner (0, 0)", "scaled by 2^40".
  /// The symbol of the numbers got and exact: "s", "Q"; empty if `what` says what they are.
  std::string symbol;
  std::vector<double> got;       ///< Empty: a miss, or an answer without numbers.
  std::vector<double> exact;     ///< Correctly rounded to `precision`; empty as for got.
  bool got_some_sphere = false;  ///< A picture shows an unknown sphere; or a hit without a point.
  double error = 0;              ///< In the quantity's unit; infinite for decisions.
  Precision precision = Precision::kDouble;  ///< The format of that unit.
  Wrong wrong = Wrong::kNot;
  std::optional<double> condition;  ///< The condition number, if asked for.
  Excuse excuse;
  /// The interval that the answered s is judged by, if s lies outside it.
  std::optional<scene::ValidRoots> excluded_by;
  FailureSite failed;  ///< Where it failed.
  void serialize(auto& archive) {
    archive(law, quantity, place, what, symbol, got, exact, got_some_sphere, error, precision,
            wrong, condition, excuse, excluded_by, failed);
  }
};

/// The quantity of a wrong answer, and how it is wrong, without its place.
struct DefectKind {
  Quantity quantity = Quantity::kFrame;
  Wrong wrong = Wrong::kNot;  ///< kNot for an error above its bound.
  auto operator<=>(const DefectKind&) const = default;
  void serialize(auto& archive) { archive(quantity, wrong); }
};

/// Whether a discrepancy breaks a law; if `strictly`, excused and undecided ones do so, too.
bool is_held_against(const Discrepancy& discrepancy, bool strictly);

/// The order of reports: by standing, defects first; among equals the worst of each quantity first,
/// then the second worst of each, and so on, so that no quantity hides the others. A larger error
/// is worse; then the earlier place, the law's name and the part's name decide.
std::vector<Discrepancy> worst_first(std::vector<Discrepancy> discrepancies);

}  // namespace raycheck::properties
