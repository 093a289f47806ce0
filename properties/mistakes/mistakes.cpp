#include "properties/mistakes/mistakes.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "fast/pixel_ray.h"
#include "properties/candidates/fast_candidate.h"
#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {
namespace {

using scene::Origin;

/// Calls tell(P, g) for each pixel, g = nW + alpha U + beta V.
template <class Tell>
void walk(const CameraFormulas& formulas, const Camera& camera, const Conventions& conventions,
          Candidate::Pixels pixels, const Tell& tell) {
  const auto [U, V, W] = formulas.frame(camera);
  const double n = camera.near;
  for (const Pixel& pixel : pixels) {
    const auto [alpha, beta] = fast::plane_position(camera, conventions, pixel);
    const Vector3 g = {n * W.x + alpha * U.x + beta * V.x, n * W.y + alpha * U.y + beta * V.y,
                       n * W.z + alpha * U.z + beta * V.z};
    tell(formulas.point(camera, g), g);
  }
}

/// Makes the candidate use these formulas for its rays.
void use(CameraFormulas formulas, Candidate& candidate) {
  if (!formulas.frame) formulas.frame = candidate.frame;
  if (!formulas.point) {
    formulas.point = [](const Camera& camera, const Vector3& g) {
      return Point3{camera.eye.x + g.x, camera.eye.y + g.y, camera.eye.z + g.z};
    };
  }
  if (!formulas.direction) {
    formulas.direction = [](const Camera&, const Point3&, const Vector3& g) {
      return normalised(g);
    };
  }
  candidate.frame = formulas.frame;
  candidate.pixel_points = [formulas](const Camera& camera, const Conventions& conventions,
                                      Candidate::Pixels pixels) {
    std::vector<Point3> points;
    walk(formulas, camera, conventions, pixels,
         [&](const Point3& P, const Vector3&) { points.push_back(P); });
    return points;
  };
  const auto rays_from = [&formulas](bool at_eye) {
    return [formulas, at_eye](const Camera& camera, const Conventions& conventions,
                              Candidate::Pixels pixels) {
      std::vector<Ray> rays;
      walk(formulas, camera, conventions, pixels, [&](const Point3& P, const Vector3& g) {
        rays.push_back({at_eye ? camera.eye : P, formulas.direction(camera, P, g)});
      });
      return rays;
    };
  };
  candidate.pixel_rays = rays_from(formulas.starts_at_eye);
  candidate.focal_rays = rays_from(true);
}

/// The arguments of a question about a camera's pixels, as code with the mistake reads them.
struct Input {
  Input(const Mistake& mistake, const Camera& given, const Conventions& under, Candidate::Pixels of)
      : scene(mistaken(mistake, {given, {}, {}, under})), pixels(of.begin(), of.end()) {
    if (!mistake.pixel) return;
    for (Pixel& one : pixels) one = mistake.pixel(given, under, one);
  }

  Scene scene;
  std::vector<Pixel> pixels;
};

/// Makes the candidate use the mistake's camera, conventions and pixels. The functions share what
/// they are made of: pairs of mistakes are made by the thousand.
void change_camera(const Mistake& mistake, Candidate& candidate) {
  const auto right = std::make_shared<const Candidate>(candidate);
  candidate.frame = [right, &mistake](const Camera& camera) {
    return right->frame(*Input(mistake, camera, {}, {}).scene.camera);
  };
  candidate.pixel_points = [right, &mistake](const Camera& camera, const Conventions& conventions,
                                             Candidate::Pixels pixels) {
    const Input input(mistake, camera, conventions, pixels);
    return right->pixel_points(*input.scene.camera, input.scene.conventions, input.pixels);
  };
  const auto rays_from = [&](Origin origin) {
    return [right, &mistake, origin](const Camera& camera, Conventions conventions,
                                     Candidate::Pixels pixels) {
      conventions.origin = origin;
      const Input input(mistake, camera, conventions, pixels);
      const Scene& taken = input.scene;
      return right->rays_from(taken.conventions.origin)(*taken.camera, taken.conventions,
                                                        input.pixels);
    };
  };
  candidate.pixel_rays = rays_from(Origin::kPixel);
  candidate.focal_rays = rays_from(Origin::kFocal);
}

/// Makes the candidate use the mistake's spheres and conventions.
void change_spheres(const Mistake& mistake, Candidate& candidate) {
  const auto taking = [&mistake](const auto& answer) {
    return [&mistake, answer](Candidate::Rays rays, Candidate::Spheres given,
                              const Conventions& conventions) {
      const Scene taken = mistaken(mistake, {{}, {}, {given.begin(), given.end()}, conventions});
      return answer(rays, taken.spheres, taken.conventions);
    };
  };
  candidate.intersect = taking(candidate.intersect);
  candidate.nearest = taking(candidate.nearest);
}

void change_hits(const ChangeHit& change, Candidate& candidate) {
  answer_by(candidate,
            [ask = hits_of(candidate), change](Candidate::Rays rays, const Sphere& sphere,
                                               const Conventions& conventions) {
              std::vector<Hit> hits = ask(rays, sphere, conventions);
              for (std::size_t k = 0; k < hits.size(); ++k) {
                if (hits[k]) hits[k] = change(rays[k], sphere, *hits[k]);
              }
              return hits;
            });
}

/// Makes the candidate use the hit formulas of all mistakes. A formula with a rank does not change
/// hits.
void use_hits(std::span<const Mistake* const> mistakes, Candidate& candidate) {
  HitFormulas hits, nearest;
  for (const Mistake* one : mistakes) {
    if (!one->hits.rank) hits = joined(std::move(hits), one->hits).value();
    nearest = joined(std::move(nearest), one->hits).value();
  }
  if (hits) answer_by(candidate, hits_by(hits));
  if (nearest.rank) candidate.nearest = nearest_by(std::move(nearest));
}

}  // namespace

Candidate right_candidate() {
  Candidate candidate = fast_candidate(fast::kDirectRays, fast::kCross), by_ends;
  answer_by(by_ends, hits_by({}));
  const auto choose = [](auto usual, auto& other) {
    return [usual, other](Candidate::Rays rays, Candidate::Spheres spheres,
                          const Conventions& conventions) {
      return conventions.valid.is_usual() ? usual(rays, spheres, conventions)
                                          : other(rays, spheres, conventions);
    };
  };
  candidate.intersect = choose(candidate.intersect, by_ends.intersect);
  candidate.nearest = choose(candidate.nearest, by_ends.nearest);
  candidate.declared.valid.reset();
  return candidate;
}

std::vector<Candidate> other_right_candidates(const Candidate& candidate) {
  std::vector<Candidate> others;
  const double coarsest = std::max(candidate.unit_roundoff, kDoubleRoundoff);
  const auto add = [&](const fast::PixelRayMethod& rays, const fast::IntersectMethod& intersect) {
    Candidate other = fast_candidate(rays, intersect);
    if (other.unit_roundoff <= coarsest) others.push_back(std::move(other));
  };
  for (const auto* rays : fast::pixel_ray_methods()) {
    if (rays != &fast::kDirectRays) add(*rays, fast::kCross);
  }
  for (const auto* intersect : fast::intersect_methods()) {
    if (intersect != &fast::kCross) add(fast::kDirectRays, *intersect);
  }
  return others;
}

Vector3 normalised(const Vector3& v) {
  const double factor = 1 / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return {factor * v.x, factor * v.y, factor * v.z};
}

std::vector<const Mistake*> in_order(std::span<const Mistake* const> some) {
  std::vector<const Mistake*> ordered(some.begin(), some.end());
  std::sort(ordered.begin(), ordered.end(), std::less<>());
  return ordered;
}

Candidate candidate_with(std::span<const Mistake* const> mistakes) {
  static const Candidate kRight = right_candidate();
  Candidate candidate = kRight;
  use_hits(mistakes, candidate);
  for (const Mistake* one : mistakes) {
    if (one->makes_rays()) use(one->rays, candidate);
  }
  const std::vector<const Mistake*> ordered = in_order(mistakes);
  // The wrapper that is added last changes the input first.
  for (auto at = ordered.rbegin(); at != ordered.rend(); ++at) {
    const Mistake& one = **at;
    if (one.camera || one.conventions || one.pixel) change_camera(one, candidate);
    if (one.sphere || one.conventions) change_spheres(one, candidate);
    if (one.hit) change_hits(one.hit, candidate);
  }
  return candidate;
}

std::span<const Mistake> mistakes() {
  static const std::vector<Mistake> kMistakes = [] {
    std::vector<Mistake> all =
        all_of({input_mistakes(), number_mistakes(), step_mistakes(), camera_mistakes(),
                intersect_mistakes(), threshold_mistakes()});
    for (Mistake& mistake : all) {
      const Mistake* const one = &mistake;
      mistake.candidate = candidate_with({&one, 1});
    }
    return all;
  }();
  return kMistakes;
}

const Mistake* find_mistake(std::string_view sentence) {
  const auto all = mistakes();
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const Mistake& mistake) { return mistake.sentence == sentence; });
  return found == all.end() ? nullptr : &*found;
}

Scene mistaken(const Mistake& mistake, Scene scene) {
  const Conventions given = scene.conventions;
  if (mistake.camera && scene.camera) mistake.camera(*scene.camera, given);
  if (mistake.conventions) mistake.conventions(scene.conventions);
  if (mistake.sphere) {
    std::for_each(scene.spheres.begin(), scene.spheres.end(), mistake.sphere);
  }
  return scene;
}

}  // namespace raycheck::properties
