#include "tests/caught/exact_candidate.h"

#include "properties/candidates/fast_candidate.h"
#include "reference/exact_camera.h"
#include "reference/exact_ray.h"
#include "scene/plan/plan.h"
#include "scene/validate.h"

namespace raycheck::caught {
namespace {

using namespace reference;

constexpr int kBits = 256;

/// `length` is the length of one unit of s.
Sighting sighting(const ExactRay& ray, const Sphere& sphere, const Conventions& conventions,
                  const reference::EnclosedRay& enclosed, const Enclosure& length) {
  Sighting result;
  const reference::Intersection at = ray.intersect(sphere, conventions);
  if (reference::counts_as_hit(at.hit_class, conventions.tangent)) {
    result.hit = {ray.rounded_parameter(sphere, at), ray.rounded_point(sphere, at)};
  }
  const Enclosure radius(sphere.radius, kBits);
  const Enclosure off = abs(enclosed.half_chord_sq(sphere)) / (radius * radius);
  result.to_tangency = off.upper() / 2;
  result.middle = (enclosed.axial_distance(sphere) / length).upper();
  return result;
}

Sight sight(const ExactRay& ray, const std::vector<Sphere>& spheres,
            const Conventions& conventions) {
  Sight result;
  const reference::EnclosedRay enclosed = ray.enclose(kBits);
  const Enclosure length = ray.source().camera ? Enclosure(1) : enclosed.length();
  for (const Sphere& sphere : spheres) {
    result.spheres.push_back(sighting(ray, sphere, conventions, enclosed, length));
  }
  if (const auto first = ray.nearest(spheres, conventions)) result.nearest = first->index;
  return result;
}

template <class T>
std::vector<T> list_of(std::span<const T> values) {
  return {values.begin(), values.end()};
}

/// Makes a candidate's function about the pixels of a camera.
template <class Answer, class Make>
auto of_pixels(Make make) {
  using Kept = Remembered<std::vector<Answer>, Camera, Conventions, std::vector<Pixel>>;
  return [make, kept = std::make_shared<Kept>()](
             const Camera& camera, const Conventions& conventions, Candidate::Pixels pixels) {
    return (*kept)(
        [&] {
          const ExactCamera exact(camera, conventions);
          std::vector<Answer> answers;
          for (const Pixel& pixel : pixels) answers.push_back(make(ExactRay(exact, pixel)));
          return answers;
        },
        camera, conventions, list_of(pixels));
  };
}

Ray rounded_ray(const ExactRay& ray) {
  const scene::UnitVector3 D = ray.rounded_direction();
  return {ray.rounded_origin(), {D.x, D.y, D.z}};
}

FrameAnswer rounded_frame(const Camera& camera) {
  // One row of pixels cannot be sampled at edges; the frame does not depend on that.
  Conventions conventions;
  conventions.samples = scene::Samples::kCentres;
  const reference::RoundedFrame frame = ExactCamera(camera, conventions).rounded_frame();
  return {frame.U, frame.V, frame.W};
}

}  // namespace

const std::vector<Sight>& Sights::of(const Rays& rays, const Spheres& spheres,
                                     const Conventions& conventions) {
  return of_rays_(
      [&] {
        std::vector<Sight> result;
        for (const Ray& ray : rays) result.push_back(sight(ExactRay(ray), spheres, conventions));
        return result;
      },
      rays, spheres, conventions);
}

const std::vector<Sight>& Sights::of(const Scene& scene, const Conventions& conventions,
                                     const Pixels& pixels) {
  return of_pixels_(
      [&] {
        const ExactCamera camera(scene.camera.value(), conventions);
        std::vector<Sight> result;
        for (const Pixel& pixel : pixels) {
          result.push_back(sight(ExactRay(camera, pixel), scene.spheres, conventions));
        }
        return result;
      },
      scene, conventions, pixels);
}

namespace {

/// The image of the spheres seen through some pixels, black elsewhere.
properties::ImageAnswer image_of(const Scene& scene, const Sights::Pixels& pixels,
                                 const std::vector<std::optional<properties::SeenAnswer>>& seen) {
  const Camera& camera = *scene.camera;
  properties::ImageAnswer image(static_cast<std::size_t>(camera.width * camera.height));
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (!seen[k]) continue;
    image[static_cast<std::size_t>(pixels[k].j * camera.width + pixels[k].i)] = seen[k]->sphere;
  }
  return image;
}

}  // namespace

void answer_by_sights(Candidate& candidate, const std::shared_ptr<Sights>& sights,
                      const std::shared_ptr<Sights::Pixels>& looked_at, const ChangeSight& change) {
  const auto of_rays = [sights, change](Candidate::Rays rays, Candidate::Spheres spheres,
                                        const Conventions& conventions) {
    std::vector<Sight> seen = sights->of(list_of(rays), list_of(spheres), conventions);
    for (Sight& sight : seen) change(sight);
    return seen;
  };
  candidate.intersect = [of_rays](Candidate::Rays rays, Candidate::Spheres spheres,
                                  const Conventions& conventions) {
    for (const Sphere& sphere : spheres) scene::require_valid(sphere);
    const std::vector<Sight> seen = of_rays(rays, spheres, conventions);
    std::vector<SphereHits> answers(spheres.size());
    for (std::size_t ray = 0; ray < seen.size(); ++ray) {
      for (std::size_t sphere = 0; sphere < spheres.size(); ++sphere) {
        if (const auto& hit = seen[ray].spheres[sphere].hit) answers[sphere].push_back({ray, *hit});
      }
    }
    return answers;
  };
  candidate.nearest = [of_rays](Candidate::Rays rays, Candidate::Spheres spheres,
                                const Conventions& conventions) {
    std::vector<std::optional<std::size_t>> answers;
    for (const Sight& sight : of_rays(rays, spheres, conventions)) answers.push_back(sight.nearest);
    return answers;
  };
  candidate.visible = [sights, change](const Scene& scene, const Conventions& conventions,
                                       Candidate::Pixels pixels) {
    std::vector<std::optional<properties::SeenAnswer>> answers;
    for (Sight sight : sights->of(scene, conventions, list_of(pixels))) {
      change(sight);
      answers.emplace_back();
      if (!sight.nearest) continue;
      answers.back() = {*sight.nearest, sight.spheres[*sight.nearest].hit->parameter};
    }
    return answers;
  };
  candidate.most_image_pixels = 1 << 14;
  candidate.image = [see = candidate.visible, looked_at](const Scene& scene,
                                                         const Conventions& conventions) {
    return image_of(scene, *looked_at, see(scene, conventions, *looked_at));
  };
}

Candidate exact_candidate(const std::shared_ptr<Sights>& sights,
                          const std::shared_ptr<Sights::Pixels>& looked_at) {
  Candidate candidate;
  candidate.name = "exact";
  const Candidate plain = properties::fast_candidate(fast::kDirectRays, fast::kCross);
  candidate.max_error = plain.max_error;
  candidate.max_error_end_to_end = plain.max_error_end_to_end;
  candidate.frame =
      [kept = std::make_shared<Remembered<FrameAnswer, Camera>>()](const Camera& camera) {
        return (*kept)([&] { return rounded_frame(camera); }, camera);
      };
  candidate.pixel_points =
      of_pixels<Point3>([](const ExactRay& ray) { return ray.rounded_pixel_point(); });
  const auto from = [](scene::Origin origin) {
    return [make = of_pixels<Ray>(rounded_ray), origin](
               const Camera& camera, Conventions conventions, Candidate::Pixels pixels) {
      conventions.origin = origin;
      return make(camera, conventions, pixels);
    };
  };
  candidate.pixel_rays = from(scene::Origin::kPixel);
  candidate.focal_rays = from(scene::Origin::kFocal);
  candidate.plan = [](const Scene& scene, const Conventions& conventions, scene::Wanted wanted) {
    return scene::plan_scene(scene, conventions, wanted);
  };
  answer_by_sights(candidate, sights, looked_at, [](Sight&) {});
  return candidate;
}

}  // namespace raycheck::caught
