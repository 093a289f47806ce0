#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "scene/text.h"
#include "tools/properties/properties.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using properties::CampaignPart;
using properties::Finding;
using properties::Standing;
using Parts = std::span<const CampaignPart>;

/// At most this many broken parts of a source get a replay command.
constexpr std::size_t kMostReplays = 3;

std::string source_of(Parts parts) { return std::string(parts.front().source.source->name); }

std::uint64_t compared(Parts parts) {
  std::uint64_t count = 0;
  for (const CampaignPart& part : parts) count += part.verdict.compared();
  return count;
}

std::uint64_t count(Parts parts, Standing standing) {
  std::uint64_t count = 0;
  for (const CampaignPart& part : parts) count += part.verdict.count(standing);
  return count;
}

Identity identity_of(const CampaignReport& campaign, const CampaignPart& part, std::string kind) {
  return {std::string(campaign.law->name), std::string(part.source.source->name), std::move(kind),
          std::string(name(part.source.level())), campaign.lasting_name};
}

/// The defects of a candidate, or its undecided discrepancies.
std::vector<Identity> found_of(const CampaignReport& campaign, Parts parts, bool is_held) {
  std::set<Identity> found;
  for (const CampaignPart& part : parts) {
    if (!is_held) {
      for (const properties::DefectKind& kind : part.undecided) {
        found.insert(identity_of(campaign, part, undecided_text(kind)));
      }
      continue;
    }
    for (const properties::Break& one : part.breaks) {
      for (const properties::DefectKind& kind : one.defects) {
        found.insert(identity_of(campaign, part, kind_text(kind)));
      }
    }
  }
  return {found.begin(), found.end()};
}

/// "the far root is taken (root: wrong root, ordinary cases)"
std::string summary_of(const CampaignReport& campaign, const std::vector<Identity>& defects) {
  const std::string shown = scene::joined(defects, "; ", [](const Identity& one) {
    return (one.kind == "refusal: failed" ? "no answer" : one.kind) + ", " + one.place + " cases";
  });
  const std::string why = campaign.explanations.empty()
                              ? fmt::format("breaks the law: {}", campaign.law->sentence)
                              : campaign.explanations.front().sentence;
  return fmt::format("{} ({})", why, shown);
}

std::string text_of(const CampaignReport& campaign, Parts parts) {
  const auto& failure = campaign.result.failure;
  const bool has_failure =
      failure && std::ranges::any_of(parts, [&](const CampaignPart& part) {
        return part.is_broken() && part.breaks.front().replay == failure->replay;
      });
  if (has_failure) return failure_text(campaign, false);
  std::string text = fmt::format("the law: {}\n", campaign.law->sentence);
  std::string severities;
  std::size_t replays = 0;
  for (const CampaignPart& part : parts) {
    if (!part.is_broken()) continue;
    severities += fmt::format("{}{}", severities.empty() ? "" : ", ", part.source.name());
    if (replays++ >= kMostReplays) continue;
    text += fmt::format("replay: {}\n", replay_text(campaign, part.breaks.front().replay));
  }
  return text + fmt::format("broken on {}\n", severities);
}

void add_check_of(const CampaignReport& campaign, Parts parts, Gate& gate) {
  GateCheck& check =
      add_check(gate,
                {.candidate = campaign.candidate,
                 .name = fmt::format("{}/{}", campaign.law->name, source_of(parts)),
                 .defects = found_of(campaign, parts, true)},
                {count(parts, Standing::kUndecided), found_of(campaign, parts, false)});
  for (const CampaignPart& part : parts) {
    for (const properties::Break& one : part.breaks) {
      if (!check.line) check.line = one.failed_at;
    }
  }
  const auto& shown = campaign.result.failure;
  const bool is_shown_undecided =
      shown && shown->is_undecided &&
      properties::parse_replay(shown->replay).source.source == parts.front().source.source;
  if (is_shown_undecided) check.text = failure_text(campaign, false);
  if (!check.summary.empty()) return;
  if (!check.defects.empty()) {
    check.summary = summary_of(campaign, check.defects);
    check.text = text_of(campaign, parts);
  } else if (compared(parts) == 0) {
    check.outcome = GateOutcome::kLeftOut;
    const std::string& reason = parts.back().counts.reason;
    check.summary = reason.empty() ? "outside the judged domain" : reason;
  }
}

/// Adds a check of a case in the corpus. The corpus counts as a source, and the file as the place.
void add_check_of(const CorpusFinding& one, Gate& gate) {
  const std::string source = "corpus";
  std::vector<Identity> found;
  for (const properties::DefectKind& kind : one.defects) {
    found.push_back({one.law, source, kind_text(kind), one.file, one.lasting_name});
  }
  GateCheck& check = add_check(gate,
                               {.candidate = one.candidate,
                                .name = fmt::format("{}/{}/{}", one.law, source, one.file),
                                .defects = std::move(found)},
                               {});
  if (check.defects.empty()) {
    if (one.finding == Finding::kHolds) return;
    check.outcome = GateOutcome::kLeftOut;
    check.summary = std::string(name(one.finding));
    return;
  }
  check.summary = fmt::format("breaks the law again ({})", check.defects.front().kind);
  check.text = fmt::format("the case that breaks the law: {}\n", one.file);
}

/// A check of a whole law, besides the checks on its sources.
std::optional<GateCheck> whole_of(const CampaignReport& campaign) {
  GateCheck check;
  check.candidate = campaign.candidate;
  check.name = std::string(campaign.law->name);
  switch (campaign.finding) {
    case Finding::kTooFewJudged:
      check.outcome = GateOutcome::kInconclusive;
      check.summary = too_few_text(campaign.result);
      return check;
    case Finding::kLeftOut:
    case Finding::kNotJudged:
      check.outcome = GateOutcome::kLeftOut;
      check.summary = campaign.result.counts.reason.empty() ? std::string(name(campaign.finding))
                                                            : campaign.result.counts.reason;
      return check;
    default:
      return std::nullopt;
  }
}

}  // namespace

Gate properties_gate(const PropertiesReport& report) {
  Gate gate;
  gate.command = "properties";
  gate.about =
      report.seed
          ? fmt::format("laws on sources, {} for each law and candidate, seed {}",
                        count_text(static_cast<std::uint64_t>(report.cases), "case"), *report.seed)
          : "replay of one case";
  gate.ratchet = report.ratchet;
  for (const CorpusFinding& one : report.corpus) {
    add_check_of(one, gate);
    const Scope scope = {one.law, "corpus", one.lasting_name};
    gate.findings.asked.insert(scope);
    gate.findings.complete.insert(scope);
  }
  for (const CampaignReport& campaign : report.campaigns) {
    const std::string& file = campaign.implementation.source_file;
    if (!file.empty()) gate.sources.emplace(campaign.candidate, file);
    if (auto whole = whole_of(campaign)) {
      gate.checks.push_back(std::move(*whole));
      if (campaign.finding != Finding::kTooFewJudged) continue;
    }
    for (const Parts parts : by_source(campaign.result)) {
      add_check_of(campaign, parts, gate);
      if (compared(parts) == 0 || report.interrupted) continue;
      const Scope scope = {std::string(campaign.law->name), source_of(parts),
                           campaign.lasting_name};
      gate.findings.asked.insert(scope);
      // A part ends at its first broken case, so that other defects in it are unknown.
      if (gate.checks.back().defects.empty()) gate.findings.complete.insert(scope);
    }
  }
  complete(gate, report.interrupted);
  return gate;
}

}  // namespace raycheck::tools
