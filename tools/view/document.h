#pragma once

// What a page shows, as data. The page's script draws it and computes nothing that a claim rests
// on.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "properties/excuse.h"
#include "scene/scene.h"
#include "tools/explain/explain.h"
#include "tools/report/picture_file.h"
#include "tools/view/chart/chart.h"

namespace raycheck::tools {

/// A position or a direction that is drawn.
/// Units: (p - origin) * 2^scale_exponent of the figure that it belongs to; directions are unit.
using Drawn = std::array<double, 3>;

/// Places that have a name: figure_parts.h says what is drawn between, at and beside them.
using DrawnPlaces = std::vector<std::pair<std::string, Drawn>>;

/// A camera that is drawn, with the eye as the origin.
struct DrawnCamera {
  Drawn U, V, W;
  double near = 0, left = 0, right = 0, bottom = 0, top = 0;
  Drawn first, column, row;  ///< P of pixel (0, 0), and the ways to the next column and row.
  std::array<double, 4>
      window{};  ///< Tangents: what the picture shows, from left, right to bottom, top.
  std::array<std::int64_t, 2> pixel_steps{}, ray_steps{};  ///< Columns, rows: one in so many.
  double counts_from = 0, counts_to = 0;                   ///< Which s count,
  bool in_radii = false;                                   ///< in radii of the sphere,
  bool smaller_counts = true, larger_counts = true;        ///< and of which roots.
};

struct DrawnSphere {
  Drawn centre;
  double radius = 0;
  Colour colour;
  std::string label;  ///< "sphere 0: C = (5, 5, 5), r = 3"
};

/// A ray that a scene gives.
struct DrawnRay {
  Drawn origin, direction;
  std::optional<Drawn> hit;
};

/// A scene as it is drawn: every coordinate is computed exactly relative to the origin, scaled by a
/// power of two and rounded once; the frustum's corners, of the rounded axes, within 8u of their
/// distance.
struct Figure {
  scene::Point3 origin;  ///< The eye, or the origin of the first given ray, in the scene.
  int scale_exponent = 0;
  std::optional<DrawnCamera> camera;
  std::vector<DrawnRay> rays;
  std::vector<DrawnSphere> spheres;
  std::size_t spheres_left_out = 0;
  DrawnPlaces places;              ///< Of the camera.
  double size = 0;                 ///< How far the frustum reaches, or given rays and a sphere,
  double reach = 0;                ///< and what a view of the whole shows.
  std::vector<Drawn> whole;        ///< What it shows besides spheres,
  std::vector<std::size_t> apart;  ///< and the spheres that it leaves out.
  bool is_out_of_scale = false;    ///< It shows little: the view from the eye comes first.
  std::vector<std::string> notes;  ///< On what is not drawn as it is.
};

/// Which ray of a scene is looked at, and which of its spheres.
struct Selection {
  std::optional<scene::Pixel> pixel;
  std::optional<std::size_t> ray;
  std::optional<std::size_t> sphere;
  bool operator==(const Selection&) const = default;
};

/// A ray and the sphere that its panel speaks of.
struct PanelDrawing {
  Drawn direction;              ///< D
  std::optional<Drawn> across;  ///< Of the sphere: a unit vector square to D, towards its centre.
  double until = 0;             ///< How far from L the line is drawn.
  DrawnPlaces places;           ///< L, P, the foot L + v D, the roots, what lies behind.
  std::vector<std::pair<std::string, std::string>> names;  ///< What is written at a place.
};

/// Where a method's answer lies in the microscope.
struct MicroscopeMark {
  std::string method;
  std::size_t number = 0;  ///< Which shape and colour it has: its place among all methods.
  bool is_point = false;   ///< Its hit point; else its s, on the exact ray.
  double x = 0, y = 0;
  bool is_wrong = false;
  std::string text;
  std::size_t window = 0;  ///< The narrowest zoom that shows it, or the widest.
};

/// The neighbourhood of the exact hit point, or of the ray's point nearest to the centre where the
/// exact answer is a miss, in the plane through the ray and the centre.
/// Units: ulp of that point's parameter; x along the ray, y from the ray towards the centre. Every
///        coordinate is a difference that was enclosed to within 2^-34 of itself.
struct Microscope {
  bool is_hit = false;
  std::vector<std::string> sentences;  ///< What is seen, and what there is nothing to draw of.
  double parameter = 0;                ///< s of the point, correctly rounded.
  double ulp = 0;
  struct Zoom {
    double half_width = 0;
    std::vector<std::array<double, 2>> curve;  ///< The exact circle.
  };
  std::vector<Zoom> zooms;
  std::vector<double> grid;  ///< The numbers of the format around s.
  std::optional<double>
      region;  ///< What a relative change u of inputs may move s by; empty: no bound.
  std::vector<MicroscopeMark> marks;
};

/// All that is said about one ray and one sphere.
struct Panel {
  Selection selection;
  std::string command;  ///< What prints `text`.
  std::string text;     ///< As explain prints it.
  ExplainReport report;
  PanelDrawing drawing;
  std::optional<Microscope> microscope;
  std::string sage, latex;
};

struct LegendEntry {
  Colour colour;
  std::string text;
  std::optional<std::uint64_t> pixels;
};

enum class PictureKind { kCertified, kAnswered, kError };
inline constexpr std::array<std::string_view, 3> kPictureKindNames = {"certified", "answered",
                                                                      "error"};
constexpr std::string_view name(PictureKind kind) {
  return kPictureKindNames[static_cast<std::size_t>(kind)];
}

struct ScenePicture {
  PictureKind kind = PictureKind::kCertified;
  std::string candidate;  ///< Of the others.
  std::string png;        ///< The bytes of the file.
  std::vector<LegendEntry> legend;
};

/// So many pixels, one after the other along the rows from row 0 on, see the same.
struct SeenRun {
  std::uint64_t pixels = 0;
  std::int32_t sphere = 0;  ///< reference::kNoSphere: none.
};

struct SceneView {
  std::string name;
  std::string command;  ///< What makes a page of it; pixels and spheres are added.
  scene::Scene scene;
  Figure figure;
  std::vector<ScenePicture> pictures;
  std::vector<SeenRun> seen;
  std::vector<Panel> panels;
  Selection start;  ///< What is shown first.
};

/// Something to look at.
struct FindingView {
  std::string sentence;
  std::string candidate;
  std::string method;  ///< The one of its methods that panels show it by; empty: none does.
  /// Empty of what is within its bound.
  std::optional<properties::Standing> standing = properties::Standing::kDefect;
  std::size_t scene = 0;  ///< Index into the document's.
  Selection selection;
  std::string looks_like = {};  ///< A sentence about the classic mistake that explains it.
};

/// A stress family's dial: the document's chart is its one facet.
struct DialView {
  std::string sentence;
  std::vector<std::size_t> scenes;  ///< Of each severity of the facet, index into the document's.
};

struct ViewDocument {
  std::string title;
  std::vector<SceneView> scenes;
  std::vector<FindingView> findings;
  std::string found;  ///< How many there are, of how many: "8 of 37 discrepancies".
  std::string worst;  ///< Of the first, behind its place: ", the worst of 37 discrepancies".
  std::optional<DialView> dial;
  std::optional<ChartView> chart;     ///< Of a document without scenes, or of a dial.
  std::vector<std::string> left_out;  ///< What there is no room for, and how to ask for it.
};

/// The document that a page is made of, on one line or several (docs/json.md).
std::string document_json(const ViewDocument& document);
std::string document_line(const ViewDocument& document);

/// A panel as the document has it.
std::string panel_line(const Panel& panel);

}  // namespace raycheck::tools
