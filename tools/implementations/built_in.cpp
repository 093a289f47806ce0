#include "tools/implementations/built_in.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "properties/candidates/fast_candidate.h"
#include "properties/candidates/reference_methods.h"
#include "scene/invalid_input.h"
#include "scene/text.h"

namespace raycheck::tools {
namespace {

using properties::Stage;

template <class Methods>
auto& find(const Methods& methods, const std::string& name, const char* field) {
  const auto name_of = [](const auto* method) { return method->name; };
  const auto found = std::ranges::find(methods, name, name_of);
  if (found != methods.end()) return **found;
  throw scene::InvalidInput(
      field, name, "no such method; the methods are " + scene::joined(methods, ", ", name_of));
}

ReadyCalls<properties::SphereHits> ready_calls(const fast::IntersectMethod& method,
                                               const std::vector<IntersectCall>& given) {
  struct Call {
    IntersectCall asked;
    fast::Rays batch;
  };
  struct Result {
    std::optional<fast::Hit> one;
    fast::Hits many;
  };
  const auto calls = std::make_shared<std::vector<Call>>();
  for (const IntersectCall& call : given) {
    calls->push_back({call, properties::batch_of(call.rays)});
  }
  return ready<properties::SphereHits, Result>(
      [&method, calls](std::size_t k, Result& result) {
        const auto& [asked, batch] = (*calls)[k];
        const auto& [rays, sphere, conventions] = asked;
        if (rays.size() == 1) {
          result.one = method.intersect_one(rays.front(), sphere, conventions.hit_rule());
        } else {
          method.intersect(batch, sphere, conventions.hit_rule(), result.many);
        }
      },
      [](std::size_t /*k*/, const Result& result) {
        if (!result.one) return properties::list_of(result.many);
        return properties::SphereHits{{0, {result.one->parameter, result.one->point}}};
      });
}

ReadyCalls<std::vector<scene::Ray>> ready_calls(const fast::PixelRayMethod& method,
                                                const std::vector<RaysCall>& given) {
  const auto calls = std::make_shared<const std::vector<RaysCall>>(given);
  return ready<std::vector<scene::Ray>, fast::Rays>(
      [&method, calls](std::size_t k, fast::Rays& rays) {
        const auto& [camera, conventions, pixels] = (*calls)[k];
        const bool from_pixel =
            conventions.origin == scene::Origin::kPixel && method.pixel_rays != nullptr;
        (from_pixel ? method.pixel_rays : method.focal_rays)(camera, conventions, pixels, rays);
      },
      [](std::size_t /*k*/, const fast::Rays& rays) { return properties::rays_of(rays); });
}

/// Each method as a candidate only for its stage; ray methods first.
std::vector<Implementation> each_alone() {
  std::vector<Implementation> all;
  const auto add = [&all](const MethodPair& pair, Stage stage, std::string_view name,
                          std::size_t number) {
    Implementation one = built_in(pair);
    one.name = one.lasting_name = name;
    one.stages = {stage};
    one.number = number;
    all.push_back(std::move(one));
  };
  for (const auto* method : fast::pixel_ray_methods()) {
    add({method, kDefaultMethods.intersect}, Stage::kRays, method->name, all.size());
  }
  const std::size_t rays = all.size();
  for (const auto* method : all_intersect_methods()) {
    add({kDefaultMethods.rays, method}, Stage::kIntersection, method->name, all.size() - rays);
  }
  return all;
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
  for (const auto& methods : {fast::intersect_methods(), properties::exact_methods()}) {
    all.insert(all.end(), methods.begin(), methods.end());
  }
  return all;
}

properties::Candidate candidate_of(const MethodPair& pair) {
  return properties::fast_candidate(*pair.rays, *pair.intersect);
}

Implementation built_in(const MethodPair& pair) {
  return {.name = candidate_of(pair).name,
          .stages = {Stage::kRays, Stage::kIntersection},
          .methods = pair,
          .make = [pair] { return candidate_of(pair); },
          .in_process =
              [pair] {
                return InProcess{
                    [pair](const auto& calls) { return ready_calls(*pair.intersect, calls); },
                    [pair](const auto& calls) { return ready_calls(*pair.rays, calls); }};
              }};
}

std::vector<Implementation> built_in(const std::vector<MethodPair>& pairs) {
  std::vector<Implementation> all;
  for (const MethodPair& pair : pairs) all.push_back(built_in(pair));
  return all;
}

std::vector<Implementation> find_methods(const std::vector<std::string>& names) {
  std::vector<Implementation> all = each_alone();
  constexpr const char* kAll = "all";
  if (std::ranges::find(names, kAll) != names.end()) {
    if (names.size() == 1) return all;
    throw scene::InvalidInput("method", kAll, "already means every method; leave out the others");
  }
  if (names.empty()) {
    std::erase_if(all, [](const Implementation& method) {
      const auto fast = fast::intersect_methods();
      return method.offers(Stage::kIntersection) &&
             std::ranges::find(fast, method.methods->intersect) == fast.end();
    });
    return all;
  }
  const auto is_called = [](const Implementation& method, const std::string& name) {
    const char* const kind = method.offers(Stage::kRays) ? "rays/" : "intersect/";
    return name == method.name || name == kind + method.name;
  };
  for (const std::string& name : names) {
    if (std::ranges::none_of(
            all, [&](const Implementation& method) { return is_called(method, name); })) {
      const auto names_that_offer = [&](Stage stage) {
        std::vector<Implementation> offering = all;
        std::erase_if(offering, [&](const Implementation& one) { return !one.offers(stage); });
        return scene::joined(offering, ", ", &Implementation::name);
      };
      throw scene::InvalidInput(
          "method", name,
          "no such method; for rays: " + names_that_offer(Stage::kRays) +
              "; for intersections: " + names_that_offer(Stage::kIntersection));
    }
  }
  std::erase_if(all, [&](const Implementation& method) {
    return std::ranges::none_of(names,
                                [&](const std::string& name) { return is_called(method, name); });
  });
  return all;
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
