#include "tools/view/scene_view.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "scene/validate.h"
#include "tools/image/image_paint.h"
#include "tools/report/packed.h"
#include "tools/report/words.h"
#include "tools/run/threads.h"
#include "tools/view/figure/figure.h"
#include "tools/view/panel/panel.h"

namespace raycheck::tools {
namespace {

/// The scene to show: in the format and under the conventions of an external implementation. If
/// that makes rays only from the eye, the origin is the eye, as in `explain`.
scene::Scene shown_scene(const scene::Scene& scene, const SceneViewOptions& options) {
  scene::require_valid(scene);
  scene::Scene shown = scene;
  if (options.other) {
    auto rounded = properties::rounded_scene(scene, options.other->input_format());
    if (!rounded.the_case) {
      throw std::invalid_argument(options.other->name + ": " + rounded.reason);
    }
    shown = std::move(rounded.the_case->scene);
  }
  if (!options.methods.empty() && options.methods.front().rays->pixel_rays == nullptr) {
    shown.conventions.origin = scene::Origin::kFocal;
  }
  if (options.other) {
    shown.conventions = options.other->make().declared.over(shown.conventions);
  }
  return shown;
}

/// The scene with an image of at most `most_pixels`.
scene::Scene smaller(scene::Scene scene, std::int64_t most_pixels) {
  scene::Camera& camera = *scene.camera;
  const double pixels = static_cast<double>(camera.width) * static_cast<double>(camera.height);
  if (pixels <= static_cast<double>(most_pixels)) return scene;
  const double factor = std::sqrt(static_cast<double>(most_pixels) / pixels);
  for (std::int64_t* side : {&camera.width, &camera.height}) {
    if (*side == 1) continue;
    const auto shorter = static_cast<std::int64_t>(static_cast<double>(*side) * factor);
    *side = std::clamp<std::int64_t>(shorter, 2, most_pixels / 2);
  }
  return scene;
}

std::vector<CandidateMaker> candidates_of(const SceneViewOptions& options) {
  std::vector<CandidateMaker> makers;
  for (const MethodPair& pair : options.methods) {
    makers.push_back([pair] { return candidate_of(pair); });
  }
  // If the implementation does not intersect, there is no picture.
  if (options.other && options.others_picture && options.other->make().intersect) {
    makers.push_back(answering_candidate(
        *options.other, options.methods.empty() ? kDefaultMethods : options.methods.front()));
  }
  if (options.renderer) makers.push_back(options.renderer);
  return makers;
}

void add_pictures(const scene::Scene& scene, const SceneViewOptions& options, SceneView& view,
                  std::vector<std::string>& left_out, const properties::RunControl& control) {
  const scene::Scene small = smaller(scene, options.limits.picture_pixels);
  const scene::Camera& camera = *small.camera;
  if (camera.width != scene.camera->width || camera.height != scene.camera->height) {
    left_out.push_back(fmt::format(
        "{}: pictures have {} x {} pixels, not {} x {}; `raycheck image` makes full ones",
        options.name, camera.width, camera.height, scene.camera->width, scene.camera->height));
  }
  const double pairs = static_cast<double>(camera.width) * static_cast<double>(camera.height) *
                       static_cast<double>(scene.spheres.size());
  std::vector<CandidateMaker> candidates = candidates_of(options);
  const auto most = static_cast<double>(options.limits.answered_pairs);
  const auto affordable = static_cast<std::size_t>(most / std::max(pairs, 1.0));
  if (candidates.size() > affordable) {
    left_out.push_back(fmt::format(
        "{}: pictures of {} of {} candidates; `raycheck image --what error` makes the others",
        options.name, affordable, candidates.size()));
    candidates.resize(affordable);
  }
  SceneImages images = images_of(small, candidates, control);
  view.pictures = std::move(images.pictures);
  if (camera == *scene.camera) view.seen = std::move(images.seen);
}

/// The selections for panels, which are made in this order while there is room: the wanted ones;
/// pixels spread over the image, more and more densely, or all given rays; the other spheres of the
/// start's ray.
std::vector<Selection> candidates_for_panels(const scene::Scene& scene,
                                             const SceneViewOptions& options) {
  std::vector<Selection> list = options.wanted;
  const auto add = [&](const Selection& selection) { list.push_back(selection); };
  if (scene.camera) {
    const scene::Camera& camera = *scene.camera;
    const scene::Pixel middle = {camera.width / 2, camera.height / 2};
    if (list.empty()) add({middle, {}, {}});
    const Selection start = list.front();
    const std::int64_t longest = std::max(camera.width, camera.height);
    std::int64_t stride = 1;
    while (longest / stride > 1) stride *= 2;
    std::int64_t before = 0;  // the stride of the pixels so far
    for (; stride >= 1 && list.size() < options.limits.panels; before = stride, stride /= 2) {
      for (std::int64_t j = 0; j < camera.height; j += stride) {
        for (std::int64_t i = 0; i < camera.width; i += stride) {
          if (before != 0 && i % before == 0 && j % before == 0) continue;
          if (list.size() < options.limits.panels) add({scene::Pixel{i, j}, {}, {}});
        }
      }
    }
    for (std::size_t k = 0; k < scene.spheres.size(); ++k) add({start.pixel, {}, k});
  } else {
    for (std::size_t ray = 0; ray < scene.rays.size(); ++ray) {
      for (std::size_t k = 0; k < std::max<std::size_t>(scene.spheres.size(), 1); ++k) {
        add({{}, ray, scene.spheres.empty() ? std::nullopt : std::optional(k)});
      }
    }
  }
  if (list.size() > options.limits.panels) list.resize(options.limits.panels);
  return list;
}

void add_panels(const scene::Scene& scene, const SceneViewOptions& options, SceneView& view,
                std::vector<std::string>& left_out, const properties::RunControl& control) {
  const DrawnFrame frame(scene);
  const std::vector<Selection> list = candidates_for_panels(scene, options);
  struct Made {
    Panel panel;
    std::string line;
  };
  std::size_t bytes = 0;
  std::string before;
  std::atomic<bool> is_full = false;
  properties::RunControl until_full = control;
  until_full.interrupted = [&] { return is_full || control.interrupted(); };
  in_order<Made>(
      static_cast<std::int64_t>(list.size()), until_full,
      [&](std::int64_t k) {
        Made made{panel_of(scene, frame, list[static_cast<std::size_t>(k)], options), {}};
        made.line = json_line(made.panel.json);
        return made;
      },
      [&](const Made& made) {
        const bool is_there = std::ranges::any_of(view.panels, [&](const Panel& other) {
          return other.selection == made.panel.selection;
        });
        if (is_full || is_there) return;
        bytes += packed(made.line, Packing::kSmall, before).size();
        before = made.line;
        if (bytes > options.limits.panel_bytes && !view.panels.empty()) {
          is_full = true;
          return;
        }
        view.panels.push_back(made.panel);
        control.progress(fmt::format("{} panels", view.panels.size()));
      });
  if (view.panels.empty()) return;
  view.start = view.panels.front().selection;
  const double rays = scene.camera ? static_cast<double>(scene.camera->width) *
                                         static_cast<double>(scene.camera->height)
                                   : static_cast<double>(scene.rays.size());
  if (is_full || static_cast<double>(view.panels.size()) < rays) {
    left_out.push_back(
        fmt::format("{}: steps of {} of {} rays are shown; `raycheck view --pixel I,J` shows "
                    "others",
                    options.name, view.panels.size(), static_cast<std::uint64_t>(rays)));
  }
}

}  // namespace

void show(const Implementation& implementation, SceneViewOptions& options) {
  if (implementation.methods) {
    options.methods.push_back(*implementation.methods);
    return;
  }
  options.more_arguments = " --candidate " + shell_word(implementation.name);
  if (implementation.draws()) {
    options.renderer = implementation.make;
  } else {
    options.other = std::make_shared<const Implementation>(implementation);
  }
}

SceneView view_of(const scene::Scene& scene, const SceneViewOptions& options,
                  std::vector<std::string>& left_out, const properties::RunControl& control) {
  SceneView view;
  view.name = options.name;
  view.command = fmt::format("raycheck view {}{}", options.file, options.more_arguments);
  view.scene = shown_scene(scene, options);
  if (scene.spheres.size() > options.limits.spheres) {
    left_out.push_back(fmt::format("{}: only the first {} of {} spheres are drawn", options.name,
                                   options.limits.spheres, scene.spheres.size()));
  }
  if (view.scene.camera) add_pictures(view.scene, options, view, left_out, control);
  view.figure = figure_json(view.scene, options.limits.spheres, view.seen);
  if (!control.interrupted()) add_panels(view.scene, options, view, left_out, control);
  return view;
}

Selection selection_of(const properties::Place& place, const scene::Scene& scene) {
  Selection selection;
  if (scene.camera) {
    selection.pixel = place.pixel;
  } else {
    selection.ray = place.ray;
  }
  selection.sphere = place.sphere;
  return selection;
}

bool is_of_ray(const Selection& selection) { return selection.pixel || selection.ray; }

std::vector<Selection> selections_of(const properties::Case& the_case,
                                     const properties::Place& found) {
  std::vector<Selection> list;
  const Selection first = selection_of(found, the_case.scene);
  if (is_of_ray(first)) list.push_back(first);
  for (const scene::Pixel& pixel : the_case.pixels) list.push_back({pixel, {}, first.sphere});
  return list;
}

}  // namespace raycheck::tools
