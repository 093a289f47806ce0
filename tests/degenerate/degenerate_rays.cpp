// Degenerate answers about cameras: axes, pixel points, rays.

#include "tests/degenerate/degenerate.h"
#include "tests/numbers.h"

namespace raycheck::degenerate {
namespace {

/// The answer to the previous question.
template <class Asked, class Answer>
class BeforeRays {
 public:
  const Answer& answer(const Asked& asked, Answer now) {
    if (!last_ || !(*asked_ == asked)) {
      before_ = last_ ? *std::exchange(last_, now) : *(last_ = now);
      asked_ = asked;
    }
    return *before_;
  }

 private:
  std::optional<Asked> asked_;
  std::optional<Answer> last_, before_;
};

Candidate with_frame(const Candidate& right, std::string name,
                     const std::function<FrameAnswer(const Camera&)>& frame) {
  Candidate candidate = renamed(right, std::move(name));
  candidate.frame = frame;
  return candidate;
}

UnitVector3 unit(const Vector3& v) { return {v.x, v.y, v.z}; }

std::vector<Degenerate> degenerate_frames(const Candidate& right) {
  const auto always = [&](std::string name, const FrameAnswer& frame) {
    return with_frame(right, std::move(name), [frame](const Camera&) { return frame; });
  };
  const auto before = std::make_shared<BeforeRays<Camera, FrameAnswer>>();
  return {
      {"the axes of the world are the camera's",
       {"frame"},
       always("world-axes", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})},
      {"the axes are zero", {"frame"}, always("zero-axes", {})},
      {"the axes are NaN",
       {"frame"},
       always("NaN-axes", {{kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}})},
      {"the axes of the previous camera",
       {"frame"},
       with_frame(right, "previous-axes",
                  [before, ask = right.frame](const Camera& camera) {
                    return before->answer(camera, ask(camera));
                  })},
      {"random axes, the same for the same camera",
       {"frame", "look-at", "up"},
       with_frame(right, "random-axes",
                  [](const Camera& c) {
                    auto random = random_of(
                        {c.eye.x, c.look_at.x, c.look_at.y, c.look_at.z, c.up.x, c.up.y, c.up.z});
                    FrameAnswer frame;
                    for (UnitVector3* axis : {&frame.U, &frame.V, &frame.W}) {
                      *axis = unit(random.direction());
                    }
                    return frame;
                  })},
  };
}

using MakePoint = std::function<Point3(const Camera&, const Pixel&)>;

Candidate with_points(const Candidate& right, std::string name, const MakePoint& make) {
  Candidate candidate = renamed(right, std::move(name));
  candidate.pixel_points = [make](const Camera& camera, const Conventions&,
                                  Candidate::Pixels pixels) {
    std::vector<Point3> points;
    for (const Pixel& pixel : pixels) points.push_back(make(camera, pixel));
    return points;
  };
  return candidate;
}

auto random_of_pixel(const Camera& camera, const Pixel& pixel) {
  return random_of({camera.eye.x, camera.left, camera.top, static_cast<double>(camera.width),
                    static_cast<double>(pixel.i), static_cast<double>(pixel.j)});
}

std::vector<Degenerate> degenerate_points(const Candidate& right) {
  return {
      {"every pixel is at the eye",
       {"pixel-point", "bounds", "image-plane", "pixel-zero-zero", "square-pixels"},
       with_points(right, "points-at-eye", [](const Camera& c, const Pixel&) { return c.eye; })},
      {"every pixel is where the camera looks",
       {"pixel-point", "bounds", "image-plane"},
       with_points(right, "points-at-look-at",
                   [](const Camera& c, const Pixel&) { return c.look_at; })},
      {"every pixel is at NaN",
       {"pixel-point", "bounds", "image-plane", "centre-pixel", "pixel-zero-zero", "density",
        "square-pixels"},
       with_points(right, "points-at-NaN",
                   [](const Camera&, const Pixel&) {
                     return Point3{kNaN, kNaN, kNaN};
                   })},
      {"random pixel points, the same for the same camera and pixel",
       {"pixel-point", "bounds", "image-plane", "centre-pixel", "pixel-zero-zero", "density",
        "square-pixels"},
       with_points(right, "random-points",
                   [](const Camera& camera, const Pixel& pixel) {
                     const Vector3 P = random_of_pixel(camera, pixel).in_cube(10);
                     return Point3{P.x, P.y, P.z};
                   })},
  };
}

using MakeRay = std::function<Ray(const Camera&, const Pixel&)>;

Candidate with_rays(const Candidate& right, std::string name, const MakeRay& make) {
  Candidate candidate = renamed(right, std::move(name));
  candidate.pixel_rays = candidate.focal_rays = [make](const Camera& camera, const Conventions&,
                                                       Candidate::Pixels pixels) {
    std::vector<Ray> rays;
    for (const Pixel& pixel : pixels) rays.push_back(make(camera, pixel));
    return rays;
  };
  return candidate;
}

Candidate with_previous_rays(const Candidate& right) {
  Candidate candidate = renamed(right, "previous-rays");
  using Rays = std::vector<Ray>;
  for (auto* make : {&candidate.pixel_rays, &candidate.focal_rays}) {
    *make = [ask = *make, before = std::make_shared<BeforeRays<Camera, Rays>>()](
                const Camera& camera, const Conventions& conventions, Candidate::Pixels pixels) {
      const Rays& old = before->answer(camera, ask(camera, conventions, pixels));
      Rays rays;
      for (std::size_t k = 0; k < pixels.size(); ++k) rays.push_back(old[k % old.size()]);
      return rays;
    };
  }
  return candidate;
}

std::vector<Degenerate> degenerate_ray_makers(const Candidate& right) {
  const auto always = [&](std::string name, const Ray& ray) {
    return with_rays(right, std::move(name), [ray](const Camera&, const Pixel&) { return ray; });
  };
  return {
      {"every pixel's ray starts at the world's origin, along x",
       {"direction", "ray-origin", "axes"},
       always("constant-rays", {{}, {1, 0, 0}})},
      {"every pixel's ray is the camera's view, from the eye to where it looks",
       {"direction", "unit-direction"},
       with_rays(right, "view-rays",
                 [](const Camera& c, const Pixel&) {
                   return Ray{c.eye, c.look_at - c.eye};
                 })},
      {"rays without a direction",
       {"direction", "unit-direction", "ray-origin"},
       always("zero-rays", {})},
      {"rays of NaN",
       {"direction", "unit-direction", "ray-origin"},
       always("NaN-rays", {{kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}})},
      {"the rays of the previous camera", {"direction", "ray-origin"}, with_previous_rays(right)},
      {"random unit rays, the same for the same camera and pixel",
       {"direction", "ray-origin", "axes", "scaling"},
       with_rays(right, "random-rays",
                 [](const Camera& camera, const Pixel& pixel) {
                   auto random = random_of_pixel(camera, pixel);
                   const Vector3 at = random.in_cube(10);
                   return Ray{{at.x, at.y, at.z}, random.direction()};
                 })},
  };
}

}  // namespace

std::vector<Degenerate> degenerate_rays(const Candidate& right) {
  return joined(degenerate_frames(right), {degenerate_points(right), degenerate_ray_makers(right)});
}

}  // namespace raycheck::degenerate
