#include <dlfcn.h>
#include <raycheck/candidate.h>

#include <memory>

#include "contract/declarations.h"
#include "contract/public_structs.h"
#include "properties/interfaces.h"
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

raycheck_asked asked(const scene::Conventions& c) {
  return {contract::conventions<raycheck_conventions>(c),
          contract::valid_roots<raycheck_valid_roots>(c.valid)};
}

ReadyCalls<properties::SphereHits> ready_calls(const raycheck_candidate& library,
                                               const contract::Interface& interface,
                                               const std::vector<IntersectCall>& given) {
  struct Call {
    std::vector<raycheck_ray> rays;
    raycheck_sphere sphere;
    raycheck_asked asked;
  };
  using Hits = std::vector<raycheck_hit>;
  const auto calls = std::make_shared<std::vector<Call>>();
  for (const IntersectCall& call : given) {
    const scene::Sphere sphere = properties::passed(call.sphere, interface);
    calls->push_back({{}, contract::sphere<raycheck_sphere>(sphere), asked(call.conventions)});
    for (const scene::Ray& ray : call.rays) {
      calls->back().rays.push_back(contract::ray<raycheck_ray>(properties::passed(ray, interface)));
    }
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
      [given, interface](std::size_t k, const Hits& hits) {
        properties::SphereHits list;
        for (std::size_t ray = 0; ray < hits.size(); ++ray) {
          const auto& [hit, parameter, point] = hits[ray];
          if (hit == 0) continue;
          list.push_back(
              {ray, properties::completed({parameter, contract::triple<scene::Point3>(point)},
                                          interface.returns, given[k].rays[ray], given[k].sphere)});
        }
        return list;
      });
}

ReadyCalls<std::vector<scene::Ray>> ready_calls(const raycheck_candidate& library,
                                                const contract::Interface& interface,
                                                scene::Precision precision,
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
                      contract::camera<raycheck_camera>(call.camera),
                      asked(call.conventions),
                      {}});
    for (const scene::Pixel& pixel : call.pixels) {
      calls->back().pixels.push_back(
          contract::pixel<raycheck_pixel>(properties::passed(pixel, interface)));
    }
  }
  return ready<std::vector<scene::Ray>, Rays>(
      [calls](std::size_t k, Rays& rays) {
        const auto& [make, camera, asked, pixels] = (*calls)[k];
        rays.clear();
        for (const raycheck_pixel& pixel : pixels) {
          rays.push_back(make(&camera, &asked.conventions, pixel));
        }
      },
      [interface, precision](std::size_t /*k*/, const Rays& rays) {
        std::vector<scene::Ray> all;
        for (const raycheck_ray& ray : rays) {
          all.push_back(properties::made(contract::ray<scene::Ray>(ray), interface, precision));
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
  const contract::Interface interface = external.introduction.declared.interface;
  InProcess calls;
  if (library.intersect != nullptr || library.intersect_batch != nullptr) {
    calls.intersect = [&library, interface](const std::vector<IntersectCall>& given) {
      return ready_calls(library, interface, given);
    };
  }
  if (library.pixel_ray != nullptr || library.focal_ray != nullptr) {
    calls.make_rays = [&library, interface, precision = external.precision](const auto& given) {
      return ready_calls(library, interface, precision, given);
    };
  }
  return calls;
}

}  // namespace raycheck::tools
