#pragma once

// The data of a page. The page's script only draws it: no claim depends on its computations.

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

/// Everything about one ray and one sphere.
struct Panel {
  Selection selection;
  std::vector<std::string> wrong;  ///< The methods that go wrong.
  Json json;                       ///< As in the document.
};

/// A run of successive pixels, along the rows from row 0 on, with the same nearest sphere.
struct SeenRun {
  std::uint64_t pixels = 0;
  std::int32_t sphere = 0;  ///< reference::kNoSphere: none.
};

struct SceneView {
  std::string name;
  std::string command;  ///< The command that makes a page of it, without pixels and spheres.
  scene::Scene scene;
  Json figure;                    ///< As in the document.
  Json pictures = Json::array();  ///< As in the document.
  std::vector<SeenRun> seen;
  std::vector<Panel> panels;
  Selection start;  ///< The first selection.
};

struct FindingView {
  std::string sentence;
  std::string candidate;
  std::string method;  ///< The method by which panels show it; or empty.
  /// Empty for errors within the bound.
  std::optional<properties::Standing> standing = properties::Standing::kDefect;
  std::size_t scene = 0;  ///< Index into the document's.
  Selection selection;
  std::string looks_like = {};  ///< A sentence on the mistake that explains it.
};

/// A stress family's dial: the document's chart is its one facet.
struct DialView {
  std::string sentence;
  std::vector<std::size_t> scenes;  ///< For each severity of the facet, an index into scenes.
};

struct ViewDocument {
  std::string title;
  std::vector<SceneView> scenes;
  std::vector<FindingView> findings;
  std::string found;  ///< The number of findings: "8 places, of 37 discrepancies".
  std::string worst;  ///< Appended to the first's place: ", the worst of 37 discrepancies".
  std::optional<DialView> dial;
  std::optional<ChartView> chart;     ///< For a document without scenes, or a dial.
  std::vector<std::string> left_out;  ///< What did not fit, and the command that shows it.
};

/// The JSON document of a page, on one line or several (docs/json.md).
std::string document_json(const ViewDocument& document);
std::string document_line(const ViewDocument& document);

}  // namespace raycheck::tools
