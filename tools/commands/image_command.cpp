#include <fmt/core.h>

#include <stdexcept>

#include "scene/number.h"
#include "tools/edge.h"
#include "tools/image/image.h"

namespace raycheck::tools {
namespace {

struct ImageArguments : CommonArguments {
  std::string scene, out, size;
  std::string one_intersect;  ///< Of --intersect, which may not be repeated here.
  Picture what = Picture::kSphere;
  bool strict = false;
};

scene::Pixel parse_size(const std::string& text) {
  const auto sides = parse_list("--size", text, 2, "pixels across and down: W,H");
  const std::string side = "--size " + text + ": side";
  return {parse_index(side.c_str(), scene::shortest(sides[0]), 1, kMostPictureSide),
          parse_index(side.c_str(), scene::shortest(sides[1]), 1, kMostPictureSide)};
}

int run_image(const ImageArguments& arguments) {
  ImageOptions options;
  options.path = arguments.scene;
  options.read_as = parse_dialect(arguments.dialect);
  options.what = arguments.what;
  if (!arguments.size.empty()) options.size = parse_size(arguments.size);
  const std::vector<std::string>& candidates = arguments.external.candidates;
  for (const auto& [option, value] :
       {std::pair("--rays", arguments.rays), std::pair("--intersect", arguments.one_intersect),
        std::pair("--candidate", candidates.empty() ? "" : candidates.front())}) {
    if (options.what == Picture::kError || value.empty()) continue;
    throw std::invalid_argument(
        fmt::format("{} {}: only --what error shows a candidate or method; --what sphere shows the "
                    "exact answer",
                    option, value));
  }
  if (!arguments.rays.empty()) options.methods.rays = &find_rays(arguments.rays);
  if (!arguments.one_intersect.empty()) {
    options.methods.intersect = &find_intersect(arguments.one_intersect);
  }
  if (candidates.size() > 1) {
    throw std::invalid_argument("--candidate: a picture shows only one candidate");
  }
  const std::vector<Implementation> candidates_found = find_by_stages(arguments.external);
  options.implementation =
      candidates_found.empty() ? built_in(options.methods) : candidates_found.front();
  PictureFile file("--out", arguments.out);
  const ImageReport report =
      make_image(options, file, run_control(options.path, arguments.threads));
  print_warnings(report.warnings);
  print_view(kImageViews, arguments.format, report);
  using properties::Standing;
  const ErrorCounts errors = report.error.value_or(ErrorCounts{});
  const std::uint64_t lenient =
      errors.count(Standing::kExcused) + errors.count(Standing::kUndecided);
  return exit_code(report.interrupted,
                   errors.count(Standing::kDefect) > 0 || (arguments.strict && lenient > 0),
                   errors.count(Standing::kUndecided) == 0);
}

}  // namespace

CommandRun add_image(CLI::App& command) {
  const auto given = std::make_shared<ImageArguments>();
  ImageArguments& arguments = *given;
  command.add_option("SCENE", arguments.scene, "a scene with a camera")->required();
  command.add_option("--out", arguments.out, "the picture, .png or .ppm")
      ->required()
      ->type_name("FILE");
  add_named(command, "--what", arguments.what, kPictureNames,
            "sphere: the nearest spheres, shaded; error: the error of s by a method or candidate");
  command.add_option("--rays", arguments.rays,
                     "for --what error: the method that makes rays (default: direct)");
  command.add_option("--intersect", arguments.one_intersect,
                     "for --what error: the method that intersects rays (default: cross)");
  command.add_option("--size", arguments.size,
                     "pixels across and down, W,H (default: the scene's)");
  add_strict(command, arguments.strict);
  add_threads(command, arguments.threads, "the picture");
  add_dialect(command, arguments.dialect);
  add_external(command, arguments.external);
  command.get_option("--candidate")->excludes(command.get_option("--intersect"));
  add_format(command, arguments.format, names_of(kImageViews));
  return [given] { return run_image(*given); };
}

}  // namespace raycheck::tools
