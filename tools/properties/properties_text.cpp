#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "properties/cases/case_text.h"
#include "scene/number.h"
#include "scene/precision.h"
#include "scene/text.h"
#include "tools/properties/first_lines.h"
#include "tools/properties/properties.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using properties::CampaignPart;
using properties::CampaignResult;
using properties::Finding;
using properties::Level;
using properties::Standing;

/// "rays, up@all, distance@3..7, tangency@6,9..12": a range is a run of severities that were
/// judged one after the other.
std::string broken_text(const CampaignResult& result) {
  std::string text;
  for (const auto& parts : by_source(result)) {
    const auto broken = std::ranges::count_if(parts, &CampaignPart::is_broken);
    if (broken == 0) continue;
    const bool is_all = broken == std::ssize(parts) && broken > 1;
    std::string runs;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (is_all || !parts[k].is_broken()) continue;
      const std::size_t first = k;
      while (k + 1 < parts.size() && parts[k + 1].is_broken()) ++k;
      if (!parts[k].source.severity) continue;
      runs += fmt::format("{}{}", runs.empty() ? "@" : ",", *parts[first].source.severity);
      if (k > first) runs += fmt::format("..{}", *parts[k].source.severity);
    }
    text += fmt::format("{}{}{}", text.empty() ? "" : ", ", parts[0].source.source->name,
                        is_all ? "@all" : runs);
  }
  return text;
}

/// The severities up to which a broken law holds: "distance up to @2, scale up to @54".
std::string holding_text(const CampaignResult& result) {
  std::string text;
  for (const auto& parts : by_source(result)) {
    const auto broken = std::ranges::find_if(parts, &CampaignPart::is_broken);
    if (broken == parts.end()) continue;
    const auto held =
        std::find_if(std::make_reverse_iterator(broken), parts.rend(),
                     [](const CampaignPart& part) { return part.verdict.compared() > 0; });
    if (held == parts.rend()) continue;
    text += fmt::format("{}{} up to @{}", text.empty() ? "" : ", ", parts[0].source.source->name,
                        *held->source.severity);
  }
  return text;
}

std::string finding_text(const CampaignReport& campaign, bool colours) {
  if (campaign.finding == Finding::kBroken) return red("BROKEN", colours);
  return std::string(name(campaign.finding));
}

/// "1000 cases, 1712 comparisons, 3 excused; of the cases: 12 left out, the last because
/// no ray hits a sphere"
std::string counts_text(const CampaignResult& result) {
  const properties::CaseCounts& counts = result.counts;
  std::string text =
      fmt::format("{}, {}", count_text(static_cast<std::uint64_t>(counts.cases), "case"),
                  count_text(result.verdict.compared(), "comparison"));
  for (const Standing standing : {Standing::kExcused, Standing::kUndecided}) {
    const std::uint64_t count = result.verdict.count(standing);
    if (count > 0) text += fmt::format(", {} {}", count, name(standing));
  }
  std::string parts;
  if (counts.given_rays > 0) {
    parts += fmt::format("; {} with rays made by raycheck", counts.given_rays);
  }
  if (counts.not_judged > 0) {
    parts += fmt::format("; {} outside its domain, not judged", counts.not_judged);
  }
  if (counts.left_out > 0) {
    parts += fmt::format("; {} left out, {}because {}", counts.left_out,
                         counts.left_out == 1 ? "" : "the last ", counts.reason);
  }
  return parts.empty() ? text : text + "; of the cases: " + parts.substr(2);
}

std::string campaign_text(const PropertiesReport& report, const CampaignReport& campaign,
                          bool colours) {
  const CampaignResult& result = campaign.result;
  std::string text =
      fmt::format("{:<16} {:<26} {} on {} cases ({})\n", campaign.law->name,
                  name_in_rows(report, campaign.candidate), finding_text(campaign, colours),
                  name(result.level), counts_text(result));
  if (result.verdict.tolerated() > 0) {
    text += "    " + tolerated_text(result.verdict, campaign.implementation.tolerances);
  }
  if (campaign.finding != Finding::kTooFewJudged) return text;
  return text + fmt::format("    {}\n", too_few_text(result));
}

bool has_one_candidate(const PropertiesReport& report) {
  return std::ranges::all_of(report.campaigns, [&](const CampaignReport& campaign) {
    return campaign.candidate == report.campaigns.front().candidate;
  });
}

/// The laws that were left out, one line for each reason: "  frame, look-at, up: the candidate does
/// not implement frame()".
std::string left_out_text(const PropertiesReport& report) {
  Grouped<std::pair<std::string, std::string>> all;  // laws by candidate and reason
  for (const CampaignReport& campaign : report.campaigns) {
    if (campaign.finding != Finding::kLeftOut) continue;
    add_to(all, {name_in_rows(report, campaign.candidate), campaign.result.counts.reason},
           std::string(campaign.law->name));
  }
  const bool is_one = has_one_candidate(report);
  std::string text;
  for (const auto& [of, laws] : all) {
    text +=
        fmt::format("{}  {}{}: {}\n", text.empty() ? "left out:\n" : "",
                    is_one ? "" : fmt::format("{}: ", of.first), scene::joined(laws), of.second);
  }
  return text;
}

/// The cases of the corpus that still break their law, the cases that no longer do, and their
/// numbers.
std::string corpus_text(const PropertiesReport& report) {
  std::string text;
  std::set<std::string> files;
  std::size_t broken = 0, mended = 0;
  for (const CorpusFinding& one : report.corpus) {
    files.insert(one.file);
    const bool breaks = one.finding == Finding::kBroken;
    broken += breaks ? 1 : 0;
    mended += one.is_mended() ? 1 : 0;
    if (!breaks && !one.is_mended()) continue;
    text += fmt::format("{} {} {} with {}{}\n", one.file, breaks ? "breaks" : "no longer breaks",
                        one.law, one.candidate, breaks ? "" : ": fixed");
  }
  if (files.empty()) return "";
  return text + fmt::format("corpus: {}, {} broken, {} fixed\n", count_text(files.size(), "case"),
                            broken, mended);
}

/// The number of cases that filled a time, and for each source the largest number on which a law
/// was tried.
std::string time_text(const PropertiesReport& report) {
  if (report.time.empty()) return "";
  std::vector<std::pair<std::string_view, std::int64_t>> sources;
  for (const CampaignReport& campaign : report.campaigns) {
    for (const auto& parts : by_source(campaign.result)) {
      std::int64_t cases = 0;
      for (const CampaignPart& part : parts) cases += part.counts.cases;
      const std::string_view source = parts.front().source.source->name;
      auto known =
          std::ranges::find_if(sources, [&](const auto& one) { return one.first == source; });
      if (known == sources.end()) known = sources.insert(known, {source, 0});
      known->second = std::max(known->second, cases);
    }
  }
  std::string text =
      fmt::format("{} is --cases {}; cases of each source:", report.time, report.cases);
  for (const auto& [source, cases] : sources) {
    text += fmt::format("{} {} {}", text.back() == ':' ? "" : ",", cases, source);
  }
  return text + "\n";
}

}  // namespace

std::vector<std::span<const CampaignPart>> by_source(const CampaignResult& result) {
  std::vector<std::span<const CampaignPart>> groups;
  const std::span<const CampaignPart> all = result.parts;
  for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
    while (end < all.size() && all[end].source.source == all[first].source.source) ++end;
    groups.push_back(all.subspan(first, end - first));
  }
  return groups;
}

std::string replay_text(const CampaignReport& campaign, const std::string& replay) {
  // To replay an external implementation, the command must name it and how a renderer is judged.
  if (campaign.implementation.methods)
    return fmt::format("raycheck properties --replay {}", replay);
  return fmt::format("raycheck properties --candidate {}{} --replay {}",
                     single_quoted(campaign.candidate), campaign.implementation.arguments,
                     single_quoted(replay));
}

namespace {

/// The end of a range about a value, rounded to few digits: inside the range, and at least 9/10 as
/// far from the value.
std::string end_text(double end, double value) {
  const double least = 0.9 * std::abs(end - value);
  for (int digits = 4; digits < 17; ++digits) {
    const double x = scene::to_digits(end, digits);
    const bool is_inside = end < value ? end <= x && x < value : value < x && x <= end;
    if (is_inside && std::abs(x - value) >= least) return scene::shortest(x);
  }
  return scene::shortest(end);
}

/// "sphere 0 radius: every value tried in [0.25, 0.5] breaks the law, too (84 tried)"
std::string range_text(const properties::NumberRange& range) {
  const auto span_text = [&](const properties::Span& span) {
    return fmt::format("[{}, {}]", end_text(span.least, range.value),
                       end_text(span.greatest, range.value));
  };
  const std::string span = span_text(range.span);
  const std::string certified = range.certified ? span_text(*range.certified) : "";
  const bool is_whole = certified == span;  // as far as its digits show
  return fmt::format("{}: every {}{} breaks the law, too ({}{})\n", range.name,
                     range.is_any ? "valid number" : "value",
                     (is_whole ? "" : " tried") + (range.is_any ? "" : " in " + span),
                     is_whole ? "certified" : fmt::format("{} tried", range.samples),
                     certified.empty() || is_whole ? "" : "; certified for all in " + certified);
}

/// If a number's range has at most 2^kNarrowBits ulps, its last digits matter.
constexpr int kNarrowBits = 10;

/// A line for each number that may vary, and one line for the numbers whose last digits matter.
std::string ranges_text(const properties::Ranges& ranges, scene::Precision precision) {
  const double narrow = std::ldexp(1, kNarrowBits - scene::format_of(precision).digits);
  std::string text, exact;
  for (const properties::NumberRange& range : ranges.numbers) {
    const double width = range.span.greatest - range.span.least;
    if (width > narrow * std::abs(range.value)) {
      text += range_text(range);
    } else {
      exact += (exact.empty() ? "" : ", ") + range.name;
    }
  }
  if (!exact.empty()) text += fmt::format("the last digits of these matter: {}\n", exact);
  if (ranges.not_tried > 0) {
    text += fmt::format("{} not varied\n", count_text(ranges.not_tried, "more number"));
  }
  return text.empty() ? text : "the case's numbers, varied one at a time:\n" + indented(text, "  ");
}

}  // namespace

std::string failure_text(const CampaignReport& campaign, const properties::Failure& failure,
                         bool colours) {
  const std::vector<properties::Discrepancy> worst = failure.verdict.worst(1);
  const std::string discrepancies =
      scene::joined(worst, "", [&](const auto& one) { return discrepancy_text(one, colours); });
  std::string causes = explanations_text(campaign.explanations,
                                         campaign.implementation.draws() ? "pixels" : "answers");
  if (!worst.empty() && worst.front().wrong == properties::Wrong::kFailed) {
    causes = indented(causes, "on cases that it answers: ");
  }
  const std::string reason = fmt::format(
      "{} the law {} with {}{}", failure.is_undecided ? "leaves undecided" : "breaks",
      campaign.law->name, campaign.candidate,
      failure.tries > 0 ? fmt::format("\nshrunk for {} tries; smaller may exist", failure.tries)
                        : "");
  return broken_law_text(
      campaign.law->sentence, discrepancies, causes,
      failure.replay.empty() ? "none: found by climbing" : replay_text(campaign, failure.replay),
      properties::scene_text(failure.shrunk, reason), failure.is_shrunk);
}

std::string failure_text(const CampaignReport& campaign, bool colours) {
  const CampaignResult& result = campaign.result;
  const properties::Failure& failure = *result.failure;
  std::string text;
  if (result.parts.size() > 1 && !failure.is_undecided) {
    const std::string broken = broken_text(result);
    if (!broken.empty()) {
      text += fmt::format("broken on {}{}\n", broken,
                          broken.find('@') == std::string::npos ? "" : " (source@severity)");
    }
    const std::string holding = holding_text(result);
    if (!holding.empty()) text += fmt::format("holds on {}\n", holding);
  }
  text += failure_text(campaign, failure, colours);
  return campaign.ranges ? text + ranges_text(*campaign.ranges, campaign.precision) : text;
}

std::string too_few_text(const CampaignResult& result) {
  const auto [quantity, question] = *result.too_few_right();
  return fmt::format(
      "{}: fewer than {} of the {} are answered right without an excuse; "
      "try more --cases",
      info(quantity).name, result.fewest_right, expected_text(question));
}

std::string properties_text(const PropertiesReport& report, const ViewOptions& options) {
  std::string text = first_lines(report) + corpus_text(report);
  for (const BorrowedBounds& bounds : report.borrowed) {
    text +=
        fmt::format("{} states no error bounds, so those of {} apply; --bounds chooses others\n",
                    name_in_rows(report, bounds.candidate), bounds.methods);
  }
  for (const CampaignReport& campaign : report.campaigns) {
    if (campaign.finding == Finding::kLeftOut) continue;
    text += campaign_text(report, campaign, options.colours);
    if (campaign.worst) {
      text += fmt::format("    {}: {} by random cases, {} by climbing\n",
                          properties::kClimbNames[static_cast<std::size_t>(*report.target)],
                          error_text(campaign.worst->height_random),
                          error_text(campaign.worst->height_climbed));
    }
    if (campaign.result.failure) {
      text += indented(failure_text(campaign, options.colours), "    ");
    }
    for (const properties::Failure& other : campaign.result.others) {
      text += indented("\n" + failure_text(campaign, other, options.colours), "    ");
    }
  }
  text += left_out_text(report);
  if (report.interrupted) text += "INTERRUPTED: the laws above are those that were tried.\n";
  text += fmt::format("{}: {} broken",
                      has_one_candidate(report) ? "laws" : "pairs of a law and a candidate",
                      report.failures());
  for (const Finding finding : {Finding::kUndecided, Finding::kTooFewJudged, Finding::kNotJudged,
                                Finding::kHolds, Finding::kLeftOut}) {
    const std::uint64_t count = report.count(finding);
    if (count == 0) continue;
    text += fmt::format(", {} {}", count,
                        finding == Finding::kHolds && count > 1 ? "hold" : name(finding));
  }
  text += "\n" + time_text(report);
  return report.ratchet ? text + ratchet_text(*report.ratchet) : text;
}

}  // namespace raycheck::tools
