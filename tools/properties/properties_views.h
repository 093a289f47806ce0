#pragma once

// The views of `properties`, each in the file of its name.

#include <span>
#include <string>
#include <vector>

#include "tools/gates/gate.h"
#include "tools/gates/gate_views.h"
#include "tools/properties/properties.h"
#include "tools/report/view.h"
#include "tools/view/document.h"

namespace raycheck::tools {

std::string properties_text(const PropertiesReport& report, const ViewOptions& options);
std::string properties_json(const PropertiesReport& report, const ViewOptions& options);

/// A check for each law on each source.
Gate properties_gate(const PropertiesReport& report);

inline constexpr View<PropertiesReport> kPropertiesViews[] = {
    {"text", properties_text},
    {"json", properties_json},
    {"junit", gate_view<junit, properties_gate>},
    {"markdown", gate_view<markdown, properties_gate>},
    {"github", gate_view<github, properties_gate>, ViewKind::kCommands},
    {"gitlab-codequality", gate_view<gitlab_codequality, properties_gate>},
};

/// The parts of each source, in the order of sources.
std::vector<std::span<const properties::CampaignPart>> by_source(
    const properties::CampaignResult& result);
/// Why too little was judged to say that a law holds.
/// Domain: a campaign of which that is the finding.
std::string too_few_text(const properties::CampaignResult& result);
/// The command that asks about a case again.
std::string replay_text(const CampaignReport& campaign, const std::string& replay);
/// Why a law is broken, in lines, with the shrunk case.
/// Domain: a campaign with a failure.
std::string failure_text(const CampaignReport& campaign, bool colours);

/// The shrunk case of every broken law, as a page: a scene each.
ViewDocument properties_document(const PropertiesReport& report,
                                 const properties::RunControl& control);

}  // namespace raycheck::tools
