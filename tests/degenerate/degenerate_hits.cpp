// Degenerate answers about rays and spheres.

#include "properties/mistakes/altered_hits.h"
#include "reference/exact_ray.h"
#include "tests/degenerate/degenerate.h"
#include "tests/numbers.h"

namespace raycheck::degenerate {
namespace {

using reference::ExactRay;

using Answer = std::function<Hit(const Ray&, const Sphere&, const Conventions&)>;

/// A candidate that answers every ray separately; its nearest sphere is the one with the least s.
Candidate answering(Candidate candidate, std::string name, const Answer& answer) {
  candidate.name = std::move(name);
  properties::answer_by(candidate, [answer](Candidate::Rays rays, const Sphere& sphere,
                                            const Conventions& conventions) {
    std::vector<Hit> hits;
    for (const Ray& ray : rays) hits.push_back(answer(ray, sphere, conventions));
    return hits;
  });
  return candidate;
}

/// A candidate with right hit classes; `value` returns its answer for hits.
Candidate knowing_the_class(const Candidate& right, std::string name,
                            const std::function<HitAnswer(const Ray&)>& value) {
  return answering(right, std::move(name),
                   [value](const Ray& ray, const Sphere& sphere, const Conventions& asked) -> Hit {
                     const auto at = ExactRay(ray).intersect(sphere, asked.root);
                     if (!reference::counts_as_hit(at.hit_class, asked.tangent)) return {};
                     return value(ray);
                   });
}

/// One root of the line, whatever its sign.
Hit root_of_line(const Ray& ray, const Sphere& sphere, const Conventions& asked,
                 reference::WhichRoot root) {
  const ExactRay exact(ray);
  // Each root counts for one of the two rays along the line, unless the line misses.
  const Ray back = {ray.origin, {-ray.direction.x, -ray.direction.y, -ray.direction.z}};
  const auto ahead = exact.intersect(sphere);
  const auto behind = ExactRay(back).intersect(sphere);
  const auto at = ahead.hit_class == reference::HitClass::kMiss ? behind : ahead;
  if (!reference::counts_as_hit(at.hit_class, asked.tangent)) return {};
  return properties::hit_at(ray, exact.rounded_parameter(sphere, {at.hit_class, root}));
}

std::vector<Degenerate> degenerate_classes(const Candidate& right) {
  const auto always = [&](std::string name, HitAnswer hit) {
    return answering(right, std::move(name), [hit](const auto&...) { return hit; });
  };
  return {
      {"every ray misses",
       {"class", "nearest-sphere"},
       answering(right, "misses", [](const auto&...) { return Hit(); })},
      {"every ray hits where it starts, s = 0",
       {"class", "parameter", "hit-point", "backward-error", "nearest-sphere"},
       answering(right, "hits-at-0",
                 [](const Ray& ray, const auto&...) {
                   return HitAnswer{0, ray.origin};
                 })},
      {"every ray hits at the world's origin, s = 0",
       {"class", "parameter", "hit-point", "backward-error", "nearest-sphere"},
       always("hits-at-the-origin", {0, {}})},
      {"every ray hits at s = 1",
       {"class", "parameter", "hit-point", "backward-error", "nearest-sphere", "scaling",
        "focal-and-pixel"},
       answering(right, "hits-at-1",
                 [](const Ray& ray, const auto&...) { return properties::hit_at(ray, 1); })},
      {"every ray hits, at s = NaN",
       {"class", "parameter", "hit-point", "backward-error", "nearest-sphere"},
       always("hits-at-NaN", {kNaN, {kNaN, kNaN, kNaN}})},
      {"every ray hits infinitely far away",
       {"class", "parameter", "hit-point", "backward-error", "nearest-sphere"},
       always("hits-at-infinity", {kInfinity, {kInfinity, kInfinity, kInfinity}})},
  };
}

std::vector<Degenerate> degenerate_values(const Candidate& right) {
  const auto always = [&](std::string name, HitAnswer hit) {
    return knowing_the_class(right, std::move(name), [hit](const Ray&) { return hit; });
  };
  const auto of_line = [&](std::string name, reference::WhichRoot root) {
    return answering(right, std::move(name),
                     [root](const auto&... asked) { return root_of_line(asked..., root); });
  };
  return {
      {"every hit is where the ray starts, s = 0",
       {"parameter", "hit-point", "backward-error", "nearest-sphere"},
       knowing_the_class(right, "knows-hits-at-0",
                         [](const Ray& ray) {
                           return HitAnswer{0, ray.origin};
                         })},
      {"every hit is at the world's origin, s = 1",
       {"parameter", "hit-point", "backward-error", "nearest-sphere"},
       always("knows-hits-at-the-origin", {1, {}})},
      {"every hit is at s = NaN",
       {"parameter", "hit-point", "backward-error"},
       always("knows-hits-at-NaN", {kNaN, {kNaN, kNaN, kNaN}})},
      {"the far root of the line, whatever its sign",
       {"nearest-root", "class"},
       of_line("far-root", reference::WhichRoot::kLarger)},
      {"the near root of the line, whatever its sign",
       {"nearest-root", "class"},
       of_line("near-root", reference::WhichRoot::kSmaller)},
      {"a random answer, the same for the same question",
       {"class", "parameter", "hit-point", "backward-error", "nearest-sphere", "scaling", "axes",
        "growing-radius", "exchange", "focal-and-pixel"},
       answering(right, "random-hits",
                 [](const Ray& ray, const Sphere& sphere, const auto&...) -> Hit {
                   auto random = random_of({ray.origin.x, ray.direction.y, sphere.centre.x,
                                            sphere.centre.y, sphere.centre.z, sphere.radius});
                   if (random.one_in(2)) return {};
                   const double s = random.power_of_ten(-2, 2);
                   const scene::Vector3 Q = random.in_cube(10);
                   return HitAnswer{s, {Q.x, Q.y, Q.z}};
                 })},
  };
}

/// The answers to the previous question about rays and spheres.
class Before {
 public:
  explicit Before(const Candidate& right) : ask_(right.intersect) {}

  std::vector<Hit> answer(Candidate::Rays rays, const Sphere& sphere,
                          const Conventions& conventions) {
    const auto found = ask_(rays, std::span(&sphere, 1), conventions);
    std::vector<Hit> now(rays.size());
    for (const auto& [ray, hit] : found.front()) now[ray] = hit;
    if (const Key key{{rays.begin(), rays.end()}, sphere}; !(key == key_)) {
      before_ = std::exchange(last_, std::move(now));
      key_ = key;
    }
    std::vector<Hit> answers(rays.size());
    for (std::size_t k = 0; k < rays.size() && !before_.empty(); ++k) {
      answers[k] = before_[k % before_.size()];
    }
    return answers;
  }

 private:
  using Key = std::pair<std::vector<Ray>, Sphere>;
  decltype(Candidate::intersect) ask_;
  Key key_;
  std::vector<Hit> last_, before_;
};

Candidate answering_before(const Candidate& right) {
  Candidate candidate = renamed(right, "previous-hits");
  properties::answer_by(candidate, [before = std::make_shared<Before>(right)](
                                       const auto&... asked) { return before->answer(asked...); });
  return candidate;
}

Candidate ranking(const Candidate& right, std::string name,
                  const std::function<std::size_t(std::size_t)>& choose) {
  Candidate candidate = renamed(right, std::move(name));
  candidate.nearest = [choose](Candidate::Rays rays, Candidate::Spheres spheres, const auto&) {
    std::vector<std::optional<std::size_t>> answers(rays.size());
    if (spheres.empty()) return answers;
    for (auto& answer : answers) answer = choose(spheres.size());
    return answers;
  };
  return candidate;
}

}  // namespace

std::vector<Degenerate> degenerate_hits(const Candidate& right) {
  return joined(degenerate_classes(right),
                {degenerate_values(right),
                 {{"the answer to the previous question",
                   {"class", "parameter", "hit-point", "backward-error", "nearest-sphere"},
                   answering_before(right)},
                  {"the first sphere, whatever the ray",
                   {"nearest-sphere"},
                   ranking(right, "first-sphere", [](std::size_t) { return std::size_t{0}; })},
                  {"the last sphere, whatever the ray",
                   {"nearest-sphere"},
                   ranking(right, "last-sphere", [](std::size_t count) { return count - 1; })}}});
}

std::vector<Degenerate> all_degenerate(const Candidate& right) {
  return joined(degenerate_hits(right), {degenerate_rays(right), degenerate_scenes(right)});
}

}  // namespace raycheck::degenerate
