#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "scene/interruption.h"
#include "tools/check/check.h"
#include "tools/edge.h"
#include "tools/report/words.h"
#include "tools/stress/stress.h"
#include "tools/view/document.h"
#include "tools/view/page/page.h"

namespace raycheck::tools {
namespace {

struct ViewArguments : CommonArguments {
  std::string scene, family, out, sphere;
  int cases = 100;
  std::uint64_t seed = 1;
  std::vector<std::string> methods, pixels;
};

/// If rays times spheres is at most this, every ray is judged. If rays times spheres times methods
/// is at most this, all methods of fast/ are the default.
constexpr double kMostJudged = 1 << 22;

struct Size {
  double rays = 0, spheres = 0;
};

Size size_of(const scene::Scene& scene) {
  const auto& camera = scene.camera;
  const double rays = camera
                          ? static_cast<double>(camera->width) * static_cast<double>(camera->height)
                          : static_cast<double>(scene.rays.size());
  return {rays, static_cast<double>(scene.spheres.size())};
}

/// The default methods: every intersection method if the scene is small enough, otherwise cross.
std::vector<MethodPair> default_methods(const Size& size) {
  const auto all = fast::intersect_methods();
  if (size.rays * size.spheres * static_cast<double>(all.size()) > kMostJudged) {
    return {kDefaultMethods};
  }
  std::vector<MethodPair> pairs;
  for (const fast::IntersectMethod* method : all) pairs.push_back({kDefaultMethods.rays, method});
  return pairs;
}

std::vector<Selection> wanted(const ViewArguments& arguments, const scene::Scene& scene) {
  std::vector<Selection> list;
  std::optional<std::size_t> sphere;
  if (!arguments.sphere.empty()) {
    sphere = static_cast<std::size_t>(parse_index("--sphere", arguments.sphere, 0));
  }
  for (const std::string& text : arguments.pixels) {
    list.push_back({parse_pixel("--pixel", text, arguments.scene, scene), {}, sphere});
  }
  if (sphere && list.empty()) {
    throw std::invalid_argument("--sphere: also give --pixel I,J");
  }
  return list;
}

CheckOptions check_options(const ViewArguments& arguments, const Size& size) {
  CheckOptions options;
  options.path = arguments.scene;
  options.read_as = parse_dialect(arguments.dialect);
  std::optional<DriverRule> driver;
  if (options.read_as != nullptr) driver = parse_driver(arguments.dialect);
  options.keeps_forms = driver.has_value();
  options.implementations = find_candidates(arguments.external, driver);
  if (size.rays * size.spheres > kMostJudged) {
    options.pixels = static_cast<std::int64_t>(std::max(kMostJudged / size.spheres, 256.0));
  }
  const bool methods_asked = !arguments.methods.empty() || !arguments.rays.empty();
  if (options.implementations.empty() || methods_asked) {
    const auto pairs =
        built_in(methods_asked ? chosen_methods(arguments.rays, arguments.methods, "method")
                               : default_methods(size));
    options.implementations.insert(options.implementations.begin(), pairs.begin(), pairs.end());
  }
  return options;
}

ViewDocument of_scene(const ViewArguments& arguments, const properties::RunControl& control) {
  const auto loaded = scene::load_scene(arguments.scene, parse_dialect(arguments.dialect));
  const CheckPageOptions options = {wanted(arguments, loaded.scene),
                                    !arguments.methods.empty() || !arguments.rays.empty()};
  const CheckReport report = check(check_options(arguments, size_of(loaded.scene)), control);
  print_warnings(report.warnings);
  return check_document(report, options, control);
}

ViewDocument of_family(const ViewArguments& arguments, const properties::RunControl& control) {
  StressOptions options;
  options.families = {arguments.family};
  options.implementations = find_by_stages(arguments.methods, arguments.external);
  options.cases = arguments.cases;
  options.seed = arguments.seed;
  return dial_document(options, !arguments.methods.empty(), control);
}

/// At most this many findings are printed; the page has all of them.
constexpr std::size_t kMostLines = 5;

std::string scene_text(const SceneView& view) {
  const scene::Scene& scene = view.scene;
  const std::string rays =
      scene.camera ? fmt::format("{} x {} pixels", scene.camera->width, scene.camera->height)
                   : count_text(scene.rays.size(), "ray");
  return fmt::format("{}: {}, {}, the steps of {} of a ray and a sphere\n", view.name, rays,
                     count_text(scene.spheres.size(), "sphere"),
                     count_text(view.panels.size(), "pair"));
}

/// The contents of a page in lines: its first view, its findings, and what was left out.
std::string view_text(const ViewDocument& document, const std::string& file, std::size_t bytes) {
  std::string text;
  for (const SceneView& view : document.scenes) text += scene_text(view);
  const std::size_t shown = std::min(document.findings.size(), kMostLines);
  for (std::size_t k = 0; k < shown; ++k) {
    const FindingView& finding = document.findings[k];
    text += fmt::format("  {}: {}\n", finding.candidate, finding.sentence);
  }
  if (shown < document.findings.size()) {
    text += fmt::format("  and {} more on the page\n", document.findings.size() - shown);
  }
  for (const std::string& sentence : document.left_out) text += "left out: " + sentence + "\n";
  return text + fmt::format("wrote {}, {} bytes: open it in a browser\n", file, bytes);
}

int run_view(const ViewArguments& arguments) {
  if (arguments.scene.empty() == arguments.family.empty()) {
    throw std::invalid_argument("view: give a scene, or --source NAME for a source of cases");
  }
  if (!arguments.family.empty() && !(arguments.dialect.empty() && arguments.rays.empty() &&
                                     arguments.pixels.empty() && arguments.sphere.empty())) {
    throw std::invalid_argument(
        "--source: cannot be combined with --dialect, --rays, --pixel or --sphere");
  }
  if (arguments.out.empty() && arguments.format != "json") {
    throw std::invalid_argument("view: give --out FILE.html, or --format json");
  }
  std::optional<OutputFile> out;
  if (!arguments.out.empty()) out.emplace("--out", arguments.out);
  const auto control = run_control("view", arguments.threads);
  const ViewDocument document =
      arguments.family.empty() ? of_scene(arguments, control) : of_family(arguments, control);
  if (control.interrupted()) throw scene::Interrupted();
  if (out) {
    const std::string text = page(document);
    out->write(text);
    if (arguments.format == "text") {
      print_report(view_text(document, arguments.out, text.size()));
    }
  }
  if (arguments.format == "json") print_report(document_json(document));
  return kExitNothingFound;
}

}  // namespace

CommandRun add_view(CLI::App& command) {
  const auto given = std::make_shared<ViewArguments>();
  ViewArguments& arguments = *given;
  command.add_option("SCENE", arguments.scene, "a TOML scene, or a driver file of the course");
  command.add_option(
      "--source,--family", arguments.family,
      "a source of cases in place of a scene; the page shows a scene at each severity");
  add_cases(command, arguments.cases, "the number of cases at each severity of a source");
  add_seed(command, arguments.seed);
  command.add_option("--out", arguments.out, "the page: one self-contained HTML file");
  add_dialect(command, arguments.dialect);
  command
      .add_option("--method", arguments.methods,
                  "the methods that intersect, separated by commas (default: all, or for large "
                  "scenes cross)")
      ->delimiter(',');
  command.add_option("--rays", arguments.rays, "the method that makes rays (default: direct)");
  command.add_option("--pixel", arguments.pixels, "a pixel to begin with, I,J; may be repeated");
  command.add_option("--sphere", arguments.sphere, "the sphere to begin with");
  add_external(command, arguments.external);
  add_threads(command, arguments.threads, "the page");
  add_format(command, arguments.format, {"text", "json"});
  return [given] { return run_view(*given); };
}

}  // namespace raycheck::tools
