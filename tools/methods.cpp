#include "tools/methods.h"

#include <stdexcept>

namespace raycheck::tools {
namespace {

template <class Methods>
auto& find(const Methods& methods, const std::string& name, const char* option) {
  std::string known;
  for (const auto* method : methods) {
    if (method->name == name) return *method;
    known += (known.empty() ? "" : ", ") + std::string(method->name);
  }
  throw std::invalid_argument(std::string(option) + " " + name +
                              ": no such method; the methods are " + known);
}

}  // namespace

const fast::PixelRayMethod& find_rays(const std::string& name) {
  return find(fast::pixel_ray_methods(), name, "--rays");
}

const fast::IntersectMethod& find_intersect(const std::string& name) {
  return find(fast::intersect_methods(), name, "--intersect");
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
