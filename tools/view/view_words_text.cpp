#include <fmt/core.h>

#include "scene/number.h"
#include "tools/view/view_words.h"

namespace raycheck::tools {
namespace {

std::string listed(const auto& triple) {
  return fmt::format("{},{},{}", scene::shortest(triple.x), scene::shortest(triple.y),
                     scene::shortest(triple.z));
}

}  // namespace

std::string explain_command(const ExplainReport& report, const Selection& asked,
                            const fast::PixelRayMethod& rays, const std::string& file,
                            const std::string& more) {
  if (!report.pixel) {
    if (!report.sphere) return {};  // It explains no ray alone.
    const scene::Sphere& sphere = report.scene.spheres[*report.sphere];
    return fmt::format("raycheck explain --ray={},{} --sphere={},{}{}", listed(report.ray.origin),
                       listed(report.ray.direction), listed(sphere.centre),
                       scene::shortest(sphere.radius), more);
  }
  std::string command =
      fmt::format("raycheck explain {} --pixel {},{}", file, report.pixel->i, report.pixel->j);
  if (asked.sphere) command += fmt::format(" --sphere {}", *asked.sphere);
  if (&rays != kDefaultMethods.rays) command += fmt::format(" --rays {}", rays.name);
  return command + more;
}

std::string candidate_words(const std::string& candidate) {
  return " --candidate " + shell_word(candidate);
}

std::string smaller_pictures(const std::string& scene, const scene::Pixel& shown,
                             const scene::Pixel& all) {
  return fmt::format(
      "{}: the pictures have {} x {} pixels for {} x {}; `raycheck image` makes them "
      "whole",
      scene, shown.i, shown.j, all.i, all.j);
}

std::string fewer_pictures(const std::string& scene, const Kept& candidates) {
  return fmt::format(
      "{}: pictures of what {} of {} candidates answer; `raycheck image --what error` "
      "makes the others",
      scene, candidates.shown, candidates.all);
}

std::string fewer_spheres(const std::string& scene, const Kept& spheres) {
  return fmt::format("{}: the first {} of {} spheres are drawn", scene, spheres.shown, spheres.all);
}

std::string fewer_panels(const std::string& scene, const Kept& rays) {
  return fmt::format(
      "{}: steps are shown of {} of {} rays; `raycheck view --pixel I,J` asks for "
      "others",
      scene, rays.shown, rays.all);
}

std::string fewer_judged(const std::string& scene, const Kept& rays) {
  return fmt::format("{}: findings are of {} of {} rays; `raycheck check --view` judges them all",
                     scene, rays.shown, rays.all);
}

std::string fewer_laws(const Kept& laws) {
  return fmt::format(
      "cases of {} of {} broken laws; `raycheck properties --filter LAW --view` "
      "shows others",
      laws.shown, laws.all);
}

}  // namespace raycheck::tools
