#include <fmt/core.h>
#include <tbb/info.h>

#include <memory>
#include <stdexcept>

#include "scene/number.h"
#include "tools/arguments.h"
#include "tools/commands.h"
#include "tools/image/image.h"
#include "tools/image/image_paint.h"
#include "tools/report/output_file.h"
#include "tools/terminal.h"

namespace raycheck::tools {
namespace {

struct ImageArguments {
  std::string scene;
  std::string out;
  Picture what = Picture::kSphere;
  std::string dialect;
  std::string rays;
  std::string intersect;
  std::string size;
  bool strict = false;
  int threads = tbb::info::default_concurrency();
  std::string format;
  ExternalArguments external;
};

/// The colours of the picture of errors, for --help.
std::string legend() {
  std::string text =
      "error colours, on a log scale (rrggbb), by how many ulp s is off (of float, for who is "
      "judged "
      "in single precision):";
  for (const ErrorStep& step : kErrorSteps) {
    const bool last = &step == &kErrorSteps.back();
    text += fmt::format("\n  {} {}", hex(step.colour),
                        last ? "more" : fmt::format("up to {}", step.at_most));
  }
  text += "\nand where it is wrong: missed, a false hit, or not the nearest sphere:";
  for (std::size_t k = 0; k < kWrongColours.size(); ++k) {
    text += fmt::format("\n  {} {}", hex(kWrongColours[k]), properties::kStandingNames[k]);
  }
  return text;
}

scene::Pixel parse_size(const std::string& text) {
  const auto sides = parse_list("--size", text, 2, "pixels across and down: W,H");
  const std::string side = "--size " + text + ": side";
  return {parse_index(side.c_str(), scene::shortest(sides[0]), 1, kMostPictureSide),
          parse_index(side.c_str(), scene::shortest(sides[1]), 1, kMostPictureSide)};
}

int run_image(const ImageArguments& arguments) {
  ImageOptions options;
  options.path = arguments.scene;
  options.dialect = parse_dialect(arguments.dialect);
  options.what = arguments.what;
  if (!arguments.size.empty()) options.size = parse_size(arguments.size);
  for (const auto& [option, value] :
       {std::pair("--rays", &arguments.rays), std::pair("--intersect", &arguments.intersect)}) {
    if (options.what != Picture::kError && !value->empty()) {
      throw std::invalid_argument(
          fmt::format("{} {}: only --what error shows a method; the others show the exact answer",
                      option, *value));
    }
  }
  if (!arguments.rays.empty()) options.methods.rays = &find_rays(arguments.rays);
  if (!arguments.intersect.empty()) {
    options.methods.intersect = &find_intersect(arguments.intersect);
  }
  const std::vector<std::string>& candidates = arguments.external.candidates;
  if (!candidates.empty() && options.what != Picture::kError) {
    throw std::invalid_argument(
        fmt::format("--candidate {}: only --what error shows an implementation; the others show "
                    "the exact answer",
                    candidates.front()));
  }
  if (candidates.size() > 1) {
    throw std::invalid_argument("--candidate: a picture shows one; give it once");
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
            "class: hit or miss; sphere: the nearest one, shaded; depth: s, near is bright; error: "
            "how far a method's s is off, see below");
  command.add_option("--rays", arguments.rays,
                     "of error: the method that makes rays (default: direct)");
  command.add_option("--intersect", arguments.intersect,
                     "of error: the method that intersects them (default: cross)");
  command.add_option("--size", arguments.size,
                     "pixels across and down, W,H (default: the scene's)");
  add_strict(command, arguments.strict);
  command.add_option("--threads", arguments.threads, "how many; the picture is the same")
      ->check(whole_number(1, 1024))
      ->capture_default_str();
  add_dialect(command, arguments.dialect);
  add_external(command, arguments.external);
  command.get_option("--candidate")->excludes(command.get_option("--intersect"));
  add_format(command, arguments.format, kImageViews);
  command.footer(legend());
  return [given] { return run_image(*given); };
}

}  // namespace raycheck::tools
