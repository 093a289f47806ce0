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
std::string check_junit(const CheckReport& report, const ViewOptions& options);
std::string check_markdown(const CheckReport& report, const ViewOptions& options);
std::string check_github(const CheckReport& report, const ViewOptions& options);
std::string check_gitlab_codequality(const CheckReport& report, const ViewOptions& options);
/// Where the scene shows discrepancies, as a PNG file: exact silhouettes, and on them the pixels of
/// the discrepancies that are kept, by standing. Of a scene without a camera a picture of nothing.
std::string check_picture(const CheckReport& report, const ViewOptions& options);

inline constexpr View<CheckReport> kCheckViews[] = {
    {"text", check_text},
    {"json", check_json},
    {"junit", check_junit},
    {"markdown", check_markdown},
    {"github", check_github, ViewKind::kCommands},
    {"gitlab-codequality", check_gitlab_codequality},
    {"picture", check_picture, ViewKind::kBytes},
};

/// A check for each quantity of each candidate.
Gate check_gate(const CheckReport& report);
/// What a baseline holds of it.
Findings findings_of(const CheckReport& report);

using NamedPlace = std::function<std::string(const properties::Place&)>;
/// What was compared of a candidate, a row a quantity; `named` says where it was worst.
std::string quantities_table(const CandidateReport& candidate,
                             const NamedPlace& named = place_text);
/// Why too little was judged to say anything; empty where it was not too little.
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
