// Figures of failing cases of functions.

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "scene/interruption.h"
#include "tools/grade/pages/views.h"
#include "tools/implementations/implementation.h"
#include "tools/report/words.h"
#include "tools/view/page/page.h"
#include "tools/view/scene_view.h"

namespace raycheck::tools {
namespace {

/// The name of the student's submission on pages.
constexpr const char* kYours = "yours";

using properties::Candidate;

/// Thrown for a question that was not asked when the submission was judged.
struct NotAsked : std::runtime_error {
  NotAsked() : std::runtime_error("it was not asked") {}
};

/// The stored hits of the one ray with spheres of the case.
properties::SphereHits hits_of(const FailingCase& failing, const scene::Sphere& sphere) {
  const auto& spheres = failing.the_case.scene.spheres;
  const auto known = std::ranges::find(spheres, sphere);
  if (known == spheres.end()) throw NotAsked();
  const auto& hits = *failing.answers->hits;
  const auto hit = hits.find(static_cast<std::size_t>(known - spheres.begin()));
  if (hit == hits.end()) return {};
  return {{0, hit->second}};
}

Candidate candidate_that_answered(const FailingCase& failing, const Tolerance& tolerance) {
  const RayAnswers& answers = *failing.answers;
  Candidate candidate;
  candidate.name = kYours;
  candidate.precision = failing.answer.precision;
  candidate.unit_roundoff = scene::unit_roundoff(candidate.precision);
  candidate = tolerated(std::move(candidate), tolerance);
  if (tolerance.ulp) candidate.max_error.fill(*tolerance.ulp);
  if (answers.frame) {
    candidate.frame = [frame = *answers.frame](const scene::Camera&) { return frame; };
  }
  if (answers.pixel_point) {
    candidate.pixel_points = [point = *answers.pixel_point](const auto&, const auto&, const auto&) {
      return std::vector<scene::Point3>{point};
    };
  }
  if (answers.ray) {
    const bool from_pixel = failing.the_case.scene.conventions.origin == scene::Origin::kPixel;
    (from_pixel ? candidate.pixel_rays : candidate.focal_rays) =
        [ray = *answers.ray](const auto&, const auto&, const auto&) {
          return std::vector<scene::Ray>{ray};
        };
  }
  if (answers.hits) {
    candidate.intersect = [failing](const auto&, Candidate::Spheres spheres, const auto&) {
      std::vector<properties::SphereHits> hits;
      for (const scene::Sphere& sphere : spheres) hits.push_back(hits_of(failing, sphere));
      return hits;
    };
  }
  return candidate;
}

/// An implementation that repeats a submission's stored answers about a failing case, without
/// running the submission, with the item's tolerance. Null if there are no stored answers or they
/// are withheld.
std::shared_ptr<const Implementation> answered(const FailingCase& failing,
                                               const Tolerance& tolerance,
                                               const Layers& isolation) {
  if (!failing.answers) return nullptr;
  return std::make_shared<const Implementation>(Implementation{
      .name = kYours,
      .isolated_by = isolation.text(),
      .precision = failing.answer.precision,
      .make = [candidate = candidate_that_answered(failing, tolerance)] { return candidate; }});
}

/// At most this many spheres of a ray get a panel: the failing one first, then the others in order.
constexpr std::size_t kMostSpheresShown = 8;

/// Selections for the judged answer, and for other spheres that the ray may meet.
std::vector<Selection> wanted_of(const FailingCase& failing) {
  std::vector<Selection> wanted = selections_of(failing.the_case, failing.answer.place);
  // Only the answers about this ray are stored.
  wanted.resize(std::min<std::size_t>(wanted.size(), 1));
  if (wanted.empty() || !failing.answers || !failing.answers->hits) return wanted;
  Selection other = wanted.front();
  for (std::size_t k = 0; k < failing.the_case.scene.spheres.size(); ++k) {
    if (wanted.size() == kMostSpheresShown) break;
    if (k == wanted.front().sphere) continue;
    other.sphere = k;
    wanted.push_back(other);
  }
  return wanted;
}

/// "hit point: hit point, ray 0, sphere 0: off by 3 u; yours Q = (0, 0, 1), exact Q = (0, 0, 2)"
std::string sentence_of(const Item& item, const FailingCase& failing) {
  std::string text = fmt::format("{}: {}", item.name, answer_text(failing));
  const std::string got = got_text(failing), exact = exact_text(failing);
  if (!got.empty()) text += fmt::format("; {} {}", kYours, got);
  if (!exact.empty()) text += fmt::format(", exact {}", exact);
  return text;
}

/// Whether a step of the first selection is wrong. (Relations between answers belong to no step.)
bool goes_wrong(const SceneView& shown) {
  if (shown.panels.empty()) return false;
  const std::vector<std::string>& wrong = shown.panels.front().wrong;
  return std::ranges::find(wrong, kYours) != wrong.end();
}

void add_figure(const StudentGrade& grade, std::size_t k, ViewDocument& document) {
  const Item& item = *grade.items[k];
  const FailingCase& failing = *grade.submission.items[k].failing;
  SceneViewOptions view;
  view.name = file_name(item.name) + ".toml";
  view.file = view.name;
  if (grade.submission.found.program)
    view.more_arguments = " --candidate " + shell_word(grade.submission.found.program->text());
  view.other = answered(failing, item.tolerance, grade.submission.isolation);
  view.others_picture = false;
  view.wanted = wanted_of(failing);
  view.limits.panels = std::max<std::size_t>(view.wanted.size(), 1);
  SceneView shown =
      view_of(failing.the_case.scene, view, document.left_out, properties::RunControl{});
  Selection selection = selection_of(failing.answer.place, failing.the_case.scene);
  if (!is_of_ray(selection)) selection = shown.start;
  document.findings.push_back({sentence_of(item, failing), kYours, goes_wrong(shown) ? kYours : "",
                               properties::Standing::kDefect, document.scenes.size(), selection});
  document.scenes.push_back(std::move(shown));
}

}  // namespace

bool has_figure(const StudentGrade& grade, std::size_t k) {
  const ItemGrade& item = grade.submission.items[k];
  return !item.pictures && item.failing && !item.failing->is_withheld;
}

bool has_figures(const StudentGrade& grade) {
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    if (has_figure(grade, k)) return true;
  }
  return false;
}

std::string figures_page(const StudentGrade& grade) {
  // A page that is begun is finished despite interrupts, since that is quick.
  const std::function<bool()> never = [] { return false; };
  const scene::Interruptible until_done(never);
  ViewDocument document;
  document.title = grade.title + ": " + grade.submission.name;
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    if (has_figure(grade, k)) add_figure(grade, k, document);
  }
  return page(document);
}

}  // namespace raycheck::tools
