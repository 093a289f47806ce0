#include <dlfcn.h>
#include <raycheck/candidate.h>

#include <memory>

#include "tools/external/candidate_spec.h"
#include "tools/external/external_candidate.h"

namespace raycheck::tools {
namespace {

const raycheck_candidate* functions_of(const std::string& library) {
  void* const loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (loaded == nullptr) throw CandidateError(dlerror());
  using Functions = const raycheck_candidate* (*)();
  const auto functions = reinterpret_cast<Functions>(dlsym(loaded, "raycheck_candidate_functions"));
  const raycheck_candidate* const found = functions == nullptr ? nullptr : functions();
  if (found == nullptr) throw CandidateError("the library has no raycheck_candidate_functions()");
  return found;
}

raycheck_vector to_c(const scene::Point3& point) { return {point.x, point.y, point.z}; }
raycheck_vector to_c(const scene::Vector3& vector) { return {vector.x, vector.y, vector.z}; }
raycheck_ray to_c(const scene::Ray& ray) { return {to_c(ray.origin), to_c(ray.direction)}; }
raycheck_sphere to_c(const scene::Sphere& sphere) { return {to_c(sphere.centre), sphere.radius}; }

raycheck_camera to_c(const scene::Camera& c) {
  return {to_c(c.eye), to_c(c.look_at), to_c(c.up), c.near,  c.left,
          c.right,     c.bottom,        c.top,      c.width, c.height};
}

/// The enumerators in candidate.h have the same values as raycheck's; those of conventions are
/// larger by one, because of AS_ASKED.
template <class Enum>
std::int32_t enumerator(Enum value) {
  return static_cast<std::int32_t>(value);
}

raycheck_asked to_c(const scene::Conventions& c) {
  const scene::ValidRoots& valid = c.valid;
  return {{1 + enumerator(c.rows), 1 + enumerator(c.samples), 1 + enumerator(c.origin),
           1 + enumerator(c.root), 1 + enumerator(c.tangent)},
          {valid.t_min, valid.t_max, enumerator(valid.ends), enumerator(valid.unit),
           enumerator(valid.culling)}};
}

scene::Point3 point_of(const raycheck_vector& v) { return {v.x, v.y, v.z}; }

ReadyCalls<properties::SphereHits> ready_calls(const raycheck_candidate& library,
                                               const std::vector<IntersectCall>& given) {
  struct Call {
    std::vector<raycheck_ray> rays;
    raycheck_sphere sphere;
    raycheck_asked asked;
  };
  using Hits = std::vector<raycheck_hit>;
  const auto calls = std::make_shared<std::vector<Call>>();
  for (const IntersectCall& call : given) {
    calls->push_back({{}, to_c(call.sphere), to_c(call.conventions)});
    for (const scene::Ray& ray : call.rays) calls->back().rays.push_back(to_c(ray));
  }
  return ready<properties::SphereHits, Hits>(
      [&library, calls](std::size_t k, Hits& hits) {
        const auto& [rays, sphere, asked] = (*calls)[k];
        hits.resize(rays.size());
        if (library.intersect_batch != nullptr &&
            (rays.size() != 1 || library.intersect == nullptr)) {
          library.intersect_batch(rays.data(), rays.size(), &sphere, &asked.conventions,
                                  hits.data());
          return;
        }
        for (std::size_t ray = 0; ray < hits.size(); ++ray) {
          hits[ray] = library.intersect(&rays[ray], &sphere, &asked.conventions);
        }
      },
      [](const Hits& hits) {
        properties::SphereHits list;
        for (std::size_t ray = 0; ray < hits.size(); ++ray) {
          if (hits[ray].hit == 0) continue;
          list.push_back({ray, {hits[ray].parameter, point_of(hits[ray].point)}});
        }
        return list;
      });
}

ReadyCalls<std::vector<scene::Ray>> ready_calls(const raycheck_candidate& library,
                                                const std::vector<RaysCall>& given) {
  struct Call {
    decltype(library.pixel_ray) make;
    raycheck_camera camera;
    raycheck_asked asked;
    std::vector<raycheck_pixel> pixels;
  };
  using Rays = std::vector<raycheck_ray>;
  const auto calls = std::make_shared<std::vector<Call>>();
  for (const RaysCall& call : given) {
    const bool from_pixel =
        library.focal_ray == nullptr ||
        (call.conventions.origin == scene::Origin::kPixel && library.pixel_ray != nullptr);
    calls->push_back({from_pixel ? library.pixel_ray : library.focal_ray,
                      to_c(call.camera),
                      to_c(call.conventions),
                      {}});
    for (const auto& [i, j] : call.pixels) calls->back().pixels.push_back({i, j});
  }
  return ready<std::vector<scene::Ray>, Rays>(
      [calls](std::size_t k, Rays& rays) {
        const auto& [make, camera, asked, pixels] = (*calls)[k];
        rays.clear();
        for (const raycheck_pixel& pixel : pixels) {
          rays.push_back(make(&camera, &asked.conventions, pixel));
        }
      },
      [](const Rays& rays) {
        std::vector<scene::Ray> all;
        for (const raycheck_ray& ray : rays) {
          all.push_back({point_of(ray.origin), point_of(ray.direction) - scene::Point3{}});
        }
        return all;
      });
}

}  // namespace

InProcess calls_in_process(const External& external) {
  const Layers& layers = external.program.layers;
  if (layers.own_user || layers.seccomp || layers.landlock || layers.bubblewrap) {
    throw CandidateError(
        "it runs in a sandbox; choose sandbox none to time it in raycheck's process");
  }
  if (external.library.empty()) {
    throw CandidateError("it is not a library, and raycheck times only calls in its own process");
  }
  const raycheck_candidate& library = *functions_of(external.library);
  InProcess calls;
  if (library.intersect != nullptr || library.intersect_batch != nullptr) {
    calls.intersect = [&library, returns = external.introduction.returns](
                          const std::vector<IntersectCall>& given) {
      ReadyCalls<properties::SphereHits> ready = ready_calls(library, given);
      if (returns == properties::Returns::kHit) return ready;
      ready.answer = [answer = std::move(ready.answer), given, returns](std::size_t k) {
        properties::SphereHits hits = answer(k);
        for (auto& [ray, hit] : hits) {
          hit = properties::completed(hit, returns, given[k].rays[ray], given[k].sphere);
        }
        return hits;
      };
      return ready;
    };
  }
  if (library.pixel_ray != nullptr || library.focal_ray != nullptr) {
    calls.make_rays = [&library](const auto& given) { return ready_calls(library, given); };
  }
  return calls;
}

}  // namespace raycheck::tools
