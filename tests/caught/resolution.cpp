#include "tests/caught/resolution.h"

#include "properties/cases/random.h"
#include "properties/truth.h"
#include "tests/caught/places.h"

namespace raycheck::caught {
namespace {

template <class Triple>
Triple times(double factor, const Triple& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

template <class A, class B>
A sum(const A& a, const B& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// A unit vector at right angles to a vector that is not zero.
Vector3 across(const Vector3& v) {
  const Vector3 any = std::abs(v.x) < std::abs(v.y) ? Vector3{0, v.z, -v.y} : Vector3{-v.z, 0, v.x};
  return times(1 / std::hypot(any.x, any.y, any.z), any);
}

Candidate with_hits(const ExactParts& exact, const std::function<void(HitAnswer&)>& change) {
  Candidate candidate = exact.candidate;
  candidate.intersect = [ask = candidate.intersect, change](const auto&... asked) {
    std::vector<SphereHits> answers = ask(asked...);
    for (SphereHits& hits : answers) {
      for (auto& [ray, hit] : hits) change(hit);
    }
    return answers;
  };
  return candidate;
}

Candidate with_rays(const ExactParts& exact, const std::function<void(Ray&)>& change) {
  Candidate candidate = exact.candidate;
  for (auto* make : {&candidate.pixel_rays, &candidate.focal_rays}) {
    *make = [ask = *make, change](const auto&... asked) {
      std::vector<Ray> rays = ask(asked...);
      for (Ray& ray : rays) change(ray);
      return rays;
    };
  }
  return candidate;
}

Candidate with_points(const ExactParts& exact,
                      const std::function<Point3(const Camera&, const Point3&)>& change) {
  Candidate candidate = exact.candidate;
  candidate.pixel_points = [ask = candidate.pixel_points, change](const Camera& camera,
                                                                  const auto&... asked) {
    std::vector<Point3> points = ask(camera, asked...);
    for (Point3& point : points) point = change(camera, point);
    return points;
  };
  return candidate;
}

Candidate with_frame(const ExactParts& exact, const std::function<void(FrameAnswer&)>& change) {
  Candidate candidate = exact.candidate;
  candidate.frame = [ask = candidate.frame, change](const Camera& camera) {
    FrameAnswer frame = ask(camera);
    change(frame);
    return frame;
  };
  return candidate;
}

Candidate scaled_s(const ExactParts& exact, double size) {
  return with_hits(exact, [size](HitAnswer& hit) { hit.parameter *= 1 + size; });
}

Candidate shifted_Q(const ExactParts& exact, double size) {
  return with_hits(exact, [size](HitAnswer& hit) { hit.point = times(1 + size, hit.point); });
}

Candidate tilted_D(const ExactParts& exact, double size) {
  return with_rays(exact, [size](Ray& ray) {
    const Vector3 tilted = sum(ray.direction, times(size, across(ray.direction)));
    ray.direction = times(1 / std::sqrt(1 + size * size), tilted);
  });
}

Candidate longer_D(const ExactParts& exact, double size) {
  return with_rays(exact, [size](Ray& ray) { ray.direction = times(1 + size, ray.direction); });
}

Candidate shifted_L(const ExactParts& exact, double size) {
  return with_rays(exact, [size](Ray& ray) { ray.origin = times(1 + size, ray.origin); });
}

Candidate shifted_P(const ExactParts& exact, double size) {
  return with_points(exact, [size](const Camera&, const Point3& P) { return times(1 + size, P); });
}

/// The plane is turned about the axis through the eye along `up`.
Candidate turned_P(const ExactParts& exact, double size) {
  return with_points(exact, [size](const Camera& camera, const Point3& P) {
    const Vector3 up = times(size / std::hypot(camera.up.x, camera.up.y, camera.up.z), camera.up);
    const Vector3 g = P - camera.eye;
    return sum(P,
               Vector3{up.y * g.z - up.z * g.y, up.z * g.x - up.x * g.z, up.x * g.y - up.y * g.x});
  });
}

Candidate turned_axes(const ExactParts& exact, double size) {
  return with_frame(exact, [size](FrameAnswer& frame) {
    const FrameAnswer right = frame;
    frame.U = sum(right.U, times(size, right.V));
    frame.V = sum(right.V, times(-size, right.U));
  });
}

Candidate skewed_axes(const ExactParts& exact, double size) {
  return with_frame(exact,
                    [size](FrameAnswer& frame) { frame.U = sum(frame.U, times(size, frame.W)); });
}

// Wrong decisions about hits, nearest spheres and pixels.

void rank(Sight& sight) {
  const auto is_hit = [&](std::size_t k) { return sight.spheres[k].hit.has_value(); };
  // Ties in doubles keep the exact order.
  if (sight.nearest && !is_hit(*sight.nearest)) sight.nearest.reset();
  for (std::size_t k = 0; k < sight.spheres.size(); ++k) {
    if (!is_hit(k)) continue;
    if (!sight.nearest ||
        sight.spheres[k].hit->parameter < sight.spheres[*sight.nearest].hit->parameter) {
      sight.nearest = k;
    }
  }
}

Candidate with_sights(const ExactParts& exact, const ChangeSight& change) {
  Candidate candidate = exact.candidate;
  answer_by_sights(candidate, exact.sights, exact.looked_at, change);
  return candidate;
}

/// Hit and miss are exchanged if |b - r| < size r, where b is the impact parameter.
Candidate flipped_band(const ExactParts& exact, double size) {
  return with_sights(exact, [size](Sight& sight) {
    for (Sighting& sphere : sight.spheres) {
      if (!(sphere.to_tangency < size)) continue;
      if (sphere.hit) {
        sphere.hit.reset();
      } else if (sphere.middle >= 0) {
        sphere.hit = HitAnswer{sphere.middle, {}};
      }
    }
    rank(sight);
  });
}

Candidate epsilon_in_s(const ExactParts& exact, double size) {
  return with_sights(exact, [size](Sight& sight) {
    for (Sighting& sphere : sight.spheres) {
      if (sphere.hit && sphere.hit->parameter < size) sphere.hit.reset();
    }
    rank(sight);
  });
}

/// If the s of spheres differ by less than size s, the farthest is taken for the nearest.
Candidate farther_sphere(const ExactParts& exact, double size) {
  return with_sights(exact, [size](Sight& sight) {
    if (!sight.nearest) return;
    const double least = sight.spheres[*sight.nearest].hit->parameter;
    double most = least;
    for (std::size_t k = 0; k < sight.spheres.size(); ++k) {
      const auto& hit = sight.spheres[k].hit;
      if (!hit || !(hit->parameter > most) || hit->parameter > least * (1 + size)) continue;
      most = hit->parameter;
      sight.nearest = k;
    }
  });
}

/// The candidates of one kind of error, the largest first.
std::vector<Candidate> injected(const ErrorKind& kind, const ExactParts& exact) {
  std::vector<Candidate> candidates;
  for (int k = 0; k <= kind.smallest; ++k) {
    candidates.push_back(kind.inject(exact, std::pow(double(kind.base), -k)));
  }
  return candidates;
}

/// One kind of error, and the smallest errors that its laws have noticed so far.
struct Ladder {
  std::vector<Candidate> candidates;
  std::vector<Resolution> resolutions;
};

/// Tries smaller and smaller errors as long as they are noticed.
void descend(const Law& law, const Case& the_case, const std::vector<Candidate>& candidates,
             properties::SharedTruths& truths, std::optional<int>& noticed) {
  for (std::size_t next = noticed ? std::size_t(*noticed) + 1 : 0; next < candidates.size();
       ++next) {
    Trial trial(the_case, candidates[next], {.truth = truths.under(the_case.scene.conventions)});
    if (apply(law, trial).holds()) return;
    noticed = static_cast<int>(next);
  }
}

}  // namespace

std::span<const ErrorKind> error_kinds() {
  static const std::vector<ErrorKind> kKinds = {
      {"s",
       "s times 1 + 2^-k",
       {"parameter", "backward-error", "nearest-root", "focal-and-pixel"},
       scaled_s},
      {"Q",
       "Q moved by 2^-k of its distance from the world's origin",
       {"hit-point", "focal-and-pixel"},
       shifted_Q},
      {"band",
       "hit and miss exchanged where |b - r| < 2^-k r, b the impact parameter",
       {"class", "growing-radius", "nearest-sphere", "visible-sphere", "image"},
       flipped_band},
      {"epsilon",
       "hits with s < 10^-k dropped",
       {"class", "scaling", "growing-radius", "nearest-sphere", "visible-sphere", "image"},
       epsilon_in_s,
       false,
       10,
       300},
      {"order",
       "the farther of two spheres whose s differ by less than 2^-k s",
       {"nearest-sphere", "visible-sphere", "image"},
       farther_sphere},
      {"D",
       "D turned by 2^-k",
       {"direction", "parameter", "hit-point", "class", "scaling", "axes"},
       tilted_D,
       true},
      {"length", "D times 1 + 2^-k", {"unit-direction", "direction", "parameter"}, longer_D, true},
      {"L",
       "the ray's origin moved by 2^-k of its distance from the world's",
       {"ray-origin", "parameter", "hit-point"},
       shifted_L,
       true},
      {"P",
       "pixel points moved by 2^-k of their distance from the world's origin",
       {"pixel-point", "bounds", "image-plane", "centre-pixel", "pixel-zero-zero", "square-pixels"},
       shifted_P},
      {"plane",
       "pixel points turned by 2^-k about `up` through the eye",
       {"pixel-point", "bounds", "image-plane", "centre-pixel", "pixel-zero-zero", "square-pixels"},
       turned_P},
      {"axes", "U and V turned by 2^-k about W", {"frame"}, turned_axes},
      {"skew", "U leaning by 2^-k towards W", {"frame"}, skewed_axes},
  };
  return kKinds;
}

std::vector<Resolution> resolutions(const CaseSource& source, int cases,
                                    std::span<const ErrorKind* const> kinds,
                                    std::span<const Law* const> laws) {
  ExactParts exact;
  static_cast<properties::Domain&>(exact.candidate) = kRoundedDomain;
  std::vector<Ladder> ladders;
  for (const ErrorKind* kind : kinds) {
    Ladder ladder{injected(*kind, exact), {}};
    for (const std::string_view name : kind->laws) {
      const Law* const law = properties::find_law(name);
      if (law == nullptr) throw std::invalid_argument("no law is called " + std::string(name));
      const bool is_wanted = laws.empty() || std::find(laws.begin(), laws.end(), law) != laws.end();
      const bool is_asked = suits(*law, source) && (source.has_camera || !kind->of_rays_made);
      if (is_wanted && is_asked) ladder.resolutions.push_back({kind, law});
    }
    if (!ladder.resolutions.empty()) ladders.push_back(std::move(ladder));
  }
  properties::Random seeds(1);
  const auto places = places_of(source, kFewSeverities);
  for (int k = 0; k < cases; ++k) {
    const auto& place = places[static_cast<std::size_t>(k) % places.size()];
    const int severity = place.severity.value_or(0);
    const Case the_case = place.make(seeds.bits());
    *exact.looked_at = the_case.pixels;
    properties::SharedTruths truths(the_case);
    for (Ladder& ladder : ladders) {
      for (Resolution& resolution : ladder.resolutions) {
        const auto at = resolution.by_severity.find(severity);
        std::optional<int> noticed;
        if (at != resolution.by_severity.end()) noticed = at->second;
        descend(*resolution.law, the_case, ladder.candidates, truths, noticed);
        if (noticed) resolution.by_severity[severity] = *noticed;
      }
    }
  }
  std::vector<Resolution> result;
  for (Ladder& ladder : ladders) {
    for (Resolution& resolution : ladder.resolutions) {
      for (const auto& [severity, noticed] : resolution.by_severity) {
        resolution.noticed = std::max(resolution.noticed.value_or(noticed), noticed);
      }
      result.push_back(std::move(resolution));
    }
  }
  return result;
}

}  // namespace raycheck::caught
