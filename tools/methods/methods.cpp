#include "tools/methods/methods.h"

#include <algorithm>
#include <stdexcept>

#include "properties/candidates/fast_candidate.h"
#include "properties/candidates/reference_methods.h"
#ifdef RAYCHECK_HAS_PEERS
#include "tools/peers/peers.h"
#endif

namespace raycheck::tools {
namespace {

template <class Methods>
auto& find(const Methods& methods, const std::string& name, const char* field) {
  std::string known;
  for (const auto* method : methods) {
    if (method->name == name) return *method;
    known += (known.empty() ? "" : ", ") + std::string(method->name);
  }
  throw std::invalid_argument(std::string(field) + " " + name +
                              ": no such method; the methods are " + known);
}

}  // namespace

const fast::PixelRayMethod& find_rays(const std::string& name, const char* field) {
  return find(fast::pixel_ray_methods(), name, field);
}

const fast::IntersectMethod& find_intersect(const std::string& name, const char* field) {
  return find(all_intersect_methods(), name, field);
}

MethodPair find_pair(const std::string& name) {
  constexpr const char* kField = "bounds";
  const std::size_t slash = name.find('/');
  if (slash == std::string::npos) return {kDefaultMethods.rays, &find_intersect(name, kField)};
  return {&find_rays(name.substr(0, slash), kField),
          &find_intersect(name.substr(slash + 1), kField)};
}

std::vector<const fast::IntersectMethod*> all_intersect_methods() {
  std::vector<const fast::IntersectMethod*> all;
  const auto append = [&all](std::span<const fast::IntersectMethod* const> methods) {
    all.insert(all.end(), methods.begin(), methods.end());
  };
  append(fast::intersect_methods());
  append(properties::exact_methods());
#ifdef RAYCHECK_HAS_PEERS
  append(peers::peers());
#endif
  return all;
}

std::vector<StagedMethod> find_methods(const std::vector<std::string>& names) {
  std::vector<StagedMethod> all;
  for (const auto* method : fast::pixel_ray_methods()) {
    all.push_back(
        {properties::Stage::kRays, method, kDefaultMethods.intersect, nullptr, all.size()});
  }
  const std::size_t rays = all.size();
  for (const auto* method : all_intersect_methods()) {
    all.push_back({properties::Stage::kIntersection, kDefaultMethods.rays, method, nullptr,
                   all.size() - rays});
  }
  constexpr const char* kAll = "all";
  if (std::find(names.begin(), names.end(), kAll) != names.end()) {
    if (names.size() == 1) return all;
    throw std::invalid_argument("method all: is every method; leave out the others");
  }
  if (names.empty()) {
    const auto fast = fast::intersect_methods();
    std::erase_if(all, [&](const StagedMethod& method) {
      return method.stage == properties::Stage::kIntersection &&
             std::find(fast.begin(), fast.end(), method.intersect) == fast.end();
    });
    return all;
  }
  const auto is_called = [](const StagedMethod& method, const std::string& name) {
    const bool makes_rays = method.stage == properties::Stage::kRays;
    return name == method.name() ||
           name == (makes_rays ? "rays/" : "intersect/") + std::string(method.name());
  };
  for (const std::string& name : names) {
    if (std::none_of(all.begin(), all.end(),
                     [&](const StagedMethod& method) { return is_called(method, name); })) {
      std::string known;
      for (const StagedMethod& method : all) {
        known += (known.empty() ? "" : ", ") + std::string(method.name());
      }
      throw std::invalid_argument("method " + name + ": no such method; the methods are " + known);
    }
  }
  std::erase_if(all, [&](const StagedMethod& method) {
    return std::none_of(names.begin(), names.end(),
                        [&](const std::string& name) { return is_called(method, name); });
  });
  return all;
}

std::vector<StagedMethod> find_methods(const std::vector<std::string>& names,
                                       const std::vector<StagedMethod>& others) {
  std::vector<StagedMethod> found;
  if (others.empty() || !names.empty()) found = find_methods(names);
  std::size_t number = all_intersect_methods().size();
  for (const StagedMethod& other : others) {
    found.push_back(other);
    found.back().number = number++;
  }
  return found;
}

properties::Candidate candidate_of(const MethodPair& pair) {
  return properties::fast_candidate(*pair.rays, *pair.intersect);
}

properties::Candidate candidate_of(const StagedMethod& method) {
  if (method.other) return method.other->candidate();
  return candidate_of(MethodPair{method.rays, method.intersect});
}

std::vector<MethodPair> all_pairs() {
  std::vector<MethodPair> pairs;
  for (const auto* rays : fast::pixel_ray_methods()) {
    for (const auto* intersect : fast::intersect_methods()) pairs.push_back({rays, intersect});
  }
  return pairs;
}

std::vector<MethodPair> each_method_once() {
  std::vector<MethodPair> pairs;
  for (const auto* rays : fast::pixel_ray_methods()) {
    pairs.push_back({rays, kDefaultMethods.intersect});
  }
  for (const auto* intersect : fast::intersect_methods()) {
    if (intersect != kDefaultMethods.intersect) {
      pairs.push_back({kDefaultMethods.rays, intersect});
    }
  }
  return pairs;
}

}  // namespace raycheck::tools
