#include "tools/external/in_process.h"

#include <dlfcn.h>
#include <raycheck/candidate.h>

#include <memory>

#include "tools/external/candidate_spec.h"

namespace raycheck::tools {
namespace {

const raycheck_candidate& functions_of(const std::string& library) {
  void* const loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (loaded == nullptr) throw CandidateError(dlerror());
  using Functions = const raycheck_candidate* (*)();
  const auto functions = reinterpret_cast<Functions>(dlsym(loaded, "raycheck_candidate_functions"));
  const raycheck_candidate* const found = functions == nullptr ? nullptr : functions();
  if (found == nullptr) throw CandidateError("the library has no raycheck_candidate_functions()");
  return *found;
}

raycheck_vector to_c(const scene::Point3& point) { return {point.x, point.y, point.z}; }
raycheck_vector to_c(const scene::Vector3& vector) { return {vector.x, vector.y, vector.z}; }
raycheck_ray to_c(const scene::Ray& ray) { return {to_c(ray.origin), to_c(ray.direction)}; }
raycheck_sphere to_c(const scene::Sphere& sphere) { return {to_c(sphere.centre), sphere.radius}; }

raycheck_camera to_c(const scene::Camera& c) {
  return {to_c(c.eye), to_c(c.look_at), to_c(c.up), c.near,  c.left,
          c.right,     c.bottom,        c.top,      c.width, c.height};
}

raycheck_asked to_c(const scene::Conventions& c) {
  using namespace scene;  // NOLINT(google-build-using-namespace)
  return {{c.rows == Rows::kBottomFirst ? RAYCHECK_ROWS_BOTTOM_FIRST : RAYCHECK_ROWS_TOP_FIRST,
           c.samples == Samples::kEdges ? RAYCHECK_SAMPLES_EDGES : RAYCHECK_SAMPLES_CENTRES,
           c.origin == Origin::kPixel ? RAYCHECK_ORIGIN_PIXEL : RAYCHECK_ORIGIN_FOCAL,
           c.root == Root::kNearest ? RAYCHECK_ROOT_NEAREST : RAYCHECK_ROOT_SMALLER,
           c.tangent == Tangent::kHit    ? RAYCHECK_TANGENT_HIT
           : c.tangent == Tangent::kMiss ? RAYCHECK_TANGENT_MISS
                                         : RAYCHECK_TANGENT_EITHER},
          {c.valid.t_min, c.valid.t_max, static_cast<std::int32_t>(c.valid.ends),
           static_cast<std::int32_t>(c.valid.unit), static_cast<std::int32_t>(c.valid.culling)}};
}

scene::Point3 point_of(const raycheck_vector& v) { return {v.x, v.y, v.z}; }

/// A call about rays and a sphere as the library takes it.
struct HitsAsked {
  std::vector<raycheck_ray> rays;
  raycheck_sphere sphere;
  raycheck_asked asked;
};

void answer(const raycheck_candidate& library, const HitsAsked& call,
            std::vector<raycheck_hit>& hits) {
  const bool in_one_call =
      library.intersect_batch != nullptr && (call.rays.size() != 1 || library.intersect == nullptr);
  hits.resize(call.rays.size());
  if (in_one_call) {
    library.intersect_batch(call.rays.data(), call.rays.size(), &call.sphere,
                            &call.asked.conventions, hits.data());
    return;
  }
  for (std::size_t k = 0; k < hits.size(); ++k) {
    hits[k] = library.intersect(&call.rays[k], &call.sphere, &call.asked.conventions);
  }
}

ReadyCalls<properties::SphereHits> ready_calls(const raycheck_candidate& library,
                                               const std::vector<IntersectCall>& given) {
  const auto calls = std::make_shared<std::vector<HitsAsked>>();
  for (const IntersectCall& call : given) {
    calls->push_back({{}, to_c(call.sphere), to_c(call.conventions)});
    for (const scene::Ray& ray : call.rays) calls->back().rays.push_back(to_c(ray));
  }
  return {[&library, calls, hits = std::vector<raycheck_hit>{}](std::size_t count) mutable {
            for (std::size_t k = 0; k < count; ++k) {
              answer(library, (*calls)[k], hits);
              keep(hits);
            }
          },
          [&library, calls](std::size_t k) {
            std::vector<raycheck_hit> hits;
            answer(library, (*calls)[k], hits);
            properties::SphereHits list;
            for (std::size_t ray = 0; ray < hits.size(); ++ray) {
              if (hits[ray].hit == 0) continue;
              list.push_back({ray, {hits[ray].parameter, point_of(hits[ray].point)}});
            }
            return list;
          }};
}

ReadyCalls<std::vector<scene::Ray>> ready_calls(const raycheck_candidate& library,
                                                const std::vector<RaysCall>& given) {
  struct RaysAsked {
    decltype(library.pixel_ray) make;
    raycheck_camera camera;
    raycheck_asked asked;
    std::vector<raycheck_pixel> pixels;
  };
  const auto calls = std::make_shared<std::vector<RaysAsked>>();
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
  return {[calls](std::size_t count) {
            for (std::size_t k = 0; k < count; ++k) {
              const RaysAsked& call = (*calls)[k];
              for (const raycheck_pixel& pixel : call.pixels) {
                keep(call.make(&call.camera, &call.asked.conventions, pixel));
              }
            }
          },
          [calls](std::size_t k) {
            const RaysAsked& call = (*calls)[k];
            std::vector<scene::Ray> rays;
            for (const raycheck_pixel& pixel : call.pixels) {
              const raycheck_ray ray = call.make(&call.camera, &call.asked.conventions, pixel);
              rays.push_back({point_of(ray.origin), point_of(ray.direction) - scene::Point3{}});
            }
            return rays;
          }};
}

}  // namespace

InProcess calls_in_process(const External& external) {
  const Layers& layers = external.program.layers;
  if (layers.own_user || layers.seccomp || layers.landlock || layers.bubblewrap) {
    throw CandidateError(
        "it is kept in a sandbox, and only calls in raycheck's own process are timed fairly");
  }
  if (external.library.empty()) {
    throw CandidateError(
        "it is no library, and only calls in raycheck's own process are timed fairly");
  }
  const raycheck_candidate& library = functions_of(external.library);
  InProcess calls;
  if (library.intersect != nullptr || library.intersect_batch != nullptr) {
    calls.intersect = [&library](const auto& given) { return ready_calls(library, given); };
  }
  if (library.pixel_ray != nullptr || library.focal_ray != nullptr) {
    calls.make_rays = [&library](const auto& given) { return ready_calls(library, given); };
  }
  return calls;
}

}  // namespace raycheck::tools
