#include <stdexcept>
#include <utility>

#include "scene/interruption.h"
#include "tools/edge.h"
#include "tools/explain/explain.h"

namespace raycheck::tools {
namespace {

struct ExplainArguments : CommonArguments {
  std::string scene, pixel, sphere, ray;
};

ExplainOptions explain_given_ray(const ExplainArguments& arguments) {
  if (!(arguments.scene.empty() && arguments.pixel.empty() && arguments.rays.empty() &&
        arguments.dialect.empty())) {
    throw std::invalid_argument(
        "--ray: cannot be combined with SCENE, --pixel, --rays or --dialect");
  }
  if (arguments.sphere.empty()) {
    throw std::invalid_argument("--ray: also give the sphere, --sphere cx,cy,cz,r");
  }
  const auto ray = parse_list("--ray", arguments.ray, 6, "origin and direction: ox,oy,oz,dx,dy,dz");
  const auto sphere = parse_list("--sphere", arguments.sphere, 4, "centre and radius: cx,cy,cz,r");
  ExplainOptions options;
  options.scene.rays = {{{ray[0], ray[1], ray[2]}, {ray[3], ray[4], ray[5]}}};
  options.scene.spheres = {{{sphere[0], sphere[1], sphere[2]}, sphere[3]}};
  return options;
}

ExplainOptions explain_pixel(const ExplainArguments& arguments) {
  if (arguments.scene.empty() || arguments.pixel.empty()) {
    throw std::invalid_argument(
        "explain: give a scene and --pixel I,J, or --ray ox,oy,oz,dx,dy,dz and --sphere "
        "cx,cy,cz,r");
  }
  ExplainOptions options;
  auto loaded = scene::load_scene(arguments.scene, parse_dialect(arguments.dialect));
  print_warnings(loaded.warnings);
  options.scene = std::move(loaded.scene);
  if (!options.scene.camera) {
    throw std::invalid_argument(arguments.scene +
                                ": has given rays and no camera, so no pixels; explain one of "
                                "its rays by --ray and --sphere");
  }
  options.pixel = parse_pixel("--pixel", arguments.pixel, arguments.scene, options.scene);
  if (!arguments.sphere.empty()) {
    options.sphere = static_cast<std::size_t>(parse_index("--sphere", arguments.sphere, 0));
  }
  if (!arguments.rays.empty()) options.rays = &find_rays(arguments.rays);
  return options;
}

int run_explain(const ExplainArguments& arguments) {
  ExplainOptions options =
      arguments.ray.empty() ? explain_pixel(arguments) : explain_given_ray(arguments);
  if (arguments.external.candidates.size() > 1) {
    throw std::invalid_argument("--candidate: explain takes only one, and uses its conventions");
  }
  const std::vector<Implementation> candidates = find_by_stages(arguments.external);
  if (!candidates.empty()) {
    options.other = std::make_shared<const Implementation>(candidates.front());
  }
  const ExplainReport report = explain(options);
  scene::poll();
  print_view(kExplainViews, arguments.format, report);
  return exit_code(false, report.has_discrepancy(), true);
}

}  // namespace

CommandRun add_explain(CLI::App& command) {
  const auto given = std::make_shared<ExplainArguments>();
  ExplainArguments& arguments = *given;
  command.add_option("SCENE", arguments.scene, "a scene with a camera");
  add_dialect(command, arguments.dialect);
  command.add_option("--pixel", arguments.pixel, "the pixel, I,J");
  command.add_option("--rays", arguments.rays,
                     "the method that makes the ray to intersect (default: direct)");
  command.add_option("--ray", arguments.ray, "a ray instead: ox,oy,oz,dx,dy,dz");
  command.add_option("--sphere", arguments.sphere,
                     "which sphere of the scene (default: the one met first); with --ray: "
                     "cx,cy,cz,r");
  add_external(command, arguments.external);
  add_format(command, arguments.format, names_of(kExplainViews));
  return [given] { return run_explain(*given); };
}

}  // namespace raycheck::tools
