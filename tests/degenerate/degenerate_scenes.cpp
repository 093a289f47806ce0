// Degenerate answers about whole scenes: the sphere that is seen, the pixels in which a sphere may
// be, and whether a scene is valid.

#include "tests/degenerate/degenerate.h"

namespace raycheck::degenerate {
namespace {

using See = std::function<std::optional<std::size_t>(const Scene&, const Pixel&)>;

/// A candidate that shows the sphere of `see` in every pixel and every image.
Candidate seeing(const Candidate& right, std::string name, const See& see) {
  Candidate candidate = renamed(right, std::move(name));
  candidate.visible = [see](const Scene& scene, const Conventions&, Candidate::Pixels pixels) {
    std::vector<std::optional<SeenAnswer>> answers;
    for (const Pixel& pixel : pixels) {
      const auto sphere = see(scene, pixel);
      answers.push_back(sphere ? std::optional(SeenAnswer{*sphere, 1}) : std::nullopt);
    }
    return answers;
  };
  candidate.image = [see](const Scene& scene, const Conventions&) {
    ImageAnswer image;
    for (std::int64_t j = 0; j < scene.camera->height; ++j) {
      for (std::int64_t i = 0; i < scene.camera->width; ++i) image.push_back(see(scene, {i, j}));
    }
    return image;
  };
  return candidate;
}

std::vector<Degenerate> degenerate_sights(const Candidate& right) {
  return {
      {"nothing is ever seen",
       {"visible-sphere", "image"},
       seeing(right, "shows-nothing",
              [](const Scene&, const Pixel&) { return std::optional<std::size_t>(); })},
      {"every pixel shows the first sphere",
       {"visible-sphere", "image"},
       seeing(right, "shows-first", [](const Scene&, const Pixel&) { return std::size_t{0}; })},
      {"every pixel shows the last sphere",
       {"visible-sphere", "image"},
       seeing(right, "shows-last",
              [](const Scene& scene, const Pixel&) { return scene.spheres.size() - 1; })},
      {"every pixel shows a random sphere or none",
       {"visible-sphere", "image"},
       seeing(right, "shows-any",
              [](const Scene& scene, const Pixel& pixel) -> std::optional<std::size_t> {
                auto random =
                    random_of({scene.camera->eye.x, static_cast<double>(pixel.i),
                               static_cast<double>(pixel.j), scene.spheres.front().radius});
                const auto count = static_cast<std::int64_t>(scene.spheres.size());
                const std::int64_t sphere = random.integer(0, count);
                if (sphere == count) return {};
                return static_cast<std::size_t>(sphere);
              })},
      {"every pixel of an image shows an unknown sphere",
       {"image"},
       [&] {
         Candidate candidate = renamed(right, "image-of-some");
         candidate.image = [](const Scene& scene, const Conventions&) {
           const auto pixels = scene.camera->width * scene.camera->height;
           return ImageAnswer(static_cast<std::size_t>(pixels), properties::kSomeSphere);
         };
         return candidate;
       }()},
  };
}

/// A candidate whose plan is right except for the statement about every sphere.
Candidate planning(const Candidate& right, std::string name,
                   const std::function<void(const Scene&, SpherePlan&)>& say) {
  Candidate candidate = renamed(right, std::move(name));
  candidate.plan = [make = right.plan, say](const Scene& scene, const Conventions& conventions,
                                            scene::Wanted wanted) {
    scene::ScenePlan plan = make(scene, conventions, wanted);
    for (SpherePlan& sphere : plan.spheres) say(scene, sphere);
    return plan;
  };
  return candidate;
}

void keep(const Scene& scene, SpherePlan& sphere) {
  sphere.left_out.reset();
  sphere.hidden_by.reset();
  sphere.pixels = {0, scene.camera->width, 0, scene.camera->height};
  sphere.origin_inside = sphere.reaches_behind = true;
}

void drop(SpherePlan& sphere, scene::LeftOut why) {
  sphere.left_out = why;
  sphere.pixels = {};
}

std::vector<Degenerate> degenerate_plans(const Candidate& right) {
  return {
      {"a plan that keeps every sphere everywhere, which is right but saves nothing",
       {},
       planning(right, "plans-nothing", keep)},
      {"a plan that leaves out every sphere as outside the view",
       {"plan-left-out"},
       planning(
           right, "drops-all",
           [](const Scene&, SpherePlan& sphere) { drop(sphere, scene::LeftOut::kOutsideView); })},
      {"a plan in which every rectangle is the first pixel",
       {"plan-rectangles"},
       planning(right, "first-pixel-only",
                [](const Scene& scene, SpherePlan& sphere) {
                  keep(scene, sphere);
                  sphere.pixels = {0, 1, 0, 1};
                })},
      {"a plan in which no ray starts inside a sphere, and no sphere is behind one",
       {"plan-roots"},
       planning(right, "never-inside-or-behind",
                [](const Scene& scene, SpherePlan& sphere) {
                  keep(scene, sphere);
                  sphere.origin_inside = sphere.reaches_behind = false;
                })},
  };
}

/// Changes the functions about parts of a scene, or those about whole scenes.
template <class Change>
void change_parts(Candidate& candidate, const Change& change) {
  change(candidate.frame);
  change(candidate.pixel_points);
  change(candidate.pixel_rays);
  change(candidate.focal_rays);
  change(candidate.intersect);
  change(candidate.nearest);
}
template <class Change>
void change_wholes(Candidate& candidate, const Change& change) {
  change(candidate.plan);
  change(candidate.visible);
  change(candidate.image);
}

std::vector<Degenerate> degenerate_refusals(const Candidate& right) {
  const auto refuse = [](auto& function) {
    function = [](const auto&...) -> typename std::decay_t<decltype(function)>::result_type {
      throw std::invalid_argument("refused");
    };
  };
  // If the right function refuses, this one returns an empty answer.
  const auto answer = [](auto& function) {
    function = [ask = function](const auto&... asked) {
      try {
        return ask(asked...);
      } catch (const properties::CandidateRefused&) {
        return typename std::decay_t<decltype(function)>::result_type{};
      }
    };
  };
  std::vector<std::string_view> all_but_refusal = {
      "frame",          "pixel-point",     "bounds",         "image-plane",    "density",
      "square-pixels",  "pixel-zero-zero", "unit-direction", "direction",      "ray-origin",
      "class",          "nearest-root",    "parameter",      "backward-error", "hit-point",
      "nearest-sphere", "visible-sphere",  "image",          "plan-left-out",  "plan-rectangles",
      "plan-roots",     "focal-and-pixel"};
  Candidate refusing = renamed(right, "refuses-all");
  change_parts(refusing, refuse);
  change_wholes(refusing, refuse);
  Candidate answering = renamed(right, "refuses-nothing");
  change_parts(answering, answer);
  return {{"everything is refused", std::move(all_but_refusal), std::move(refusing)},
          {"nothing is refused", {"refusal"}, std::move(answering)}};
}

}  // namespace

std::vector<Degenerate> degenerate_scenes(const Candidate& right) {
  return joined(degenerate_sights(right), {degenerate_plans(right), degenerate_refusals(right)});
}

}  // namespace raycheck::degenerate
