#pragma once

// The data of a page. The page's script only draws it; no claim depends on the script's
// computations.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/excuse.h"
#include "scene/scene.h"
#include "tools/report/json.h"
#include "tools/view/chart/chart.h"

namespace raycheck::tools {

/// The selected ray of a scene, and the selected sphere.
struct Selection {
  std::optional<scene::Pixel> pixel;
  std::optional<std::size_t> ray;
  std::optional<std::size_t> sphere;
  bool operator==(const Selection&) const = default;
};
Json selection_json(const Selection& selection);

/// Everything that a page shows about one ray and one sphere.
struct Panel {
  Selection selection;
  std::vector<std::string> wrong;  ///< The methods that are wrong there.
  Json json;                       ///< The panel in the document.
};

/// A run of successive pixels, row by row from row 0 on, with the same nearest sphere.
struct SeenRun {
  std::uint64_t pixels = 0;
  std::int32_t sphere = 0;  ///< reference::kNoSphere if there is none.
};

struct SceneView {
  std::string name;
  /// The command that makes a page of the scene, without the options for pixels and spheres.
  std::string command;
  scene::Scene scene;
  Json figure;                    ///< The figure in the document.
  Json pictures = Json::array();  ///< The pictures in the document.
  std::vector<SeenRun> seen;
  std::vector<Panel> panels;
  Selection start;  ///< The first selection.
};

struct FindingView {
  std::string sentence;
  std::string candidate;
  std::string method;  ///< The method whose steps show it in panels, or empty.
  /// Empty if the error is within the bound.
  std::optional<properties::Standing> standing = properties::Standing::kDefect;
  std::size_t scene = 0;  ///< The index of its scene in the document.
  Selection selection;
  std::string looks_like = {};  ///< A sentence on the mistake that explains it, or empty.
};

/// The severities of a source as a dial. The document's chart has one facet, for this source.
struct DialView {
  std::string sentence;
  std::vector<std::size_t> scenes;  ///< For each severity of the facet, the index of its scene.
};

struct ViewDocument {
  std::string title;
  std::vector<SceneView> scenes;
  std::vector<FindingView> findings;
  std::string found;  ///< The number of findings: "8 places, of 37 discrepancies".
  /// Appended to the place of the first finding: ", the worst of 37 discrepancies".
  std::string worst;
  std::optional<DialView> dial;
  std::optional<ChartView> chart;  ///< For a document without scenes, or with a dial.
  /// What did not fit into the page, and the commands that show it.
  std::vector<std::string> left_out;
};

/// The JSON document of a page (docs/json.md), on several lines or on one.
std::string document_json(const ViewDocument& document);
std::string document_line(const ViewDocument& document);

}  // namespace raycheck::tools
