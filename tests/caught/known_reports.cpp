#include "tests/caught/known_reports.h"

#include "fast/intersect.h"
#include "properties/candidates/fast_candidate.h"
#include "properties/mistakes/causes.h"
#include "properties/search/campaign.h"
#include "tests/mutants/mutants.h"

namespace raycheck::caught {
namespace {

using fast::Roots;

double dot(const Vector3& u, const Vector3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
double norm(const Vector3& v) { return std::hypot(v.x, v.y, v.z); }

Roots right_roots(const Ray& ray, const Sphere& sphere) { return fast::kCross.roots(ray, sphere); }

Hit right(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  return usual_choice(ray, right_roots(ray, sphere), conventions);
}

Hit inside_is_missed(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const Roots roots = right_roots(ray, sphere);
  return meets(roots, conventions) && roots.smaller >= 0 ? hit_at(ray, roots.smaller) : Hit();
}

Hit centre_is_ignored(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  return right(ray, {{}, sphere.radius}, conventions);
}

Hit point_at_a_radius(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  Hit hit = right(ray, sphere, conventions);
  if (hit) hit->point = hit_at(ray, sphere.radius).point;
  return hit;
}

/// s is the distance of two points in different coordinates: the ray's origin in the sphere's (its
/// centre at 0, its radius 1), and the hit point in the world's.
Hit measured_from_a_moved_origin(const Ray& ray, const Sphere& sphere,
                                 const Conventions& conventions) {
  Hit hit = right(ray, sphere, conventions);
  if (!hit) return hit;
  const Vector3 T = sphere.centre - ray.origin;
  const double r = sphere.radius;
  hit->parameter = norm({hit->point.x + T.x / r, hit->point.y + T.y / r, hit->point.z + T.z / r});
  return hit;
}

Hit unit_is_assumed(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const Vector3 T = sphere.centre - ray.origin;
  const double v = dot(T, ray.direction);
  const double half_chord_sq = sphere.radius * sphere.radius - (dot(T, T) - v * v);
  const double d = std::sqrt(half_chord_sq);
  return usual_choice(ray, {v, half_chord_sq, v - d, v + d}, conventions);
}

Hit length_along_the_direction(const Ray& ray, const Sphere& sphere,
                               const Conventions& conventions) {
  const Hit hit = right(ray, sphere, conventions);
  return hit ? hit_at(ray, hit->parameter * norm(ray.direction)) : hit;
}

Hit quadratic_in_floats(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const auto floats = [](const Vector3& v) {
    return std::array{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  };
  const auto product = [](const auto& u, const auto& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  };
  const auto T = floats(sphere.centre - ray.origin), D = floats(ray.direction);
  const auto r = static_cast<float>(sphere.radius);
  const float a = product(D, D), b = -2 * product(T, D), c = product(T, T) - r * r;
  const float discriminant = b * b - 4 * a * c;
  const float root = std::sqrt(discriminant);
  return usual_choice(
      ray, {-b, discriminant, double{(-b - root) / (2 * a)}, double{(-b + root) / (2 * a)}},
      conventions);
}

/// The roots v - d and v + d, added in floats, of right v and d.
Hit sums_in_floats(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  Roots roots = right_roots(ray, sphere);
  const auto v = static_cast<float>(roots.axial_distance);
  const float d = std::sqrt(static_cast<float>(roots.half_chord_sq));
  const auto length = static_cast<float>(norm(ray.direction));
  roots.smaller = double{(v - d) / length};
  roots.larger = double{(v + d) / length};
  return usual_choice(ray, roots, conventions);
}

Hit least_size(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const auto [v, half_chord_sq, smaller, larger] = right_roots(ray, sphere);
  if (!meets({v, half_chord_sq, smaller, larger}, conventions)) return {};
  return hit_at(ray, std::abs(smaller) < std::abs(larger) ? smaller : larger);
}

Hit tangents_are_missed(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const Roots roots = right_roots(ray, sphere);
  return roots.half_chord_sq > 0 ? usual_choice(ray, roots, conventions) : Hit();
}

/// The roots q/a and c/q with q = v + sign d.
Hit by_q(const Ray& ray, const Sphere& sphere, const Conventions& conventions, int sign) {
  const Roots roots = right_roots(ray, sphere);
  const double t = norm(sphere.centre - ray.origin), length = norm(ray.direction);
  const double q = roots.axial_distance + sign * std::sqrt(roots.half_chord_sq);
  double s = q / length, other = (t - sphere.radius) * (t + sphere.radius) / q / length;
  if (s > other) std::swap(s, other);
  return usual_choice(ray, {roots.axial_distance, roots.half_chord_sq, s, other}, conventions);
}

Hit sign_of_zero(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const double v = right_roots(ray, sphere).axial_distance;
  return by_q(ray, sphere, conventions, (v > 0 ? 1 : 0) - (v < 0 ? 1 : 0));
}

Hit divided_by_zero(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  return by_q(ray, sphere, conventions, right_roots(ray, sphere).axial_distance < 0 ? -1 : 1);
}

Hit far_hits_are_dropped(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const Hit hit = right(ray, sphere, conventions);
  return hit && hit->parameter * norm(ray.direction) > 1e7 ? Hit() : hit;
}

Hit near_spheres_are_dropped(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const bool is_near = norm(sphere.centre - ray.origin) < norm(ray.direction) + sphere.radius;
  return is_near ? Hit() : right(ray, sphere, conventions);
}

Hit half_of_b(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const Vector3 T = sphere.centre - ray.origin;
  const double a = dot(ray.direction, ray.direction), b = -dot(T, ray.direction);
  const double discriminant = b * b - 4 * a * (dot(T, T) - sphere.radius * sphere.radius);
  const double root = std::sqrt(discriminant);
  return usual_choice(ray, {-b, discriminant, (-b - root) / (2 * a), (-b + root) / (2 * a)},
                      conventions);
}

Hit epsilon(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const Roots roots = right_roots(ray, sphere);
  if (!meets(roots, conventions)) return {};
  if (roots.smaller > 0.001) return hit_at(ray, roots.smaller);
  const bool far_counts = conventions.root != scene::Root::kSmaller && roots.larger > 0.001;
  return far_counts ? hit_at(ray, roots.larger) : Hit();
}

/// From inside 0, and behind the ray the larger root, which is negative.
Hit solid_and_behind(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  if (norm(sphere.centre - ray.origin) <= sphere.radius) return hit_at(ray, 0);
  const Roots roots = right_roots(ray, sphere);
  if (!meets(roots, conventions)) return {};
  return hit_at(ray, roots.smaller >= 0 ? roots.smaller : roots.larger);
}

Hit near_roots_become_one(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  Roots roots = right_roots(ray, sphere);
  if (roots.half_chord_sq >= 0 && roots.half_chord_sq < 1e-5) {
    roots.smaller = roots.larger = roots.axial_distance / norm(ray.direction);
  }
  return usual_choice(ray, roots, conventions);
}

/// Where |c| is small, the origin counts as on the surface, from which only the far root is ahead.
Hit small_c_is_surface(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const double t = norm(sphere.centre - ray.origin);
  if (std::abs((t - sphere.radius) * (t + sphere.radius)) >= 1e-12) {
    return right(ray, sphere, conventions);
  }
  const Roots roots = right_roots(ray, sphere);
  return meets(roots, conventions) && roots.axial_distance > 0 &&
                 conventions.root != scene::Root::kSmaller
             ? hit_at(ray, roots.larger)
             : Hit();
}

/// From exactly the surface, the chord begins at 0 and ends in its middle.
Hit half_a_chord(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const Vector3 T = sphere.centre - ray.origin;
  const Hit hit = right(ray, sphere, conventions);
  if (!hit || hit->parameter == 0 || dot(T, T) != sphere.radius * sphere.radius) return hit;
  return hit_at(ray, dot(T, ray.direction) / dot(ray.direction, ray.direction));
}

/// r^2 in 32-bit integers, with the usual overflow; radii are those of whole units.
Hit square_overflows(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  constexpr double kLargest = 46340;  // its square is below 2^31
  if (sphere.radius <= kLargest || sphere.radius >= 0x1p31) return right(ray, sphere, conventions);
  const auto r = static_cast<std::uint32_t>(sphere.radius);
  const auto square = static_cast<std::int32_t>(r * r);
  const Vector3 T = sphere.centre - ray.origin;
  const double a = dot(ray.direction, ray.direction), b = dot(T, ray.direction);
  const double discriminant = b * b - a * (dot(T, T) - square), root = std::sqrt(discriminant);
  return usual_choice(ray, {b, discriminant, (b - root) / a, (b + root) / a}, conventions);
}

/// Every root ahead of the ray is a hit, also beyond the end of a segment.
Hit beyond_the_end(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  Conventions of_rays = conventions;
  of_rays.valid = {};
  return right(ray, sphere, of_rays);
}

Hit behind_counts(const Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  const Roots roots = right_roots(ray, sphere);
  return meets(roots, conventions) ? hit_at(ray, roots.smaller) : Hit();
}

}  // namespace

std::span<const KnownReport> known_reports() {
  static const std::vector<KnownReport> kReports = {

      {"turanszkij/WickedEngine#1695, erincatto/box2d#523",
       "a ray from inside misses: the far root is not returned, or not looked for",
       "inside-is-missed",
       inside_is_missed,
       {"right under root = smaller, which the candidate does not declare",
        "only the near root counts, so that spheres around the origin are not seen"}},
      {"g-truc/glm#8",
       "the centre is ignored: the sphere is taken to be about the origin",
       "centre-is-ignored",
       centre_is_ignored,
       {"the centre is left out: spheres are about the world's origin"}},
      {"g-truc/glm#8",
       "the position is a radius along the direction, not the distance",
       "point-at-a-radius",
       point_at_a_radius,
       {},
       "a mistake in Q that depends on the sphere: the listed ones depend only on the ray"},
      {"AmanSachan1/Meteoros#2",
       "the distance is measured from an origin that was moved into the sphere's space",
       "measured-from-a-moved-origin",
       measured_from_a_moved_origin,
       {},
       "the same in s"},
      {"rustgd/collision-rs#97, flutter/flutter#47830, davideberly/GeometricTools#20, "
       "MonoGame/MonoGame#7590, mrdoob/three.js#20697",
       "directions that are not unit are taken for unit ones",
       "unit-is-assumed",
       unit_is_assumed,
       {"directions are taken for unit vectors, whatever their length"}},
      {"Rajawali/Rajawali#2356",
       "the hit point is a distance times the unnormalised direction",
       "length-along-the-direction",
       length_along_the_direction,
       {"s is a length, but Q = L + s D with a D that is not a unit vector"}},
      {.thread = "ziotom78/pytracer#22, TzuChieh/Photon-v2#7",
       .said = "in floats, rays from far away miss small spheres",
       .mutant = "quadratic-in-floats",
       .hit = quadratic_in_floats,
       .needed = "a declared level: within 1,024 radii the textbook's formula loses as much in "
                 "floats, which is allowed for code that promises only ordinary cases",
       .is_found = false,
       .precision = scene::Precision::kSingle},
      {.thread = "ebruneton/precomputed_atmospheric_scattering#21",
       .said = "in floats, -b + sqrt(b^2 - c) cancels near a planet's surface",
       .mutant = "sums-in-floats",
       .hit = sums_in_floats,
       .needed = "nothing: so far from the planet's centre, rounding the camera's position to "
                 "floats loses as many digits, and, as the thread says, the stable formula does "
                 "not help",
       .is_found = false,
       .precision = scene::Precision::kSingle},
      {"OGRECave/ogre#141",
       "proposed: of the two roots the one with the smaller |s|",
       "least-size",
       least_size,
       {},
       "a separate mistake; pictures do not distinguish it from `s >= 0 is not tested`"},
      {.thread = "aardvark-platform/aardvark.base#127, RayTracing/raytracing.github.io#1058",
       .said = "exact tangents are missed",
       .mutant = "tangents-are-missed",
       .hit = tangents_are_missed,
       .needed = "an ordinary law about tangents that are exact in doubles, without excuses: "
                 "`--strict` breaks `class`",
       .is_found = false},
      {"arborx/ArborX#461",
       "sgn(b) is 0 where b is, and q = b + sgn(b) sqrt is wrong",
       "sign-of-zero",
       sign_of_zero,
       {},
       "few cases have b = 0: more of them, and this mistake in the list"},
      {.thread = "mmp/pbrt-v4#497",
       .said = "c/q is not a number where q is 0",
       .mutant = "divided-by-zero",
       .hit = divided_by_zero,
       .needed =
           "a verdict on exact tangents, where every answer is excused: `--strict` breaks `axes`",
       .is_found = false},
      {"POV-Ray/povray#469",
       "nothing is found beyond 10^7 units",
       "far-hits-are-dropped",
       far_hits_are_dropped,
       {"hits with an s above about 1e8 (the limit may be smaller) are dropped: the largest s that "
        "counts is too small",
        "hits with an s above about 1e9 (the limit may be smaller) are dropped: the largest s that "
        "counts is too small"}},
      {"RenderKit/embree#230",
       "spheres nearer than the direction's length plus the radius are missed",
       "near-spheres-are-dropped",
       near_spheres_are_dropped,
       {},
       "a threshold on the distance of the centre"},
      {"RayTracing/InOneWeekend#17, gamephysicsweekend/VulkanRenderer#4",
       "proposed: b^2 - 4ac, with a b that is only half of the textbook's",
       "half-of-b",
       half_of_b,
       {"b lacks its factor of 2: b^2 - 4ac with b = D . (L - C)"}},
      {"RayTracing/raytracing.github.io#1298",
       "with t_min = 0.001 the far root is taken for a nearer one",
       "epsilon",
       epsilon,
       {"where the near root is below about 0.001 (the limit may be larger) the far one is taken: "
        "the epsilon is too large"}},
      {"snowkit/old-haxe-alpha#267",
       "spheres behind the ray are hit",
       "behind-counts",
       behind_counts,
       {"s >= 0 is not tested: spheres behind the origin are hit"}},
      {.thread = "urho3d/urho3d, Ray::HitDistance in its source",
       .said = "0 from inside, and a negative distance for spheres behind",
       .mutant = "solid-and-behind",
       .hit = solid_and_behind,
       .sentences = {"spheres are solid: from inside s is 0; and v + d counts even if it is "
                     "negative"}},
      {.thread = "godotengine/godot, segment_intersects_sphere in its source",
       .said = "roots closer than about 1e-5 become one",
       .mutant = "near-roots-become-one",
       .hit = near_roots_become_one,
       .sentences = {"where d^2 is below about 1e-10 (the limit may be larger) v is taken for both "
                     "roots: the epsilon is too large",
                     "where d^2 is below about 1e-7 (the limit may be larger) v is taken for both "
                     "roots: the epsilon is too large"}},
      {.thread = "openmc-dev/openmc, SurfaceSphere::distance in its source",
       .said =
           "where |c| is below 1e-12 the origin counts as on the surface, also of small spheres",
       .mutant = "small-c-is-surface",
       .hit = small_c_is_surface,
       .sentences =
           {"where |c| is below about 1e-12 (the limit may be larger) the origin counts as "
            "on the sphere, and only the other root counts: the epsilon is too large"}},
      {.thread = "CesiumGS/cesium, IntersectionTests.rayEllipsoid in its source",
       .said = "from exactly the surface, the end is half of the chord",
       .mutant = "half-a-chord",
       .hit = half_a_chord,
       .sentences = {"from a point on the sphere s is half of the right one"},
       .valid = {.ends = scene::Ends::kOpenMin}},
      {.thread = "armory3d/armory#2574",
       .said = "r * r overflows in integers",
       .mutant = "square-overflows",
       .hit = square_overflows,
       .sentences = {"r^2 is an integer of 32 bits: it wraps around from a radius of 46,341 on"}},
      {.thread = "skyfielders/python-skyfield#831",
       .said = "a sphere beyond the end of the segment hides, too",
       .mutant = "beyond-the-end",
       .hit = beyond_the_end,
       .sentences = {"right under t_max = infinity, which the candidate does not declare"},
       .valid = {.t_max = 1}},
      {.thread = "raysect/source#391",
       .said = "all pixels are half a pixel off: sampled at their corners, not at their centres",
       .mutant = "always-corners",
       .sentences = {"right under samples = corners, which the candidate does not declare",
                     "i/w and j/h place the pixels"}},
      {.thread = "o3de/o3de#19600",
       .said = "the camera's position is added, and subtracted again",
       .mutant = "eye-added-and-subtracted",
       .needed =
           "a declared level: the digits that it loses grow with |E|/|P - E|, and up to 1,024 "
           "this is allowed for code that promises only ordinary cases",
       .is_found = false},
      {.thread = "nerfstudio-project/nerfstudio#2588",
       .said = "the near plane is a sphere around the eye",
       .mutant = "curved-plane",
       .sentences = {"P lies on a sphere around the eye: P = E + |near| D"}},
  };
  return kReports;
}

Candidate candidate_of(const KnownReport& report) {
  Candidate candidate;
  if (report.hit == nullptr) {
    const std::vector<mutants::Mutant> all = mutants::all_mutants();
    candidate = std::ranges::find_if(all, [&](const mutants::Mutant& one) {
                  return one.candidate.name == report.mutant;
                })->candidate;
    candidate.image = nullptr;  // whose pixels would be explained, not its rays
    candidate.refuses = false;
    candidate.level = properties::Level::kOrdinary;
    return candidate;
  }
  static_cast<properties::Promises&>(candidate) = mutants::unmutated();
  candidate.refuses = false;
  candidate.level = properties::Level::kOrdinary;
  candidate.name = report.mutant;
  if (!report.valid.is_usual()) candidate.declared.valid = report.valid;
  properties::answer_by(candidate, [hit = report.hit](Candidate::Rays rays, const Sphere& sphere,
                                                      const Conventions& conventions) {
    std::vector<Hit> hits;
    for (const Ray& ray : rays) hits.push_back(hit(ray, sphere, conventions));
    return hits;
  });
  candidate.nearest = nullptr;
  return properties::judged_in(report.precision, std::move(candidate));
}

FoundReport found(const Candidate& candidate) {
  FoundReport result;
  properties::CampaignOptions options;
  options.level = candidate.level;
  for (const properties::Law& law : properties::laws()) {
    const auto campaign = properties::run_campaign(law, candidate, options);
    if (campaign.finding() != properties::Finding::kBroken) continue;
    if (result.law.empty()) {
      result.law = law.name;
      for (const properties::CampaignPart& part : campaign.parts) {
        result.cases += part.counts.cases;
        if (!part.is_broken()) continue;
        result.source = part.source.source->name;
        if (part.source.severity) result.source += "@" + std::to_string(*part.source.severity);
        break;
      }
    }
    const auto cases = [&](std::size_t round) {
      return telling_cases(campaign, properties::kCasesOfACause, round);
    };
    for (const properties::Explanation& one : properties::causes(law, cases, candidate)) {
      const auto at = std::find(result.sentences.begin(), result.sentences.end(), one.sentence);
      if (at == result.sentences.end()) result.sentences.push_back(one.sentence);
    }
  }
  return result;
}

}  // namespace raycheck::caught
