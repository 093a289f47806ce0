#include <fmt/core.h>

#include "tools/report/words.h"
#include "tools/view/scene_view.h"
#include "tools/worst/worst.h"

namespace raycheck::tools {

ViewDocument worst_document(const WorstReport& report, const properties::RunControl& control) {
  const properties::WorstCase& worst = *report.worst;
  ViewDocument document;
  document.title =
      fmt::format("worst case of {} on {}", report.candidate.name, report.source().name());
  SceneViewOptions view;
  view.name = "worst.toml";
  view.file = view.name;
  show(report.candidate, view);
  view.wanted = selections_of(worst.the_case, worst.shown.place);
  document.scenes.push_back(view_of(worst.the_case.scene, view, document.left_out, control));
  document.findings.push_back({discrepancy_head(worst.shown), report.candidate.name,
                               report.candidate.name, worst.shown.excuse.standing(), 0,
                               selection_of(worst.shown.place, worst.the_case.scene)});
  document.found = "1";
  return document;
}

}  // namespace raycheck::tools
