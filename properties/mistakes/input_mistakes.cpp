// Right answers to another question: another camera, other conventions or another pixel than given.

#include <utility>

#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {
namespace {

using scene::Camera;
using scene::Conventions;
using scene::Origin;
using scene::Pixel;

/// What a candidate is asked about a camera's pixels.
struct Input {
  Camera camera;
  Conventions conventions;
  std::vector<Pixel> pixels;
};

/// Every question changed before it is answered. One about given rays has conventions only.
Candidate with_question(const ChangeCamera& camera, const ChangeConventions& conventions,
                        const ChangePixel& pixel) {
  const Candidate right = right_candidate();
  Candidate candidate = right;
  const auto changed = [=](const Camera& its_camera, const Conventions& its_conventions,
                           Candidate::Pixels its_pixels) {
    Input input = {its_camera, its_conventions, {its_pixels.begin(), its_pixels.end()}};
    if (camera) camera(input.camera, its_conventions);
    if (conventions) conventions(input.conventions);
    if (pixel) {
      for (Pixel& one : input.pixels) one = pixel(its_camera, one);
    }
    return input;
  };
  candidate.frame = [right, changed](const Camera& its_camera) {
    return right.frame(changed(its_camera, {}, {}).camera);
  };
  candidate.pixel_points = [right, changed](const Camera& its_camera,
                                            const Conventions& its_conventions,
                                            Candidate::Pixels its_pixels) {
    const Input input = changed(its_camera, its_conventions, its_pixels);
    return right.pixel_points(input.camera, input.conventions, input.pixels);
  };
  const auto rays_from = [&](Origin origin) {
    return [right, changed, origin](const Camera& its_camera, Conventions its_conventions,
                                    Candidate::Pixels its_pixels) {
      its_conventions.origin = origin;
      const Input input = changed(its_camera, its_conventions, its_pixels);
      const auto& rays =
          input.conventions.origin == Origin::kPixel ? right.pixel_rays : right.focal_rays;
      return rays(input.camera, input.conventions, input.pixels);
    };
  };
  candidate.pixel_rays = rays_from(Origin::kPixel);
  candidate.focal_rays = rays_from(Origin::kFocal);
  if (!conventions) return candidate;
  candidate.intersect = [right, conventions](Candidate::Rays rays, Candidate::Spheres spheres,
                                             Conventions asked) {
    conventions(asked);
    return right.intersect(rays, spheres, asked);
  };
  candidate.nearest = [right, conventions](Candidate::Rays rays, Candidate::Spheres spheres,
                                           Conventions asked) {
    conventions(asked);
    return right.nearest(rays, spheres, asked);
  };
  return candidate;
}

Mistake camera(std::string sentence, const ChangeCamera& change, Step step = Step::kPixelPoint) {
  return {std::move(sentence), step, change, {}, {}, with_question(change, {}, {})};
}

Mistake convention(std::string sentence, const ChangeConventions& change, Step step) {
  return {std::move(sentence), step, {}, change, {}, with_question({}, change, {})};
}

Mistake pixel(std::string sentence, const ChangePixel& change) {
  return {std::move(sentence), Step::kPixelPoint, {}, {}, change, with_question({}, {}, change)};
}

std::vector<Mistake> pixel_mistakes() {
  const auto up = [](const Camera& its, const Pixel& p) {
    return Pixel{p.i, its.height - 1 - p.j};
  };
  const auto across = [](const Camera& its, const Pixel& p) {
    return Pixel{its.width - 1 - p.i, p.j};
  };
  return {pixel("rows are upside down", up), pixel("columns are mirrored", across),
          pixel("the image is turned by half a turn",
                [=](const Camera& its, const Pixel& p) { return across(its, up(its, p)); }),
          pixel("rows and columns are exchanged", [](const Camera&, const Pixel& p) {
            return Pixel{p.j, p.i};
          })};
}

std::vector<Mistake> convention_mistakes() {
  using scene::Root;
  using scene::Samples;
  using scene::Tangent;
  const auto of = [](auto member, auto value) {
    return [member, value](Conventions& conventions) { conventions.*member = value; };
  };
  return {convention("pixels are sampled at their centres",
                     of(&Conventions::samples, Samples::kCentres), Step::kPixelPoint),
          convention("pixels are sampled from edge to edge",
                     of(&Conventions::samples, Samples::kEdges), Step::kPixelPoint),
          convention("rays start at the eye, so that spheres before the image plane are seen",
                     of(&Conventions::origin, Origin::kFocal), Step::kRay),
          convention("rays start on the image plane, so that spheres before it are not seen",
                     of(&Conventions::origin, Origin::kPixel), Step::kRay),
          convention("only the near root counts, so that spheres around the origin are not seen",
                     of(&Conventions::root, Root::kSmaller), Step::kIntersect),
          convention("the far root counts too, so that spheres around the origin are seen",
                     of(&Conventions::root, Root::kNearest), Step::kIntersect),
          convention(
              "a tangent counts as a miss",
              [](Conventions& asked) {
                if (asked.tangent == Tangent::kHit) asked.tangent = Tangent::kMiss;
              },
              Step::kIntersect),
          convention(
              "a tangent counts as a hit",
              [](Conventions& asked) {
                if (asked.tangent == Tangent::kMiss) asked.tangent = Tangent::kHit;
              },
              Step::kIntersect)};
}

/// Steps from the first pixel of a row or column to its last under the samples convention.
double steps(std::int64_t pixels, const Conventions& conventions) {
  return static_cast<double>(conventions.samples == scene::Samples::kEdges ? pixels - 1 : pixels);
}

/// The bounds where i = 0 and j = 0 keep their places.
void stretch_columns(Camera& camera, double factor) {
  camera.right = camera.left + (camera.right - camera.left) * factor;
}
void stretch_rows(Camera& camera, const Conventions& conventions, double factor) {
  const bool bottom_first = conventions.rows == scene::Rows::kBottomFirst;
  const double first = bottom_first ? camera.bottom : camera.top;
  double& last = bottom_first ? camera.top : camera.bottom;
  last = first + (last - first) * factor;
}

/// alpha(i) = left + i/w (right - left), from i/(w-1) or from (i+1/2)/w.
void columns_by_width(Camera& camera, const Conventions& conventions) {
  const auto width = static_cast<double>(camera.width);
  if (conventions.samples == scene::Samples::kEdges) {
    stretch_columns(camera, (width - 1) / width);
  } else {
    const double half = (camera.right - camera.left) / (2 * width);
    camera.left -= half;
    camera.right -= half;
  }
}
void rows_by_height(Camera& camera, const Conventions& conventions) {
  const auto height = static_cast<double>(camera.height);
  if (conventions.samples == scene::Samples::kEdges) {
    stretch_rows(camera, conventions, (height - 1) / height);
  } else {
    const bool bottom_first = conventions.rows == scene::Rows::kBottomFirst;
    const double half = (camera.top - camera.bottom) / (2 * height) * (bottom_first ? 1 : -1);
    camera.bottom -= half;
    camera.top -= half;
  }
}

std::vector<Mistake> bound_mistakes() {
  return {
      camera("top is -bottom", [](Camera& its, auto&) { its.top = -its.bottom; }),
      camera("bottom is -top", [](Camera& its, auto&) { its.bottom = -its.top; }),
      camera("right is -left", [](Camera& its, auto&) { its.right = -its.left; }),
      camera("left is -right", [](Camera& its, auto&) { its.left = -its.right; }),
      camera("top is taken from right", [](Camera& its, auto&) { its.top = its.right; }),
      camera("the bounds of rows are those of columns",
             [](Camera& its, auto&) {
               its.bottom = its.left;
               its.top = its.right;
             }),
      camera("the height is corrected for an aspect ratio that the bounds hold already",
             [](Camera& its, auto&) {
               its.top = its.bottom + (its.top - its.bottom) * static_cast<double>(its.width) /
                                          static_cast<double>(its.height);
             }),
  };
}

std::vector<Mistake> step_mistakes() {
  const auto columns_by_rows = [](Camera& its, const Conventions&, double across, double down) {
    if (across >= 1 && down >= 1) stretch_columns(its, across / down);
  };
  const auto rows_by_columns = [](Camera& its, const Conventions& c, double across, double down) {
    if (across >= 1 && down >= 1) stretch_rows(its, c, down / across);
  };
  const auto with_steps = [](auto change) {
    return [change](Camera& its, const Conventions& c) {
      change(its, c, steps(its.width, c), steps(its.height, c));
    };
  };
  return {
      camera("width and height are exchanged",
             with_steps([=](Camera& its, const Conventions& c, double across, double down) {
               columns_by_rows(its, c, across, down);
               rows_by_columns(its, c, across, down);
             })),
      camera("columns are divided by the height", with_steps(columns_by_rows)),
      camera("rows are divided by the width", with_steps(rows_by_columns)),
      camera("alpha = left + i/w (right - left)", columns_by_width),
      camera("beta = bottom + j/h (top - bottom)", rows_by_height),
      camera("i/w and j/h place the pixels",
             [](Camera& its, const Conventions& c) {
               columns_by_width(its, c);
               rows_by_height(its, c);
             }),
  };
}

std::vector<Mistake> view_mistakes() {
  return {
      camera("W has the wrong sign, the image plane is behind the eye",
             [](Camera& its, auto&) { its.near = -its.near; }),
      camera(
          "up is taken for (0, 1, 0)",
          [](Camera& its, auto&) {
            its.up = {0, 1, 0};
          },
          Step::kFrame),
      camera(
          "look-at is taken for the direction of view",
          [](Camera& its, auto&) {
            its.look_at = {its.eye.x + its.look_at.x, its.eye.y + its.look_at.y,
                           its.eye.z + its.look_at.z};
          },
          Step::kFrame),
  };
}

}  // namespace

std::vector<Mistake> input_mistakes() {
  std::vector<Mistake> all = pixel_mistakes();
  for (auto& more : {convention_mistakes(), view_mistakes(), bound_mistakes(), step_mistakes()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace raycheck::properties
