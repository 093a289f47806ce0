#include "tests/degenerate/judged.h"

#include "properties/truth.h"
#include "tests/caught/places.h"

namespace raycheck::degenerate {
namespace {

Judgement judgement(const Verdict& verdict) {
  if (!verdict.holds()) return Judgement::kBroken;
  if (verdict.compared() == 0) return Judgement::kNotAsked;
  const bool is_stretched =
      std::any_of(verdict.tallies().begin(), verdict.tallies().end(),
                  [](const auto& tally) { return tally.second.ill_conditioned > 0; });
  return verdict.discrepancies() == 0 && !is_stretched ? Judgement::kRight : Judgement::kExcused;
}

std::ptrdiff_t excused_decisions(const Verdict& verdict) {
  const auto kept = verdict.worst(properties::kKeptDiscrepancies);
  return std::count_if(kept.begin(), kept.end(),
                       [](const auto& one) { return one.wrong != properties::Wrong::kNot; });
}

const Law& law_named(std::string_view name) {
  const Law* const law = properties::find_law(name);
  if (law == nullptr) throw std::invalid_argument("no law is called " + std::string(name));
  return *law;
}

}  // namespace

DegenerateRoom::DegenerateRoom()
    : looked_at_(std::make_shared<caught::Sights::Pixels>()),
      right_(caught::exact_candidate(std::make_shared<caught::Sights>(), looked_at_)),
      all_(all_degenerate(right_)) {}

std::vector<Judged> DegenerateRoom::judge(const ChosenSource& place, int cases) const {
  return judge(all_, place, cases);
}

std::vector<Judged> DegenerateRoom::judge_right(const ChosenSource& place, int cases) const {
  static const Degenerate right = [this] {
    Degenerate it{"the right one", {}, right_};
    static_cast<properties::Domain&>(it.candidate) = caught::kRoundedDomain;
    for (const Law& law : properties::laws()) it.broken_by.push_back(law.name);
    return it;
  }();
  return judge(std::span(&right, 1), place, cases);
}

std::vector<Judged> DegenerateRoom::judge(std::span<const Degenerate> all,
                                          const ChosenSource& place, int cases) const {
  std::vector<Judged> result;
  for (const Degenerate& degenerate : all) {
    for (const std::string_view name : degenerate.broken_by) {
      const Law& law = law_named(name);
      if (caught::suits(law, *place.source)) result.push_back({&degenerate, &law, place});
    }
  }
  caught::for_each_case(place, cases, [&](int, const Case& the_case) {
    *looked_at_ = the_case.pixels;
    properties::SharedTruths truths(the_case);
    std::optional<Trial> trial;
    const Degenerate* asked = nullptr;
    bool all_are_broken = true;
    for (Judged& judged : result) {
      if (!judged.verdict.holds()) continue;
      if (excused_decisions(judged.verdict) >= kManyExcused) continue;
      all_are_broken = false;
      if (asked != judged.degenerate) {
        asked = judged.degenerate;
        trial.emplace(the_case, asked->candidate,
                      properties::TrialOptions{.truth = truths.under(asked->candidate.declared.over(
                                                   the_case.scene.conventions))});
      }
      judged.verdict.merge(apply(*judged.law, *trial));
    }
    return !all_are_broken;
  });
  for (Judged& judged : result) judged.judgement = judgement(judged.verdict);
  return result;
}

bool WhyExcused::is_about(const Judged& judged) const {
  const int severity = judged.where.severity.value_or(0);
  const auto is_among = [](const auto& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return judged.where.source->name == where.source && where.from <= severity &&
         severity <= where.to && is_among(laws, judged.law->name) &&
         (candidates.empty() || is_among(candidates, judged.degenerate->candidate.name));
}

}  // namespace raycheck::degenerate
