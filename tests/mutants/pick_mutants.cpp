// Picks: the point of a sphere seen through a pixel, in one step.

#include "fast/intersect.h"
#include "properties/answers.h"
#include "properties/mistakes/altered_hits.h"
#include "tests/mutants/mutants.h"

namespace raycheck::mutants {
namespace {

/// What a mutant makes of the right answer about a pixel's ray and a sphere.
struct Picked {
  const Camera& camera;
  const Pixel& pixel;
  const Ray& ray;
  const Sphere& sphere;
};
using Change = std::function<void(const Picked&, Hit&)>;

/// Only picks: with the rays and intersections of direct/cross, for the pixels that `read` makes of
/// those that are asked for.
Candidate picking(std::string name, const Change& change,
                  const std::function<Pixel(const Camera&, Pixel)>& read = {}) {
  const Candidate right = unmutated();
  Candidate candidate = named(std::move(name));
  static_cast<Functions&>(candidate) = {};
  candidate.is_in_random_cases = true;  // so that the middle pixel is asked
  candidate.pick = [right, change, read](const Camera& camera, const Conventions& by,
                                         Candidate::Pixels asked, Candidate::Spheres spheres) {
    std::vector<Pixel> pixels(asked.begin(), asked.end());
    for (Pixel& pixel : pixels) pixel = read ? read(camera, pixel) : pixel;
    const std::vector<Ray> rays = right.rays_from(by.origin)(camera, by, pixels);
    std::vector<SphereHits> all = right.intersect(rays, spheres, by);
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      const SphereHits hits = std::exchange(all[k], {});
      for (std::size_t ray = 0; ray < rays.size(); ++ray) {
        const HitAnswer* const found = find_hit(hits, ray);
        Hit hit = found != nullptr ? Hit(*found) : Hit();
        change({camera, pixels[ray], rays[ray], spheres[k]}, hit);
        if (hit) all[k].push_back({ray, *hit});
      }
    }
    return all;
  };
  return candidate;
}

Vector3 from_centre(const Sphere& sphere, const Point3& point) { return point - sphere.centre; }

/// The point at this vector from the centre, moved to the sphere.
Point3 on(const Sphere& sphere, const Vector3& v) {
  const double share = sphere.radius / std::hypot(v.x, v.y, v.z);
  const auto& [x, y, z] = sphere.centre;
  return {x + share * v.x, y + share * v.y, z + share * v.z};
}

void keep(const Picked& /*of*/, Hit& /*hit*/) {}

void take_far_root(const Picked& of, Hit& hit) {
  if (!hit) return;
  const fast::Roots roots = fast::kCross.roots(of.ray, of.sphere);
  hit = properties::hit_at(of.ray, roots.larger);
}

/// As trackballs do, which always give a point.
void clamp(const Picked& of, Hit& hit) {
  if (hit) return;
  const double s = std::max(0.0, fast::kCross.roots(of.ray, of.sphere).axial_distance);
  const HitAnswer closest = properties::hit_at(of.ray, s);
  hit = {s, on(of.sphere, from_centre(of.sphere, closest.point))};
}

void lose_middle(const Picked& of, Hit& hit) {
  if (2 * of.pixel.i == of.camera.width - 1 && 2 * of.pixel.j == of.camera.height - 1) hit.reset();
}

/// The middle pixel of an image of any size.
void lose_near_middle(const Picked& of, Hit& hit) {
  if (of.pixel.i == of.camera.width / 2 && of.pixel.j == of.camera.height / 2) hit.reset();
}

/// It stays on the sphere, but leaves the pixel's ray.
void slide(const Picked& of, Hit& hit) {
  if (!hit) return;
  const Vector3 v = from_centre(of.sphere, hit->point);
  hit->point = on(of.sphere, {v.x + 1e-9 * v.y, v.y - 1e-9 * v.x, v.z});
}

/// It stays on the pixel's ray, but leaves the sphere.
void approach(const Picked& of, Hit& hit) {
  if (hit) hit = properties::hit_at(of.ray, (1 - 1e-9) * hit->parameter);
}

}  // namespace

Candidate picking_candidate() { return picking("picking", keep); }

std::vector<Mutant> pick_mutants() {
  const auto flip = [](const Camera& camera, Pixel pixel) {
    return Pixel{pixel.i, camera.height - 1 - pixel.j};
  };
  return {
      {"picks in the row counted from the other side",
       {"class", "hit-point"},
       picking("pick-flipped", keep, flip)},
      {"picks the far side of the sphere", {"nearest-root"}, picking("pick-far", take_far_root)},
      {"picks the nearest point of a sphere that is missed",
       {"class"},
       picking("pick-clamped", clamp)},
      {"does not pick in the middle of an odd image",
       {"class"},
       picking("pick-middle", lose_middle)},
      {"does not pick in the middle", {"class"}, picking("pick-near-middle", lose_near_middle)},
      {"picks a point of the sphere beside the pixel's ray",
       {"hit-point"},
       picking("pick-slid", slide)},
      {"picks a point in front of the sphere",
       {"parameter", "hit-point"},
       picking("pick-before", approach)},
  };
}

}  // namespace raycheck::mutants
