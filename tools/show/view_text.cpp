#include "tools/show/view_text.h"

#include <fmt/core.h>

#include <algorithm>

#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

/// The first findings; the page has them all.
constexpr std::size_t kMostLines = 5;

std::string scene_text(const SceneView& view) {
  const scene::Scene& scene = view.scene;
  const std::string rays =
      scene.camera ? fmt::format("{} x {} pixels", scene.camera->width, scene.camera->height)
                   : count_text(scene.rays.size(), "ray");
  return fmt::format("{}: {}, {}, the steps of {}\n", view.name, rays,
                     count_text(scene.spheres.size(), "sphere"),
                     count_text(view.panels.size(), "pair"));
}

}  // namespace

std::string view_text(const ViewDocument& document, const std::string& file, std::size_t bytes) {
  std::string text;
  for (const SceneView& view : document.scenes) text += scene_text(view);
  const std::size_t shown = std::min(document.findings.size(), kMostLines);
  for (std::size_t k = 0; k < shown; ++k) {
    const FindingView& finding = document.findings[k];
    text += fmt::format("  {}: {}\n", finding.candidate, finding.sentence);
  }
  if (shown < document.findings.size()) {
    text += fmt::format("  and {} more beside the figure\n", document.findings.size() - shown);
  }
  for (const std::string& sentence : document.left_out) text += "left out: " + sentence + "\n";
  return text + fmt::format("{} written, {} bytes: open it in a browser\n", file, bytes);
}

}  // namespace raycheck::tools
