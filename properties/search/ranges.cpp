#include "properties/search/ranges.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "properties/laws/certificate.h"
#include "scene/fields.h"
#include "scene/interruption.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

/// The index of a number among the numbers of a format; 0 has the index 0.
using Rank = std::int64_t;

Rank rank_of(Precision precision, double x) {
  const double size = std::abs(x);
  const Rank rank = precision == Precision::kDouble
                        ? std::bit_cast<Rank>(size)
                        : std::bit_cast<std::int32_t>(static_cast<float>(size));
  return x < 0 ? -rank : rank;
}

double number_at(Precision precision, Rank rank) {
  const Rank size = std::abs(rank);
  const double x = precision == Precision::kDouble
                       ? std::bit_cast<double>(size)
                       : std::bit_cast<float>(static_cast<std::int32_t>(size));
  return rank < 0 ? -x : x;
}

using NamedNumbers = std::vector<std::pair<std::string, double*>>;

template <class Thing>
void name_numbers(const std::string& name, Thing& thing, NamedNumbers& numbers) {
  for_each_field(thing, [&](const std::string& key, auto& field) {
    const std::string path = name + " " + key;
    if constexpr (std::same_as<decltype(field), double&>) numbers.emplace_back(path, &field);
    if constexpr (requires { field.z; }) {
      numbers.emplace_back(path + " x", &field.x);
      numbers.emplace_back(path + " y", &field.y);
      numbers.emplace_back(path + " z", &field.z);
    }
  });
}

NamedNumbers named_numbers(Scene& scene, bool with_directions) {
  NamedNumbers numbers;
  const auto name_each = [&](const std::string& name, auto& list) {
    for (std::size_t k = 0; k < list.size(); ++k) {
      name_numbers(name + std::to_string(k), list[k], numbers);
    }
  };
  if (scene.camera) name_numbers("camera", *scene.camera, numbers);
  name_each("ray ", scene.rays);
  name_each("sphere ", scene.spheres);
  std::erase_if(numbers, [&](const auto& number) {
    return !with_directions && number.first.find(" direction ") != std::string::npos;
  });
  return numbers;
}

/// Thrown when the budget of questions is used up.
struct Spent {};

class RangeSearch {
 public:
  RangeSearch(const Law& law, const Candidate& candidate, const Case& shrunk,
              std::optional<double> max_error, bool strict)
      : law_(law),
        candidate_(candidate),
        max_error_(max_error),
        strict_(strict),
        case_(shrunk),
        last_(rank_of(candidate.precision, candidate.precision == Precision::kDouble
                                               ? std::numeric_limits<double>::max()
                                               : std::numeric_limits<float>::max())) {}

  Ranges run() {
    const NamedNumbers numbers =
        named_numbers(case_.scene, !candidate_.input_format().unit_directions);
    try {
      const auto worst = Trials(case_, candidate_, {.max_error = max_error_}).apply(law_).worst(1);
      if (worst.empty() || !is_held_against(worst.front(), strict_)) return {};
      kind_ = {worst.front().quantity, worst.front().wrong};
      for (const auto& [name, number] : numbers) {
        number_ = number;
        found_.numbers.push_back(range(name, *number));
      }
    } catch (const Spent&) {
      // The numbers before this one keep their ranges.
    } catch (const scene::Interrupted&) {
      // Here, too, the numbers before this one keep their ranges.
    }
    found_.not_tried = numbers.size() - found_.numbers.size();
    return std::move(found_);
  }

 private:
  double number(Rank at) const { return number_at(candidate_.precision, at); }

  /// Whether the case breaks the law in the same way as at first; nullopt if the law does not apply
  /// or is not judged.
  std::optional<bool> breaks() {
    if (!scene::defects(case_.scene).empty() || !is_problem(case_, candidate_.declared) ||
        !is_of_format(case_.scene, candidate_.input_format())) {
      return std::nullopt;
    }
    Trials trials(case_, candidate_, {.max_error = max_error_});
    if (!trials.of(law_).is_judged(law_.quantity)) return std::nullopt;
    if (found_.questions == kMostQuestions) throw Spent{};
    ++found_.questions;
    const std::vector<DefectKind> kinds = trials.apply(law_).defects(strict_);
    return std::find(kinds.begin(), kinds.end(), kind_) != kinds.end();
  }
  std::optional<bool> breaks(Rank at) {
    const auto [known, is_new] = asked_.try_emplace(at);
    *number_ = number(at);
    if (is_new) known->second = breaks();
    return known->second;
  }

  /// The last number that breaks the law between one that breaks it and one that does not.
  Rank bisected(Rank does, Rank does_not) {
    while (std::max(does, does_not) - 1 > std::min(does, does_not)) {
      const Rank middle = std::midpoint(does, does_not);
      const std::optional<bool> answer = breaks(middle);
      (answer == true ? does : does_not) = middle;
      holds_somewhere_ |= answer == false;
    }
    return does;
  }

  /// The ranks strictly between two, without repetition, in order from `from` to `to`.
  static std::vector<Rank> between(Rank from, Rank to, std::vector<Rank> ranks) {
    std::erase_if(ranks,
                  [&](Rank at) { return at <= std::min(from, to) || at >= std::max(from, to); });
    std::sort(ranks.begin(), ranks.end());
    ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
    if (to < from) std::reverse(ranks.begin(), ranks.end());
    return ranks;
  }

  /// Ranks from a number to one end of the format, at doubling distances, and 0.
  static std::vector<Rank> steps(Rank from, Rank last) {
    std::vector<Rank> ranks = {0};
    const std::uint64_t room = static_cast<std::uint64_t>(std::max(from, last)) -
                               static_cast<std::uint64_t>(std::min(from, last));
    for (int power = 0; power < 63 && room >> power > 0; ++power) {
      ranks.push_back(from + (last > from ? 1 : -1) * (Rank{1} << power));
    }
    ranks = between(from, last, std::move(ranks));
    ranks.push_back(last);
    return ranks;
  }

  std::vector<Rank> some_between(Rank from, Rank to) const {
    constexpr int kParts = kPointsBetween / 2 + 1;
    std::vector<Rank> ranks;
    // Modulo 2^64, because k times a part of a large range may not fit; the sum does.
    const auto part = static_cast<std::uint64_t>(to / kParts - from / kParts);
    for (std::uint64_t k = 1; k < kParts; ++k) {
      const double share = static_cast<double>(k) / kParts;
      const double even = number(from) * (1 - share) + number(to) * share;
      ranks.push_back(rank_of(candidate_.precision, even));
      ranks.push_back(static_cast<Rank>(static_cast<std::uint64_t>(from) + k * part));
    }
    return between(from, to, std::move(ranks));
  }

  /// The last number up to which the law breaks, on the way to one end of the format.
  Rank end_towards(Rank last, Rank from) {
    Rank end = from;
    std::optional<Rank> beyond;
    for (const Rank at : steps(from, last)) {
      const std::optional<bool> answer = breaks(at);
      if (answer == true) end = at;
      beyond = answer == true ? std::nullopt : std::optional(beyond.value_or(at));
      if (answer != false) continue;
      holds_somewhere_ = true;
      break;
    }
    if (beyond) end = bisected(end, *beyond);
    return settled(from, end);
  }

  /// The end of the range from a number: `end`, or the last number before one that does not break
  /// the law, of those tried now or before.
  Rank settled(Rank from, Rank end) {
    for (;;) {
      for (const Rank at : some_between(from, end)) {
        if (breaks(at) == false) break;
      }
      std::vector<Rank> known;
      for (const auto& [at, answer] : asked_) {
        if (answer.has_value()) known.push_back(at);
      }
      Rank before = from;
      std::optional<Rank> holds;
      for (const Rank at : between(from, end, std::move(known))) {
        if (breaks(at) == false) {
          holds = at;
          break;
        }
        before = at;
      }
      if (!holds) return end;
      holds_somewhere_ = true;
      end = bisected(before, *holds);
    }
  }

  /// Whether the law is proved to break at all numbers between two of the same sign at which it
  /// breaks.
  bool is_certain_between(Rank a, Rank b) {
    const auto with = [&](Rank at) {
      *number_ = number(at);
      return case_;
    };
    const scene::Box<Case> cases = {with(std::min(a, b)), with(std::max(a, b))};
    return is_certain(law_, candidate_, cases, kind_);
  }

  /// The last number, from `from` towards `to`, up to which the law is proved to break.
  Rank certain_towards(Rank to, Rank from, int& boxes) {
    if (from == to || boxes-- <= 0) return from;
    const bool has_one_sign = from == 0 || to == 0 || (from < 0) == (to < 0);
    const bool at_both = breaks(to) == true && breaks(from) == true;
    const Rank middle = has_one_sign ? std::midpoint(from, to) : 0;
    const bool is_next = middle == from || middle == to;
    if (at_both && has_one_sign && (is_next || is_certain_between(from, to))) return to;
    if (is_next) return from;
    const Rank reached = certain_towards(middle, from, boxes);
    return reached == middle ? certain_towards(to, middle, boxes) : reached;
  }

  NumberRange range(const std::string& name, double value) {
    const Rank from = rank_of(candidate_.precision, value);
    asked_ = {{from, true}};
    holds_somewhere_ = false;
    const Rank low_end = end_towards(-last_, from), high_end = end_towards(last_, from);
    const int boxes = is_certain_between(from, from) ? kMostBoxes : 0;
    int below = boxes, above = boxes;
    const Span certified = {number(certain_towards(low_end, from, below)),
                            number(certain_towards(high_end, from, above))};
    // The search for a certificate tries more numbers, which may cut the range.
    const Rank low = settled(from, low_end), high = settled(from, high_end);
    NumberRange result{name, value, {number(low), number(high)}, 0, !holds_somewhere_};
    for (const auto& [at, answer] : asked_) {
      result.samples += answer == true && low <= at && at <= high ? 1 : 0;
    }
    if (certified.least < certified.greatest) result.certified = certified;
    *number_ = value;
    return result;
  }

  const Law& law_;
  const Candidate& candidate_;
  const std::optional<double> max_error_;
  const bool strict_;
  Case case_;
  const Rank last_;  ///< The last rank of the format.
  Ranges found_;
  DefectKind kind_;
  // The number whose range is sought:
  double* number_ = nullptr;
  std::map<Rank, std::optional<bool>> asked_;
  bool holds_somewhere_ = false;
};

}  // namespace

bool has_ranges(const Candidate& candidate, const Verdict& verdict) {
  const std::vector<Discrepancy> worst = verdict.worst(1);
  return !candidate.image && !worst.empty() && worst.front().wrong != Wrong::kFailed;
}

Ranges ranges_of(const Law& law, const Candidate& candidate, const Case& shrunk,
                 std::optional<double> max_error, bool strict) {
  return RangeSearch(law, candidate, shrunk, max_error, strict).run();
}

}  // namespace raycheck::properties
