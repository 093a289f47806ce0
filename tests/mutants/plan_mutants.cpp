
#include "fast/visible.h"
#include "tests/mutants/mutants.h"
#include "tests/properties/laws/certified_candidate.h"

namespace raycheck::mutants {
namespace {

using MakePlan = std::function<ScenePlan(const Scene&, const Conventions&, Wanted)>;

ScenePlan right_plan(const Scene& scene, const Conventions& conventions, Wanted wanted) {
  return scene::plan_scene(scene, conventions, wanted);
}

/// A candidate with this plan. `visible` uses it, too.
Candidate with_plan(std::string name, MakePlan make) {
  Candidate candidate = named(std::move(name));
  candidate.plan = make;
  candidate.visible = [make](const Scene& scene, const Conventions& conventions,
                             Candidate::Pixels pixels) {
    const ScenePlan plan = make(scene, conventions, Wanted::kNearest);
    std::vector<std::optional<SeenAnswer>> answers(pixels.size());
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      const auto& [i, j] = pixels[k];
      const auto seen =
          fast::see(scene, plan, fast::kDirectRays, fast::kCross, {i, i + 1, j, j + 1});
      if (seen[0]) answers[k] = {seen[0]->sphere, seen[0]->parameter};
    }
    return answers;
  };
  return candidate;
}

/// Changes the statements of a right plan about each sphere.
Candidate with_spheres(std::string name,
                       std::function<void(const ScenePlan&, SpherePlan&)> change) {
  return with_plan(std::move(name),
                   [change](const Scene& scene, const Conventions& conventions, Wanted wanted) {
                     ScenePlan plan = right_plan(scene, conventions, wanted);
                     for (SpherePlan& sphere : plan.spheres) {
                       if (!sphere.left_out) change(plan, sphere);
                     }
                     return plan;
                   });
}

/// A mutant that takes one statement from the plan of another scene, or of other conventions.
Candidate with_statement(std::string name, std::function<void(Scene&, Conventions&)> change,
                         std::function<void(const SpherePlan&, SpherePlan&)> take) {
  return with_plan(std::move(name), [change, take](const Scene& scene,
                                                   const Conventions& conventions, Wanted wanted) {
    Scene other = scene;
    Conventions under = conventions;
    change(other, under);
    ScenePlan plan = right_plan(scene, conventions, wanted);
    const ScenePlan from = right_plan(other, under, wanted);
    for (std::size_t k = 0; k < plan.spheres.size(); ++k) {
      if (!plan.spheres[k].left_out) take(from.spheres[k], plan.spheres[k]);
    }
    return plan;
  });
}

/// A mutant with the rectangles of another scene, or of other conventions.
Candidate with_inputs(std::string name, std::function<void(Scene&, Conventions&)> change) {
  return with_statement(std::move(name), std::move(change),
                        [](const SpherePlan& other, SpherePlan& s) { s.pixels = other.pixels; });
}

void leave_out(SpherePlan& sphere, LeftOut why) {
  sphere.left_out = why;
  sphere.pixels = {};
}

void from_the_eye(Scene&, Conventions& conventions) { conventions.origin = scene::Origin::kFocal; }

double middle(const Bounds& x) { return x.low + (x.high - x.low) / 2; }

/// Shrinks a rectangle to the disc through the centre: slopes (x -+ r)/z.
void shrink_to_disc(const ScenePlan& plan, SpherePlan& sphere) {
  const double n = middle(plan.eye.near());
  const double z = n < 0 ? -middle(sphere.seen.w) : middle(sphere.seen.w);
  const double r = middle(sphere.seen.radius);
  if (!(z > r)) return;
  const auto shrink = [&](double x, Bounds (scene::EyeSpace::*index)(const Bounds&) const,
                          std::int64_t& begin, std::int64_t& end) {
    const Bounds position = {std::abs(n) * ((x - r) / z), std::abs(n) * ((x + r) / z)};
    const Bounds range = (plan.eye.*index)(position);
    const auto least = static_cast<double>(begin), most = static_cast<double>(end);
    begin = static_cast<std::int64_t>(std::ceil(std::clamp(range.low, least, most)));
    end = static_cast<std::int64_t>(std::floor(std::clamp(range.high, least - 1, most - 1))) + 1;
  };
  shrink(middle(sphere.seen.u), &scene::EyeSpace::column, sphere.pixels.i_begin,
         sphere.pixels.i_end);
  shrink(middle(sphere.seen.v), &scene::EyeSpace::row, sphere.pixels.j_begin, sphere.pixels.j_end);
}

/// Whether the cone of one sphere is inside the cone of another, whichever sphere is nearer.
bool is_in_cone_of(const scene::EyeSphere& by, const scene::EyeSphere& sphere) {
  const double power = middle(sphere.power), power_by = middle(by.power);
  const double r = middle(sphere.radius), r_by = middle(by.radius);
  const double dot = middle(sphere.u) * middle(by.u) + middle(sphere.v) * middle(by.v) +
                     middle(sphere.w) * middle(by.w);
  return power > 0 && power_by > 0 &&
         r * std::sqrt(middle(by.distance_sq)) < r_by * std::sqrt(middle(sphere.distance_sq)) &&
         dot > 1.0001 * (std::sqrt(power * power_by) + r * r_by);
}

ScenePlan hidden_by_angle(const Scene& scene, const Conventions& conventions, Wanted wanted) {
  ScenePlan plan = right_plan(scene, conventions, wanted);
  if (wanted != Wanted::kNearest) return plan;
  for (SpherePlan& sphere : plan.spheres) {
    for (std::size_t by = 0; by < plan.spheres.size(); ++by) {
      const SpherePlan& other = plan.spheres[by];
      if (sphere.left_out || other.left_out || other.reaches_behind) continue;
      if (!is_in_cone_of(other.seen, sphere.seen)) continue;
      leave_out(sphere, LeftOut::kHidden);
      sphere.hidden_by = by;
    }
  }
  return plan;
}

/// A plan that leaves out all equal spheres except the last.
ScenePlan last_of_equals(const Scene& scene, const Conventions& conventions, Wanted wanted) {
  ScenePlan plan = right_plan(scene, conventions, wanted);
  for (std::size_t k = 0; k < plan.spheres.size(); ++k) {
    const auto by = plan.spheres[k].hidden_by;
    if (!by || plan.spheres[*by].left_out || !(scene.spheres[*by] == scene.spheres[k])) continue;
    std::swap(plan.spheres[k], plan.spheres[*by]);
    std::swap(plan.nearest_distance[k], plan.nearest_distance[*by]);
    plan.spheres[*by].hidden_by = k;
  }
  return plan;
}

std::vector<Mutant> rectangle_mutants() {
  return {
      {"rectangles are a column short on the left",
       {"plan-rectangles"},
       with_spheres("short-left", [](const ScenePlan&, SpherePlan& s) { ++s.pixels.i_begin; })},
      {"rectangles are a row short at their last row",
       {"plan-rectangles"},
       with_spheres("short-last-row", [](const ScenePlan&, SpherePlan& s) { --s.pixels.j_end; })},
      {"rectangles count rows from the bottom under every convention",
       {"plan-rectangles", "visible-sphere"},
       with_inputs("unflipped-rectangles",
                   [](Scene&, Conventions& asked) { asked.rows = scene::Rows::kBottomFirst; })},
      {"rectangles have samples on edges under every convention",
       {"plan-rectangles"},
       with_inputs("rectangles-of-edges",
                   [](Scene& scene, Conventions& asked) {
                     const bool has_edges = scene.camera->width > 1 && scene.camera->height > 1;
                     if (has_edges) asked.samples = scene::Samples::kEdges;
                   })},
      {"rectangles are sorted where the bounds are mirrored",
       {"plan-rectangles"},
       with_inputs("unmirrored-rectangles",
                   [](Scene& scene, Conventions&) {
                     scene::Camera& camera = *scene.camera;
                     if (camera.left > camera.right) std::swap(camera.left, camera.right);
                   })},
      {"rectangles hold the disc through the centre, not the silhouette",
       {"plan-rectangles"},
       with_spheres("disc-rectangles", shrink_to_disc)},
  };
}

std::vector<Mutant> left_out_mutants() {
  return {
      {"the test for spheres behind the origin subtracts the radius",
       {"plan-left-out", "visible-sphere"},
       with_spheres("reaching-behind-is-behind",
                    [](const ScenePlan&, SpherePlan& s) {
                      if (s.reaches_behind) leave_out(s, LeftOut::kBehind);
                    })},
      {"a sphere is outside the view where its centre is",
       {"plan-left-out", "visible-sphere"},
       with_statement(
           "centre-outside-view",
           [](Scene& scene, Conventions&) {
             for (scene::Sphere& sphere : scene.spheres) sphere.radius = 0;
           },
           [](const SpherePlan& centre, SpherePlan& s) {
             if (centre.left_out == LeftOut::kOutsideView) leave_out(s, LeftOut::kOutsideView);
           })},
      {"a sphere is hidden by any with a cone that contains its cone, nearer or not",
       {"plan-left-out", "visible-sphere"},
       with_plan("hidden-by-angle", hidden_by_angle)},
      {"the last of equal spheres is kept",
       {"plan-left-out"},
       with_plan("last-of-equals", last_of_equals)},
      {"hidden spheres are left out also where the nearest is not wanted",
       {"plan-left-out"},
       with_plan("hidden-from-all",
                 [](const Scene& scene, const Conventions& conventions, Wanted) {
                   return right_plan(scene, conventions, Wanted::kNearest);
                 })},
  };
}

std::vector<Mutant> root_mutants() {
  return {
      {"the far root is wanted only where the eye is inside",
       {"plan-roots"},
       with_statement(
           "inside-of-the-eye", from_the_eye,
           [](const SpherePlan& other, SpherePlan& s) { s.origin_inside = other.origin_inside; })},
      {"a sphere may be behind the origin only where it is behind the eye",
       {"plan-roots"},
       with_statement("behind-the-eye", from_the_eye,
                      [](const SpherePlan& other, SpherePlan& s) {
                        s.reaches_behind = other.reaches_behind;
                      })},
      {"the far root is never wanted",
       {"plan-roots"},
       with_spheres("no-far-root",
                    [](const ScenePlan&, SpherePlan& s) { s.origin_inside = false; })},
  };
}

Candidate seen_by_file_order() {
  Candidate candidate = named("shows-first-in-file");
  candidate.visible = [visible = candidate.visible](const Scene& scene,
                                                    const Conventions& conventions,
                                                    Candidate::Pixels pixels) {
    std::vector<std::optional<SeenAnswer>> answers(pixels.size());
    for (std::size_t sphere = scene.spheres.size(); sphere-- > 0;) {
      Scene single = scene;
      single.spheres = {scene.spheres[sphere]};
      const auto seen = visible(single, conventions, pixels);
      for (std::size_t k = 0; k < seen.size(); ++k) {
        if (seen[k]) answers[k] = {sphere, seen[k]->parameter};
      }
    }
    return answers;
  };
  return candidate;
}

/// A mutant that changes certified answers.
Candidate with_certified(std::string name,
                         std::function<void(const Scene&, std::optional<SeenAnswer>&)> change,
                         bool reversed = false) {
  Candidate candidate = properties::certified_candidate();
  candidate.name = std::move(name);
  candidate.visible = [visible = candidate.visible, change, reversed](
                          const Scene& scene, const Conventions& conventions,
                          Candidate::Pixels pixels) {
    Scene asked = scene;
    if (reversed) std::reverse(asked.spheres.begin(), asked.spheres.end());
    auto answers = visible(asked, conventions, pixels);
    for (auto& answer : answers) change(scene, answer);
    return answers;
  };
  return candidate;
}

/// A mutant that changes the image.
Candidate with_image(std::string name,
                     std::function<void(const Scene&, properties::ImageAnswer&)> change) {
  Candidate candidate = named(std::move(name));
  candidate.image = [image = candidate.image, change](const Scene& scene,
                                                      const Conventions& conventions) {
    properties::ImageAnswer answer = image(scene, conventions);
    change(scene, answer);
    return answer;
  };
  return candidate;
}

/// A mutant that draws depth pictures, whose numbers are made from the right s.
Candidate with_depths(std::string name, double (*number)(double s)) {
  Candidate candidate = named(std::move(name));
  candidate.depth = properties::Depth::kS;
  candidate.depths = [visible = candidate.visible, number](const Scene& scene,
                                                           const Conventions& conventions) {
    properties::DepthAnswer depths;
    for (const auto& seen : visible(scene, conventions, properties::all_pixels(*scene.camera))) {
      depths.push_back(seen ? static_cast<float>(number(seen->parameter)) : 0);
    }
    return depths;
  };
  return candidate;
}

std::vector<Mutant> image_mutants() {
  return {
      {"every depth is 1", {"image"}, with_depths("depth-constant", [](double) { return 1.0; })},
      {"depths are off by 2^-8 of themselves",
       {"image"},
       with_depths("depth-coarse", [](double s) { return s * (1 + 0x1p-8); })},
      {"rows of the image are upside down",
       {"image"},
       with_image("image-upside-down",
                  [](const Scene& scene, properties::ImageAnswer& image) {
                    const auto width = static_cast<std::ptrdiff_t>(scene.camera->width);
                    properties::ImageAnswer turned;
                    for (auto row = image.end(); row != image.begin(); row -= width) {
                      turned.insert(turned.end(), row - width, row);
                    }
                    image = turned;
                  })},
      {"every pixel shows an unknown sphere",
       {"image"},
       with_image("image-all-hits",
                  [](const Scene&, properties::ImageAnswer& image) {
                    std::fill(image.begin(), image.end(), properties::kSomeSphere);
                  })},
  };
}

std::vector<Mutant> visible_mutants() {
  return {
      {"the first sphere of the file is seen", {"visible-sphere"}, seen_by_file_order()},
      {"a certified s is off by 2^-19 of itself",
       {"visible-sphere"},
       with_certified("coarse-parameter",
                      [](const Scene&, std::optional<SeenAnswer>& answer) {
                        if (answer) answer->parameter *= 1 + 0x1p-19;
                      })},
      {"the last of equal spheres is certified",
       {"visible-sphere"},
       with_certified(
           "certified-last-of-equals",
           [](const Scene& scene, std::optional<SeenAnswer>& answer) {
             if (answer) answer->sphere = scene.spheres.size() - 1 - answer->sphere;
           },
           true)},
  };
}

}  // namespace

std::vector<Mutant> plan_mutants() {
  return joined({rectangle_mutants(), left_out_mutants(), root_mutants(), visible_mutants(),
                 image_mutants()});
}

}  // namespace raycheck::mutants
