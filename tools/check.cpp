#include "tools/check.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "properties/fast_candidate.h"
#include "properties/law.h"
#include "tools/terminal.h"
#include "tools/timing.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::Law;
using properties::Trial;
using properties::Verdict;

/// Rays judged before progress is shown and an interrupt is heeded.
constexpr std::size_t kChunk = 512;

std::uint64_t count_rays(const scene::Scene& scene) {
  if (!scene.camera) return scene.rays.size();
  return static_cast<std::uint64_t>(scene.camera->width) *
         static_cast<std::uint64_t>(scene.camera->height);
}

/// Pixel number `index` of an image, row by row.
scene::Pixel pixel_at(const scene::Camera& camera, std::uint64_t index) {
  const auto width = static_cast<std::uint64_t>(camera.width);
  return {static_cast<std::int64_t>(index % width), static_cast<std::int64_t>(index / width)};
}

/// The chunks of a scene's rays: cases of up to kChunk rays, `judged` of them in all, spread
/// evenly.
class Chunks {
 public:
  Chunks(const scene::Scene& scene, std::uint64_t judged)
      : scene_(scene), total_(count_rays(scene)), judged_(judged) {}

  bool next(Case& out) {
    if (done_ >= judged_) return false;
    const std::uint64_t end = std::min<std::uint64_t>(done_ + kChunk, judged_);
    out.scene = scene_;
    out.pixels.clear();
    first_ = done_;
    if (scene_.camera) {
      for (std::uint64_t k = done_; k < end; ++k) {
        // k * total / judged without overflow.
        const std::uint64_t index =
            judged_ == total_ ? k
                              : static_cast<std::uint64_t>(static_cast<long double>(k) *
                                                           static_cast<long double>(total_) /
                                                           static_cast<long double>(judged_));
        out.pixels.push_back(pixel_at(*scene_.camera, index));
      }
    } else {
      out.scene.rays.assign(scene_.rays.begin() + static_cast<std::ptrdiff_t>(done_),
                            scene_.rays.begin() + static_cast<std::ptrdiff_t>(end));
    }
    done_ = end;
    return true;
  }
  std::uint64_t first() const { return first_; }
  std::uint64_t done() const { return done_; }

 private:
  const scene::Scene& scene_;
  std::uint64_t total_;
  std::uint64_t judged_;
  std::uint64_t first_ = 0;
  std::uint64_t done_ = 0;
};

/// A law whose answer is one for the scene, not one for each ray.
bool is_per_scene(const Law& law) { return law.name == "frame"; }

/// Returns how many rays were judged.
std::uint64_t judge(const CheckOptions& options, const scene::Scene& scene, std::uint64_t judged,
                    CandidateReport& report) {
  const Candidate candidate =
      properties::fast_candidate(*report.methods.rays, *report.methods.intersect);
  report.name = candidate.name;
  report.conventions = candidate.declared.over(scene.conventions);
  for (std::size_t k = 0; k < properties::kQuantityCount; ++k) {
    report.bounds.push_back(
        options.max_error.value_or(max_error(candidate, static_cast<properties::Quantity>(k))));
  }
  std::map<std::string_view, std::string> left_out;
  Progress progress(candidate.name);
  Chunks chunks(scene, judged);
  Case chunk;
  while (!interrupted() && chunks.next(chunk)) {
    Trial trial(chunk, candidate, options.max_error);
    for (const Law& law : properties::laws()) {
      if (!law.judges_values || (is_per_scene(law) && chunks.first() > 0)) continue;
      Verdict verdict = apply(law, trial);
      if (!verdict.reason_left_out().empty()) left_out[law.name] = verdict.reason_left_out();
      if (!scene.camera) verdict.shift_rays(chunks.first());
      report.verdict.merge(std::move(verdict));
    }
    if (chunks.first() == 0) {
      report.timing = time_methods(report.methods, scene, report.conventions, chunk.pixels);
    }
    progress.show(fmt::format("{} of {} rays judged", chunks.done(), judged));
  }
  for (const Law& law : properties::laws()) {
    const auto found = left_out.find(law.name);
    if (found != left_out.end()) {
      report.left_out.push_back({std::string(law.name), found->second});
    }
  }
  return chunks.done();
}

/// What was left out, one line a reason, with the candidate's name where not all left it out.
std::vector<std::string> left_out_lines(const CheckReport& report) {
  std::vector<std::string> lines;
  if (report.rays_judged < report.rays_in_scene && !report.interrupted) {
    lines.push_back(fmt::format("{} of {} pixels: --pixels asked for {}",
                                report.rays_in_scene - report.rays_judged, report.rays_in_scene,
                                report.rays_judged));
  }
  if (report.scene.camera && report.scene.camera->far) {
    lines.emplace_back("camera.far: no quantity depends on it");
  }
  // Laws by whose reason it is and which; the order is that of the laws.
  std::vector<std::pair<std::string, std::string>> grouped;
  const auto add = [&](const std::string& whose, const LeftOut& entry) {
    const std::string key = whose + "\n" + entry.reason;
    for (auto& [known, laws] : grouped) {
      if (known == key) {
        if ((", " + laws + ",").find(", " + entry.law + ",") == std::string::npos) {
          laws += ", " + entry.law;
        }
        return;
      }
    }
    grouped.emplace_back(key, entry.law);
  };
  for (const CandidateReport& candidate : report.candidates) {
    for (const LeftOut& entry : candidate.left_out) {
      const bool all = std::all_of(
          report.candidates.begin(), report.candidates.end(), [&](const CandidateReport& other) {
            return std::find(other.left_out.begin(), other.left_out.end(), entry) !=
                   other.left_out.end();
          });
      add(all ? "" : candidate.name + ", ", entry);
    }
  }
  for (const auto& [key, laws] : grouped) {
    const std::size_t split = key.find('\n');
    lines.push_back(key.substr(0, split) + laws + ": " + key.substr(split + 1));
  }
  return lines;
}

}  // namespace

std::uint64_t CheckReport::discrepancies() const {
  std::uint64_t sum = 0;
  for (const CandidateReport& candidate : candidates) sum += candidate.verdict.discrepancies();
  return sum;
}

std::uint64_t CheckReport::compared() const {
  std::uint64_t sum = 0;
  for (const CandidateReport& candidate : candidates) sum += candidate.verdict.compared();
  return sum;
}

CheckReport check(const CheckOptions& options) {
  scene::LoadedScene loaded = scene::load_scene(options.path, options.dialect);
  CheckReport report;
  report.path = options.path;
  report.scene = std::move(loaded.scene);
  report.warnings = std::move(loaded.warnings);
  report.top = options.top;
  report.rays_in_scene = count_rays(report.scene);
  std::uint64_t judged = report.rays_in_scene;
  if (report.scene.camera && options.pixels) {
    judged = std::min(judged, static_cast<std::uint64_t>(*options.pixels));
  }
  report.rays_judged = judged;
  for (const MethodPair& pair : options.methods) {
    if (interrupted()) break;
    CandidateReport candidate;
    candidate.methods = pair;
    report.rays_judged =
        std::min(report.rays_judged, judge(options, report.scene, judged, candidate));
    report.candidates.push_back(std::move(candidate));
  }
  report.interrupted = interrupted();
  report.left_out = left_out_lines(report);
  return report;
}

}  // namespace raycheck::tools
