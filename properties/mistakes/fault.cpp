#include "properties/mistakes/fault.h"

#include <algorithm>
#include <cmath>

#include "properties/case.h"
#include "properties/mistakes/mistake_list.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

const Candidate& right() {
  static const Candidate kRight = right_candidate();
  return kRight;
}

/// Whether these numbers are a ray. If a direction is 0 or a number is NaN, it meets nothing.
bool is_ray(const Ray& ray) {
  const auto& [x, y, z] = ray.direction;
  const double sum = ray.origin.x + ray.origin.y + ray.origin.z + x + y + z;
  return std::isfinite(sum) && (x != 0 || y != 0 || z != 0);
}

constexpr const char* kAnd = "; and ";
constexpr const char* kOr = ", or: ";

void add(const std::string& part, const char* between, std::string& text) {
  text += (text.empty() ? "" : between) + part;
}

std::string in_brackets(const std::string& part) { return "(" + part + ")"; }

/// The distinct mistakes at each place of several faults.
std::vector<std::vector<const Mistake*>> all_at(const std::vector<Fault>& faults) {
  std::vector<std::vector<const Mistake*>> at(faults.front().size());
  for (const Fault& fault : faults) {
    for (std::size_t k = 0; k < std::min(at.size(), fault.size()); ++k) {
      const bool is_known = std::find(at[k].begin(), at[k].end(), fault[k]) != at[k].end();
      if (!is_known) at[k].push_back(fault[k]);
    }
  }
  return at;
}

/// Whether these distinct faults are all combinations of one mistake from each place.
bool are_all_pairs(const std::vector<std::vector<const Mistake*>>& at,
                   const std::vector<Fault>& faults) {
  std::size_t pairs = 1;
  for (const auto& its : at) pairs *= its.size();
  return pairs == faults.size() && std::all_of(faults.begin(), faults.end(), [&](const Fault& one) {
           return one.size() == at.size();
         });
}

}  // namespace

std::string sentence_of(const Fault& fault) {
  std::string sentence;
  for (const Mistake* mistake : fault) add(mistake->sentence, kAnd, sentence);
  return sentence;
}

std::vector<const Mistake*> mistakes_at(std::size_t place, const std::vector<Fault>& alternatives) {
  const auto at = all_at(alternatives);
  return are_all_pairs(at, alternatives) ? at.at(place)
                                         : std::vector{alternatives.front().at(place)};
}

std::vector<std::string> sentences_of(const std::vector<Fault>& alternatives) {
  const auto at = all_at(alternatives);
  std::vector<std::string> all;
  if (!are_all_pairs(at, alternatives)) {
    std::string any;
    for (const Fault& fault : alternatives) {
      add(fault.size() > 1 ? in_brackets(sentence_of(fault)) : sentence_of(fault), kOr, any);
    }
    return {any};
  }
  for (const std::vector<const Mistake*>& part : at) {
    for (const Mistake* mistake : part) {
      add(mistake->sentence, kOr, mistake == part.front() ? all.emplace_back() : all.back());
    }
  }
  return all;
}

std::string sentence_of(const std::vector<Fault>& alternatives) {
  const std::vector<std::string> parts = sentences_of(alternatives);
  std::string sentence;
  for (const std::string& its : parts) {
    const bool is_choice = parts.size() > 1 && its.find(kOr) != std::string::npos;
    add(is_choice ? in_brackets(its) : its, kAnd, sentence);
  }
  return sentence;
}

bool can_be_together(const Mistake& a, const Mistake& b) {
  return !(a.makes_rays() && b.makes_rays()) && !(a.places_pixels && b.places_pixels) &&
         joined(a.hits, b.hits);
}

FaultyView::FaultyView(const Fault& fault, const Scene& scene)
    : asked_(scene), taken_(scene), rays_(&right()) {
  HitFormulas hits;
  for (const Mistake* mistake : in_order(fault)) {
    taken_ = mistaken(*mistake, std::move(taken_));
    if (mistake->pixel) pixels_.push_back(mistake);
    if (mistake->makes_rays()) rays_ = &mistake->candidate;
    hits = joined(std::move(hits), mistake->hits).value();
  }
  nearest_ = hits ? nearest_by(std::move(hits)) : right().nearest;
}

std::vector<std::optional<Ray>> FaultyView::rays(std::span<const Pixel> pixels) const {
  const Camera& camera = *asked_.camera;
  std::vector<std::optional<Ray>> found(pixels.size());
  std::vector<Pixel> asked(pixels.begin(), pixels.end());
  std::vector<bool> is_black(asked.size());
  for (const Mistake* mistake : pixels_) {
    for (std::size_t k = 0; k < asked.size(); ++k) {
      Pixel& one = asked[k];
      one = mistake->pixel(camera, asked_.conventions, one);
      const bool is_inside =
          one.i >= 0 && one.j >= 0 && one.i < camera.width && one.j < camera.height;
      if (mistake->black_outside && !is_inside) is_black[k] = true;
    }
  }
  try {
    const std::vector<Ray> made =
        rays_->rays_from(taken_.conventions.origin)(*taken_.camera, taken_.conventions, asked);
    for (std::size_t k = 0; k < made.size(); ++k) {
      if (!is_black[k] && is_ray(made[k])) found[k] = made[k];
    }
  } catch (const NoAnswer&) {
    return found;
  }
  return found;
}

ImageAnswer FaultyView::seen(std::span<const Pixel> pixels, double growth) const {
  ImageAnswer answer(pixels.size());
  std::vector<std::size_t> indices;
  std::vector<Ray> valid;
  const auto all = rays(pixels);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!all[k]) continue;
    indices.push_back(k);
    valid.push_back(*all[k]);
  }
  std::vector<Sphere> spheres = taken_.spheres;
  const Point3& eye = taken_.camera->eye;
  for (Sphere& sphere : spheres) {
    if (growth == 0) break;
    const double reach = norm(sphere.centre - eye) + sphere.radius;
    sphere.radius = std::fmax(0, sphere.radius + growth * reach);
  }
  const auto nearest = nearest_(valid, spheres, taken_.conventions);
  for (std::size_t k = 0; k < nearest.size(); ++k) answer[indices[k]] = nearest[k];
  return answer;
}

ImageAnswer predicted(const Fault& fault, const Scene& scene) {
  return FaultyView(fault, scene).seen(all_pixels(*scene.camera));
}

}  // namespace raycheck::properties
