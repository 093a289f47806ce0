#include <fmt/core.h>
#include <raycheck/cases.h>

#include <cstring>
#include <stdexcept>

#include "library/conversions.h"
#include "properties/cases/case_source.h"
#include "properties/cases/case_text.h"
#include "properties/cases/random.h"
#include "properties/cases/shrink.h"
#include "scene/fields.h"
#include "scene/files/scene_file.h"
#include "scene/validate.h"

namespace raycheck {
namespace {

/// Takes bytes from the front. After the last byte, it takes 0.
class Bytes {
 public:
  Bytes(const std::uint8_t* bytes, std::size_t count) : at_(bytes), left_(count) {}
  bool is_empty() const { return left_ == 0; }
  std::uint8_t one() { return is_empty() ? std::uint8_t{0} : (--left_, *at_++); }
  template <class Value>
  Value value() {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < sizeof bits; ++k) bits = bits << 8 | one();
    Value value;
    static_assert(sizeof value == sizeof bits);
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
};

properties::Case made(const properties::CaseSource& source, std::uint64_t seed, std::uint64_t k,
                      int severity) {
  const std::uint64_t start = properties::Random(seed).bits();
  return source.make(severity, properties::Random(start + k).bits());
}

}  // namespace

std::vector<Source> sources() {
  std::vector<Source> all;
  for (const properties::CaseSource& one : properties::case_sources()) {
    Source& source = all.emplace_back();
    source.name = one.name;
    source.sentence = one.sentence;
    source.has_camera = one.has_camera;
    if (!one.severities) continue;
    source.dial = one.severities->meaning;
    source.highest = one.severities->highest;
    source.ordinary = one.severities->ordinary;
    source.demanding = one.severities->demanding;
  }
  return all;
}

Case make_case(const std::string& name, std::uint64_t seed, std::uint64_t k, int severity) {
  const properties::CaseSource* const source = properties::find_case_source(name);
  if (source == nullptr) {
    throw std::invalid_argument(
        fmt::format("source {}: unknown name; raycheck::sources() has all names", name));
  }
  const int highest = source->severities ? source->severities->highest : 0;
  if (severity < 0 || severity > highest) {
    throw std::invalid_argument(
        fmt::format("severity = {}: {} has severities 0..{}", severity, name, highest));
  }
  return library::case_of(made(*source, seed, k, severity));
}

std::vector<Case> simpler(const Case& from) {
  std::vector<Case> all;
  for (const properties::Case& one : properties::simpler(library::case_of(from))) {
    all.push_back(library::case_of(one));
  }
  return all;
}

std::optional<Case> case_of_bytes(const std::uint8_t* bytes, std::size_t count) {
  Bytes from(bytes, count);
  const auto sources = properties::case_sources();
  const properties::CaseSource& source = sources[from.one() % sources.size()];
  const int severity = source.severities ? from.one() % (source.severities->highest + 1) : 0;
  properties::Case made = raycheck::made(source, from.value<std::uint64_t>(), 0, severity);
  std::vector<double*> numbers;
  scene::for_each_number(made.scene, [&](double& number) { numbers.push_back(&number); });
  while (!from.is_empty() && !numbers.empty()) {
    double& number = *numbers[from.one() % numbers.size()];
    number = from.value<double>();
  }
  if (!scene::defects(made.scene).empty()) return {};
  return library::case_of(made);
}

std::string scene_text(const Case& the_case) {
  return properties::scene_text(library::case_of(the_case));
}

Scene read_scene(const std::string& text) {
  return library::scene_of(scene::read_toml(text, "scene").scene);
}

}  // namespace raycheck
