#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "properties/cases/case_text.h"
#include "properties/laws/law.h"
#include "scene/files/file_text.h"
#include "scene/files/scene_file.h"
#include "scene/invalid_input.h"
#include "tools/properties/properties.h"
#include "tools/report/digest.h"
#include "tools/report/output_file.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;
using properties::Case;

constexpr std::string_view kLaw = "law: ";
constexpr std::string_view kFoundWith = "found with: ";
constexpr std::string_view kReplay = "replay: ";
constexpr std::string_view kPixels = "pixels:";

/// The text that follows a word in the comments of a file, or empty.
std::string said(const std::string& text, std::string_view word) {
  std::istringstream lines(text);
  const std::string begins = "# " + std::string(word);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(begins)) return line.substr(begins.size());
  }
  return "";
}

/// " (3, 4) (5, 6)"
std::vector<scene::Pixel> pixels_of(std::string text) {
  for (char& c : text) {
    if (c == '(' || c == ')' || c == ',') c = ' ';
  }
  std::istringstream numbers(text);
  std::vector<scene::Pixel> pixels;
  for (scene::Pixel one; numbers >> one.i >> one.j;) pixels.push_back(one);
  return pixels;
}

/// Throws std::invalid_argument naming the file if a pixel is outside its camera's image.
void require_inside(const Case& the_case, const fs::path& file) {
  const auto& camera = *the_case.scene.camera;
  for (const scene::Pixel& one : the_case.pixels) {
    if (one.i >= 0 && one.j >= 0 && one.i < camera.width && one.j < camera.height) continue;
    throw scene::InvalidInput(
        "corpus", file.string(),
        fmt::format("pixel ({}, {}) is outside of its image of {} x {} pixels", one.i, one.j,
                    camera.width, camera.height));
  }
}

std::vector<fs::path> files_in(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// A candidate's name without folders of files, so that it is the same on all machines that share a
/// corpus: "source:/home/me/tracer.cpp" becomes "source:tracer.cpp".
std::string shared_name(const std::string& candidate) {
  std::istringstream words(candidate);
  std::string shared;
  for (std::string word; words >> word;) {
    const std::size_t begin = word.find(':') + 1;
    std::error_code none;
    const fs::path file = word.substr(begin);
    if (fs::exists(file, none)) word = word.substr(0, begin) + file.filename().string();
    shared += (shared.empty() ? "" : " ") + word;
  }
  return shared;
}

std::string name_of(const CampaignReport& campaign, const properties::Failure& failure) {
  std::string name = fmt::format("{}-{}", campaign.law->name, shared_name(campaign.candidate));
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  }
  return fmt::format("{}-{:.8}.toml", name, digest({scene_text(failure.shrunk)}));
}

}  // namespace

std::vector<CorpusFinding> try_corpus(const PropertiesOptions& options,
                                      std::span<const properties::Law* const> laws,
                                      std::span<const Implementation> implementations,
                                      std::span<const properties::Candidate> candidates) {
  std::vector<CorpusFinding> findings;
  const std::vector<std::string> names =
      lasting_names({implementations.begin(), implementations.end()});
  for (const fs::path& file : files_in(options.corpus)) {
    const std::string text = scene::file_text(file);
    const std::string law_name = said(text, kLaw);
    const auto law = std::ranges::find(laws, law_name, &properties::Law::name);
    if (properties::find_law(law_name) == nullptr) {
      throw scene::InvalidInput("corpus", file.string(), "names no law; add a line '# law: NAME'");
    }
    if (law == laws.end()) continue;
    Case the_case{scene::load_scene(file.string()).scene, pixels_of(said(text, kPixels))};
    if (the_case.scene.camera && the_case.pixels.empty()) {
      throw scene::InvalidInput("corpus", file.string(),
                                "has a camera and names no pixels; add a line '# pixels: (I, J)'");
    }
    if (the_case.scene.camera) require_inside(the_case, file);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      const auto result =
          run_case(**law, candidates[k], the_case, options.max_error, options.strict);
      findings.push_back({file.filename().string(),
                          law_name,
                          candidates[k].name,
                          names[k],
                          shared_name(candidates[k].name) == said(text, kFoundWith),
                          result.finding(),
                          {}});
      if (findings.back().finding == properties::Finding::kBroken) {
        findings.back().defects = result.failure->verdict.defects(options.strict);
      }
    }
  }
  return findings;
}

void keep_in_corpus(const PropertiesReport& report, const std::string& folder) {
  make_folder("corpus", folder);
  const auto keep = [&](const CampaignReport& campaign, const properties::Failure& failure) {
    if (failure.is_undecided) return;
    const fs::path file = fs::path(folder) / name_of(campaign, failure);
    if (fs::exists(file)) return;
    const std::string with = shared_name(campaign.candidate);
    std::string comment = fmt::format("{}{}\n{}{}", kLaw, campaign.law->name, kFoundWith, with);
    if (!failure.replay.empty()) {
      const auto& source = properties::parse_replay(failure.replay).source;
      comment += fmt::format("\n{}{}:{}:{}{}", kReplay, campaign.law->name, with, source.name(),
                             failure.replay.substr(failure.replay.rfind(':')));
    }
    OutputFile("corpus", file.string()).write(scene_text(failure.shrunk, comment));
  };
  for (const CampaignReport& campaign : report.campaigns) {
    if (campaign.result.failure) keep(campaign, *campaign.result.failure);
    for (const properties::Failure& other : campaign.result.others) keep(campaign, other);
  }
}

}  // namespace raycheck::tools
