#include "tools/tradeoff/tradeoff_others.h"

#include <fmt/core.h>

#include <memory>
#include <stdexcept>

#include "scene/interruption.h"
#include "tools/external/in_process.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;

constexpr const char* kDiffers =
    "not timed: it answers otherwise in raycheck's own process than in one of its own";

/// Why a stopwatch in raycheck's own process has nothing to call; empty: it has.
std::string why_not_called(const OtherMethod& other) {
  if (other.is_kept) {
    return "not timed: it is kept in a sandbox, and only calls in raycheck's own process are timed "
           "fairly";
  }
  if (other.library.empty()) {
    return "not timed: it is no library, and only calls in raycheck's own process are timed fairly";
  }
  return {};
}

/// Rays that meet one sphere, as a library takes them.
struct Asked {
  std::vector<raycheck_ray> rays;
  raycheck_sphere sphere;
  raycheck_conventions conventions;
};

scene::Conventions conventions_of(const Candidate& candidate, scene::Root root,
                                  scene::Tangent tangent) {
  scene::Conventions conventions;
  conventions.root = root;
  conventions.tangent = tangent;
  return candidate.declared.over(conventions);
}

bool is_same(const raycheck_vector& got, const scene::Point3& judged) {
  return same_bits(got.x, judged.x) && same_bits(got.y, judged.y) && same_bits(got.z, judged.z);
}

void answer(const raycheck_candidate& library, const Asked& asked,
            std::vector<raycheck_hit>& hits) {
  if (library.intersect_batch != nullptr) {
    library.intersect_batch(asked.rays.data(), asked.rays.size(), &asked.sphere, &asked.conventions,
                            hits.data());
    return;
  }
  for (std::size_t k = 0; k < hits.size(); ++k) {
    hits[k] = library.intersect(&asked.rays[k], &asked.sphere, &asked.conventions);
  }
}

/// Whether the library answers as it was judged.
bool answers_alike(const raycheck_candidate& library, const Candidate& judged, const Asked& asked,
                   const std::vector<scene::Ray>& rays, const scene::Sphere& sphere,
                   const scene::Conventions& conventions) {
  scene::poll();
  // The process of its own goes first: what ends it is not called here.
  const auto expected = judged.intersect(rays, {&sphere, 1}, conventions).at(0);
  std::vector<raycheck_hit> hits(rays.size());
  answer(library, asked, hits);
  auto next = expected.begin();
  for (std::size_t k = 0; k < hits.size(); ++k) {
    const bool is_hit = next != expected.end() && next->ray == k;
    if (is_hit != (hits[k].hit != 0)) return false;
    if (!is_hit) continue;
    if (!same_bits(hits[k].parameter, next->hit.parameter)) return false;
    if (!is_same(hits[k].point, next->hit.point)) return false;
    ++next;
  }
  return true;
}

/// Whether it answers all of them as it was judged. Batches first, which find most of what fails.
template <class Items, class Alike>
bool all_alike(const Items& items, const Alike& alike) {
  for (const auto& item : items) {
    if (!alike(item)) return false;
  }
  return true;
}

}  // namespace

OthersTimed others_intersections(const OtherMethod& other, const Candidate& judged,
                                 const std::vector<Pair>& pairs,
                                 const std::vector<Batch>& batches) {
  if (std::string why = why_not_called(other); !why.empty()) return {{}, {}, std::move(why)};
  try {
    const auto asked_of = [&](const Batch& batch) {
      std::vector<scene::Ray> rays;
      for (std::size_t k = 0; k < batch.rays.size(); ++k) rays.push_back(ray_at(batch.rays, k));
      return rays;
    };
    const auto items = std::make_shared<std::vector<Asked>>();
    const auto singles = std::make_shared<std::vector<Asked>>();
    const raycheck_candidate& library = functions_in_process(other.library);
    const auto add = [&](std::vector<Asked>& list, const std::vector<scene::Ray>& rays,
                         const scene::Sphere& sphere, const scene::Conventions& conventions) {
      Asked asked{{}, to_c(sphere), to_c(conventions)};
      for (const scene::Ray& ray : rays) asked.rays.push_back(to_c(ray));
      list.push_back(std::move(asked));
      return answers_alike(library, judged, list.back(), rays, sphere, conventions);
    };
    const bool alike = all_alike(batches,
                                 [&](const Batch& batch) {
                                   return add(*items, asked_of(batch), batch.sphere,
                                              conventions_of(judged, batch.root, batch.tangent));
                                 }) &&
                       all_alike(pairs, [&](const Pair& pair) {
                         return add(*singles, {pair.ray}, pair.sphere,
                                    conventions_of(judged, pair.root, pair.tangent));
                       });
    if (!alike) return {{}, {}, kDiffers};
    OthersTimed timed;
    const std::size_t most = batches.empty() ? 0 : batches.front().rays.size();
    timed.batch = {
        [&library, items, hits = std::vector<raycheck_hit>(most)](std::size_t count) mutable {
          for (std::size_t k = 0; k < count; ++k) {
            hits.resize((*items)[k].rays.size());
            answer(library, (*items)[k], hits);
            keep(hits);
          }
        },
        items->size()};
    timed.single = {[&library, singles](std::size_t count) {
                      raycheck_hit hit;
                      for (std::size_t k = 0; k < count; ++k) {
                        const Asked& asked = (*singles)[k];
                        if (library.intersect != nullptr) {
                          hit = library.intersect(asked.rays.data(), &asked.sphere,
                                                  &asked.conventions);
                        } else {
                          library.intersect_batch(asked.rays.data(), 1, &asked.sphere,
                                                  &asked.conventions, &hit);
                        }
                        keep(hit);
                      }
                    },
                    singles->size()};
    return timed;
  } catch (const std::runtime_error& error) {
    return {{}, {}, fmt::format("not timed: {}", error.what())};
  } catch (const std::invalid_argument& error) {
    return {{}, {}, fmt::format("not timed: {}", error.what())};
  }
}

OthersTimed others_rays(const OtherMethod& other, const Candidate& judged,
                        const std::vector<PixelBatch>& singles,
                        const std::vector<PixelBatch>& batches) {
  if (std::string why = why_not_called(other); !why.empty()) return {{}, {}, std::move(why)};
  try {
    using Make =
        raycheck_ray (*)(const raycheck_camera*, const raycheck_conventions*, raycheck_pixel);
    struct Item {
      Make make;
      raycheck_camera camera;
      raycheck_conventions conventions;
      std::vector<raycheck_pixel> pixels;
    };
    const raycheck_candidate& library = functions_in_process(other.library);
    if (library.pixel_ray == nullptr && library.focal_ray == nullptr) {
      return {{}, {}, "not timed: it makes no rays"};
    }
    const auto prepare = [&](const std::vector<PixelBatch>& list, std::vector<Item>& items) {
      return all_alike(list, [&](const PixelBatch& batch) {
        scene::poll();
        scene::Conventions conventions = judged.declared.over(batch.conventions);
        const bool from_pixel =
            library.focal_ray == nullptr ||
            (conventions.origin == scene::Origin::kPixel && library.pixel_ray != nullptr);
        Item item{from_pixel ? library.pixel_ray : library.focal_ray,
                  to_c(batch.camera),
                  to_c(conventions),
                  {}};
        for (const scene::Pixel& pixel : batch.pixels) item.pixels.push_back({pixel.i, pixel.j});
        const auto& make = from_pixel ? judged.pixel_rays : judged.focal_rays;
        const auto expected = make(batch.camera, conventions, batch.pixels);
        for (std::size_t k = 0; k < expected.size(); ++k) {
          const raycheck_ray ray = item.make(&item.camera, &item.conventions, item.pixels[k]);
          const scene::Vector3& d = expected[k].direction;
          if (!is_same(ray.origin, expected[k].origin)) return false;
          if (!is_same(ray.direction, {d.x, d.y, d.z})) return false;
        }
        items.push_back(std::move(item));
        return true;
      });
    };
    const auto timed_of = [](std::vector<Item> items) {
      const auto shared = std::make_shared<const std::vector<Item>>(std::move(items));
      return Timed{[shared](std::size_t count) {
                     for (std::size_t at = 0; at < count; ++at) {
                       const Item& item = (*shared)[at];
                       for (const raycheck_pixel& pixel : item.pixels) {
                         keep(item.make(&item.camera, &item.conventions, pixel));
                       }
                     }
                   },
                   shared->size()};
    };
    std::vector<Item> many;
    std::vector<Item> one;
    if (!prepare(batches, many) || !prepare(singles, one)) return {{}, {}, kDiffers};
    return {timed_of(std::move(one)), timed_of(std::move(many)), {}};
  } catch (const std::runtime_error& error) {
    return {{}, {}, fmt::format("not timed: {}", error.what())};
  } catch (const std::invalid_argument& error) {
    return {{}, {}, fmt::format("not timed: {}", error.what())};
  }
}

}  // namespace raycheck::tools
