#include "properties/mistakes/answer_examination.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "properties/trial.h"
#include "scene/interruption.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

bool agree(const Vector3& a, const Vector3& b, double tolerance) {
  double size = 0;
  for (const double x : {a.x, a.y, a.z, b.x, b.y, b.z}) {
    if (std::isfinite(x)) size = std::max(size, std::abs(x));
  }
  const auto same = [allowed = tolerance * size](double x, double y) {
    return (std::isnan(x) && std::isnan(y)) || x == y || std::abs(x - y) <= allowed;
  };
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

bool agree(const Answer& a, const Answer& b, double tolerance) {
  return a.choice == b.choice &&
         std::equal(a.vectors.begin(), a.vectors.end(), b.vectors.begin(),
                    [tolerance](auto& x, auto& y) { return agree(x, y, tolerance); });
}

bool is_number(const Answer& answer) {
  return std::all_of(answer.vectors.begin(), answer.vectors.end(), [](const Vector3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  });
}

/// The s of a point, or of the point of the ray that is nearest to it.
double parameter_of(const Point3& point, const Ray& ray) {
  const Vector3 T = point - ray.origin;
  const auto& [x, y, z] = ray.direction;
  return (T.x * x + T.y * y + T.z * z) / (x * x + y * y + z * z);
}

StepAnswers hit_answers(const AskedCase& asked, Trial& trial) {
  const bool picks_points = asked.picks && gives_point(asked.returns);
  const std::vector<Sphere>& spheres = asked.the_case.scene.spheres;
  std::vector<SphereHits> found;
  if (asked.picks) {
    for (std::size_t k = 0; k < spheres.size(); ++k) found.push_back(trial.hits(k));
  } else {
    found = trial.intersect(asked.rays, spheres, trial.conventions());
  }
  StepAnswers answers;
  for (const SphereHits& hits : found) {
    const std::size_t first = answers.size();
    answers.resize(first + asked.rays.size());
    for (const auto& [ray, hit] : hits) {
      answers[first + ray].choice = 0;
      auto& [s, Q, none] = answers[first + ray].vectors;
      if (asked.returns != Returns::kClass) s.x = hit.parameter;
      if (picks_points) s.x = parameter_of(hit.point, asked.rays[ray]);
      if (gives_point(asked.returns)) Q = vector(hit.point);
    }
  }
  return answers;
}

/// The answers at a step; empty if the candidate lacks the function.
std::optional<StepAnswers> ask(Step step, const AskedCase& asked, const Candidate& candidate) {
  Trial trial(asked.the_case, candidate);
  const Scene& scene = asked.the_case.scene;
  StepAnswers answers;
  switch (step) {
    case Step::kFrame: {
      if (!scene.camera || !candidate.frame) return {};
      const auto& [U, V, W] = trial.frame();
      return StepAnswers{{{}, {vector(U), vector(V), vector(W)}}};
    }
    case Step::kPixelPoint:
      if (!scene.camera || !candidate.pixel_points) return {};
      for (const Point3& P : trial.pixel_points()) answers.push_back({{}, {vector(P)}});
      return answers;
    case Step::kRay:
      if (!scene.camera || !trial.has_rays()) return {};
      for (const auto& [origin, direction] : trial.rays()) {
        answers.push_back({{}, {vector(origin), direction}});
      }
      return answers;
    case Step::kIntersect:
      if (!candidate.intersect && !trial.picks()) return {};
      return hit_answers(asked, trial);
    case Step::kNearest:
      break;
  }
  if (!candidate.nearest) return {};
  for (const auto& sphere : trial.rank(asked.rays, scene.spheres)) {
    answers.push_back({sphere, {}});
  }
  return answers;
}

/// The answers at a step; empty if the candidate lacks the function, refuses or fails.
std::optional<StepAnswers> try_to_ask(Step step, const AskedCase& asked,
                                      const Candidate& candidate) {
  scene::poll();
  try {
    return ask(step, asked, candidate);
  } catch (const NoAnswer&) {
    return {};
  }
}

/// Answers with at most this relative error have more digits than floats have.
constexpr double kPrecise = 0x1p-36;

/// Whether an answer is neither as expected nor equal to that of another right formula.
bool is_different(const Comparison& comparison, std::size_t k, const StepAnswers& expected,
                  double tolerance) {
  const auto is_like = [&](const StepAnswers& other) {
    return agree(comparison.answers[k], other[k], tolerance);
  };
  if (is_like(expected)) return false;
  return is_like(comparison.right) ||
         std::none_of(comparison.also_right.begin(), comparison.also_right.end(), is_like);
}

/// The number of answers for which is_different() holds.
std::uint64_t count_different(const Comparison& comparison, const StepAnswers& expected,
                              double tolerance) {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
    count += is_different(comparison, k, expected, tolerance) ? 1 : 0;
  }
  return count;
}

/// For each answer, in their order: whether it misses a sphere that no answer hits.
std::vector<bool> dropped(Step step, const Comparison& comparison) {
  const std::size_t count = comparison.asked->rays.size();
  const auto sphere_of = [&](const Answer& answer, std::size_t k) -> std::optional<std::size_t> {
    if (!answer.choice) return {};
    return step == Step::kNearest ? *answer.choice : k / count;
  };
  std::set<std::size_t> met;
  for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
    if (const auto sphere = sphere_of(comparison.answers[k], k)) met.insert(*sphere);
  }
  std::vector<bool> found(comparison.answers.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto sphere = sphere_of(comparison.right[k], k);
    found[k] = sphere && !comparison.answers[k].choice && !met.contains(*sphere);
  }
  return found;
}

/// Whether, with the declared ends, roots computed in doubles give another hit class or root than
/// the exact roots.
bool ends_are_close(const AskedCase& asked) {
  Conventions conventions = asked.the_case.scene.conventions;
  if (conventions.valid.is_usual()) return false;
  Case given{asked.the_case.scene, {}};
  given.scene.camera.reset();
  given.scene.rays = asked.rays;
  if (!scene::defects(given.scene).empty()) return true;
  Truth truth(given, conventions);
  const scene::ValidRoots valid = conventions.valid;
  for (std::size_t ray = 0; ray < asked.rays.size(); ++ray) {
    for (std::size_t sphere = 0; sphere < given.scene.spheres.size(); ++sphere) {
      const fast::Roots roots = fast::kCross.roots(asked.rays[ray], given.scene.spheres[sphere]);
      conventions.valid = in_multiples(valid, asked.rays[ray], given.scene.spheres[sphere]);
      const Hit chosen = usual_choice(asked.rays[ray], roots, conventions);
      const auto& exact = truth.intersection(ray, sphere);
      if (chosen.has_value() != counts_as_hit(exact.hit_class, conventions.tangent)) return true;
      const bool is_smaller = exact.root == WhichRoot::kSmaller;
      if (chosen && chosen->parameter != (is_smaller ? roots.smaller : roots.larger)) return true;
    }
  }
  return false;
}

/// Leaves out the rays that start inside a sphere, or nearly so: mistakes and right formulas have
/// hits at roots there.
void leave_out_rays_from_inside(AskedCase& asked) {
  constexpr double kNearly = 1.001;
  const auto starts_inside_some = [&](const Ray& ray) {
    return scene::defects(ray).empty() &&
           std::ranges::any_of(asked.the_case.scene.spheres, [&](const Sphere& sphere) {
             return starts_inside(ExactRay(ray), {sphere.centre, kNearly * sphere.radius});
           });
  };
  for (std::size_t k = asked.rays.size(); k-- > 0;) {
    if (!starts_inside_some(asked.rays[k])) continue;
    const auto at = static_cast<std::ptrdiff_t>(k);
    const auto drop = [at](auto& list) { list.erase(list.begin() + at); };
    drop(asked.rays);
    if (asked.the_case.scene.camera)
      drop(asked.the_case.pixels);
    else
      drop(asked.the_case.scene.rays);
  }
}

/// Replaces answers within a declared tolerance by the right ones.
void leave_out_tolerated(Comparison& comparison, const Candidate& candidate) {
  if (candidate.tolerances == contract::Tolerances{}) return;
  const auto& [the_case, rays, returns, picks] = *comparison.asked;
  for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
    if (agree(comparison.answers[k], comparison.right[k], kAnswerTolerances.front())) continue;
    const ExactRay ray(rays[k % rays.size()]);
    const ChangedPair pair = {ray, the_case.scene.spheres[k / rays.size()],
                              excused_change(candidate.unit_roundoff)};
    if (tolerance_of(candidate.tolerances, pair) > 0) comparison.answers[k] = comparison.right[k];
  }
}

/// The case as asked; empty outside the candidate's domain, or if its format cannot hold the case.
std::optional<AskedCase> asked_case(const Case& the_case, const Candidate& candidate,
                                    const Candidate& right) {
  auto rounded = rounded_case(the_case, candidate.input_format()).the_case;
  if (!rounded || !is_inside_domain(candidate, rounded->scene)) return {};
  AskedCase asked = {*std::move(rounded), {}, candidate.interface.returns};
  asked.picks = asked.the_case.scene.camera && candidate.pick;
  Conventions& conventions = asked.the_case.scene.conventions;
  conventions = candidate.declared.over(conventions);
  asked.rays = Trial(asked.the_case, right).rays();
  for (Ray& ray : asked.rays) ray = rounded_ray(ray, candidate.input_format());
  if (candidate.interface.from_inside != contract::FromInside::kRoot) {
    leave_out_rays_from_inside(asked);
    if (asked.rays.empty()) return {};
  }
  return asked;
}

}  // namespace

bool is_left_out(const Case& the_case, const Candidate& candidate) {
  const auto asked = asked_case(the_case, candidate, right_candidate());
  return asked && ends_are_close(*asked);
}

Examination::Examination(std::span<const Case> cases, const Candidate& candidate,
                         NotNumbers not_numbers)
    : candidate_(candidate), not_numbers_(not_numbers), others_(other_right_candidates(candidate)) {
  for (const Case& the_case : cases) {
    auto asked = asked_case(the_case, candidate, right_);
    if (!asked) continue;
    if (ends_are_close(*asked)) {
      ++left_out_;
    } else {
      asked_.push_back(*std::move(asked));
    }
  }
}

const std::vector<Comparison>& Examination::at(Step step) {
  auto& known = comparisons_[static_cast<std::size_t>(step)];
  if (known) return *known;
  known.emplace();
  for (const AskedCase& asked : asked_) {
    std::optional<StepAnswers> answers = try_to_ask(step, asked, candidate_);
    if (!answers) continue;
    Comparison comparison = {&asked, std::move(*answers), ask(step, asked, right_).value(), {}};
    for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
      if (is_number(comparison.answers[k]) || !is_number(comparison.right[k])) continue;
      ++not_number_counts_[static_cast<std::size_t>(step)];
      if (not_numbers_ == NotNumbers::kLeftOut) comparison.answers[k] = comparison.right[k];
    }
    if (step == Step::kIntersect) leave_out_tolerated(comparison, candidate_);
    if (count_different(comparison, comparison.right, kAnswerTolerances.front()) > 0) {
      comparison.also_right = ask_others(step, asked);
    }
    known->push_back(std::move(comparison));
  }
  return *known;
}

std::uint64_t Examination::errors(Step step, double tolerance) {
  std::uint64_t count = 0;
  for (const Comparison& comparison : at(step))
    count += count_different(comparison, comparison.right, tolerance);
  return count;
}

std::uint64_t Examination::not_numbers(Step step) {
  at(step);
  return not_number_counts_[static_cast<std::size_t>(step)];
}

std::uint64_t Examination::wrong_numbers(Step step, double tolerance, const Candidate* other) {
  std::uint64_t count = 0;
  if (step == Step::kNearest || candidate_.interface.returns == Returns::kClass) return 0;
  for (const Comparison& comparison : at(step)) {
    const auto its = other ? try_to_ask(step, *comparison.asked, *other) : std::nullopt;
    for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
      const bool is_miss = step == Step::kIntersect && !comparison.answers[k].choice;
      if (is_miss || !is_different(comparison, k, comparison.right, tolerance)) continue;
      count += its && agree(comparison.answers[k], (*its)[k], tolerance) ? 0 : 1;
    }
  }
  return count;
}

bool Examination::shows(const Candidate& made, Step first, Step last, double tolerance) {
  for (auto step = static_cast<int>(last); step >= static_cast<int>(first); --step) {
    for (const Comparison& comparison : at(static_cast<Step>(step))) {
      const auto its = try_to_ask(static_cast<Step>(step), *comparison.asked, made);
      if (!its) continue;
      const bool is_right = std::equal(
          its->begin(), its->end(), comparison.right.begin(), comparison.right.end(),
          [tolerance](const Answer& a, const Answer& b) { return agree(a, b, tolerance); });
      if (!is_right) return true;
    }
  }
  return false;
}

std::uint64_t Examination::contradicted(const Candidate& made, Step first, Step last,
                                        double tolerance, std::uint64_t most) {
  std::uint64_t count = 0;
  for (auto step = static_cast<int>(last); step >= static_cast<int>(first); --step) {
    for (const Comparison& comparison : at(static_cast<Step>(step))) {
      if (count > most) return count;
      const auto its = try_to_ask(static_cast<Step>(step), *comparison.asked, made);
      count += count_different(comparison, its ? *its : comparison.right, tolerance);
    }
  }
  return count;
}

bool Examination::is_of_input(const Ray& ray, const Sphere& sphere, double error) const {
  const double lengths = norm(ray.origin) + norm(sphere.centre) + sphere.radius;
  return std::abs(error) * norm(ray.direction) <= 8 * roundoff() * lengths;
}

/// Whether an answer is as of a larger sphere than the right one, which differs.
bool is_outward(const Answer& answer, const Answer& right, const Ray& ray, const Sphere& sphere) {
  if (answer.choice != right.choice) return answer.choice.has_value();
  const double middle = parameter_of(sphere.centre, ray);
  return std::abs(answer.vectors[0].x - middle) > std::abs(right.vectors[0].x - middle);
}

DoubtTally Examination::tally(Step step, Arithmetic arithmetic, double tolerance) {
  DoubtTally all;
  for (const Comparison& comparison : at(step)) {
    const auto& [the_case, rays, returns, picks] = *comparison.asked;
    const Conventions& conventions = the_case.scene.conventions;
    const std::vector<bool> is_dropped = dropped(step, comparison);
    for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
      const Answer& answer = comparison.answers[k];
      const bool is_wrong = is_different(comparison, k, comparison.right, tolerance);
      if (step == Step::kNearest) {
        const PossibleSight sight =
            possible_sight(arithmetic, rays[k], the_case.scene.spheres, conventions, answer.choice);
        all.add(is_wrong, is_dropped[k], sight.allows, sight.is_doubtful, sight.radii);
        continue;
      }
      const PossibleHit hit = possible_hit(arithmetic, rays[k % rays.size()],
                                           the_case.scene.spheres[k / rays.size()], conventions);
      const bool is_wide = hit.is_possible && hit.most - hit.least > tolerance * hit.most;
      const auto s = answer.choice ? std::optional(answer.vectors[0].x) : std::nullopt;
      // Roundings of d^2 move Q along the ray.
      const bool is_on_ray =
          !s || !gives_point(returns) ||
          agree(answer.vectors[1], vector(hit_at(rays[k % rays.size()], *s).point), 1e-3);
      const bool is_allowed =
          s && returns == Returns::kClass ? hit.is_possible : is_on_ray && hit.allows(s);
      const bool is_of_both = s && comparison.right[k].choice && returns != Returns::kClass;
      const bool is_excused =
          is_of_both && is_of_input(rays[k % rays.size()], the_case.scene.spheres[k / rays.size()],
                                    *s - comparison.right[k].vectors[0].x);
      all.add(is_wrong && !is_excused, is_dropped[k], is_allowed, hit.is_doubtful() || is_wide,
              hit.radii);
      if (is_wrong && !is_excused) {
        const bool is_out = is_outward(answer, comparison.right[k], rays[k % rays.size()],
                                       the_case.scene.spheres[k / rays.size()]);
        ++(is_out ? all.outward : all.inward);
      }
      if (is_wrong || !s || returns == Returns::kClass) continue;
      const double exact = comparison.right[k].vectors[0].x;
      ++all.hits;
      all.precise += std::abs(*s - exact) <= kPrecise * exact ? 1 : 0;
    }
  }
  return all;
}

std::vector<StepAnswers> Examination::ask_others(Step step, AskedCase asked) const {
  std::vector<StepAnswers> answers;
  Conventions& conventions = asked.the_case.scene.conventions;
  const auto add = [&](const Candidate& other) {
    if (!(other.declared.over(conventions) == conventions)) return;
    if (auto its = try_to_ask(step, asked, other)) answers.push_back(std::move(*its));
  };
  for (const Candidate& other : others_) add(other);
  if (conventions.tangent == scene::Tangent::kEither && step >= Step::kIntersect) {
    conventions.tangent = scene::Tangent::kMiss;
    add(right_);
  }
  return answers;
}

}  // namespace raycheck::properties
