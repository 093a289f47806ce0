#pragma once

// The views of `check`, each in the file of its name.

#include <functional>
#include <string>
#include <vector>

#include "tools/check/check.h"
#include "tools/gates/gate.h"
#include "tools/gates/gate_views.h"
#include "tools/report/json.h"
#include "tools/report/view.h"
#include "tools/report/words.h"
#include "tools/view/document.h"

namespace raycheck::tools {

std::string check_text(const CheckReport& report, const ViewOptions& options);
std::string check_json(const CheckReport& report, const ViewOptions& options);
/// Where the scene shows discrepancies, as a PNG file: exact silhouettes, and on them the pixels of
/// the discrepancies that are kept, by standing. An empty picture for a scene without a camera.
std::string check_picture(const CheckReport& report, const ViewOptions& options);

/// A check for each quantity of each candidate; the report outlives it.
Gate check_gate(const CheckReport& report);

inline constexpr View<CheckReport> kCheckViews[] = {
    {"text", check_text},
    {"json", check_json},
    {"junit", gate_view<junit, check_gate>},
    {"markdown", gate_view<markdown, check_gate>},
    {"github", gate_view<github, check_gate>, ViewKind::kCommands},
    {"gitlab-codequality", gate_view<gitlab_codequality, check_gate>},
    {"picture", check_picture, ViewKind::kBytes},
};

using NamedPlace = std::function<std::string(const properties::Place&)>;
/// What was compared of a candidate, a row a quantity; `named` says where it was worst.
std::string quantities_table(const CandidateReport& candidate,
                             const NamedPlace& named = place_text);
/// Why too little was judged to say anything; empty if enough was.
std::string too_few_text(const CandidateReport& candidate);
Json candidate_json(const CandidateReport& candidate, std::size_t top);

/// Certificates of the worst discrepancies of each candidate, those of check_json: a line each.
std::string check_certificates(const CheckReport& report);

/// What is asked of a page besides what a report has found.
struct CheckPageOptions {
  std::vector<Selection> wanted;  ///< Shown first.
  bool is_of_methods = false;     ///< Methods were asked for: panels show the steps of no others.
};

/// The scene of a report as a page, with its worst discrepancies and largest errors beside it: one
/// view of it for raycheck's methods, and one for each implementation of someone else's.
ViewDocument check_document(const CheckReport& report, const CheckPageOptions& options,
                            const properties::RunControl& control);

}  // namespace raycheck::tools
