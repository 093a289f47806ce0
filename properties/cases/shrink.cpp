#include "properties/cases/shrink.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "scene/fields.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

int significant_bits(double value) {
  int bits = 0;
  int exponent = 0;
  for (double rest = std::frexp(std::abs(value), &exponent); rest != 0; ++bits) {
    rest *= 2;
    rest -= std::floor(rest);
  }
  return bits;
}

double rounded_to_bits(double value, int bits) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return std::ldexp(std::round(std::ldexp(fraction, bits)), exponent - bits);
}

bool is_valid(const Case& the_case) {
  if (!scene::defects(the_case.scene).empty()) return false;
  if (!the_case.scene.camera) return true;
  const scene::Camera& camera = *the_case.scene.camera;
  return std::all_of(the_case.pixels.begin(), the_case.pixels.end(), [&](const scene::Pixel& p) {
    return p.i < camera.width && p.j < camera.height;
  });
}

/// Spheres of radius 0. Having one does not make a case simpler: they are harder to picture.
std::ptrdiff_t count_points(const scene::Scene& scene) {
  return std::count_if(scene.spheres.begin(), scene.spheres.end(),
                       [](const scene::Sphere& sphere) { return sphere.radius == 0; });
}

/// One case for each element left out, as long as `keep` remain.
template <class Member>
void leave_one_out(const Case& the_case, Member member, std::size_t keep, std::vector<Case>& out) {
  const std::size_t count = member(the_case).size();
  for (std::size_t k = 0; k < count && count > keep; ++k) {
    Case fewer = the_case;
    auto& list = member(fewer);
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(k));
    out.push_back(std::move(fewer));
  }
}

template <class Convention>
void reset(const Case& the_case, Convention scene::Conventions::*member, std::vector<Case>& out) {
  Case plain = the_case;
  plain.scene.conventions.*member = scene::Conventions{}.*member;
  if (!(plain.scene.conventions == the_case.scene.conventions)) out.push_back(std::move(plain));
}

/// 2, then counts that approach `count`: halving finds the smallest that will do.
std::vector<std::int64_t> smaller_counts(std::int64_t count) {
  std::vector<std::int64_t> result = {2};
  for (std::int64_t step = count / 2; step > 0; step /= 2) result.push_back(count - step);
  std::erase_if(result, [count](std::int64_t smaller) { return smaller >= count; });
  return result;
}

void shrink_image(const Case& the_case, std::vector<Case>& out) {
  const scene::Camera& camera = *the_case.scene.camera;
  for (const bool across : {true, false}) {
    const std::int64_t count = across ? camera.width : camera.height;
    for (const std::int64_t smaller : smaller_counts(count)) {
      // Pixels keep their position in the image, or their indices where these still exist.
      for (const bool in_proportion : {true, false}) {
        Case less = the_case;
        (across ? less.scene.camera->width : less.scene.camera->height) = smaller;
        for (scene::Pixel& pixel : less.pixels) {
          std::int64_t& index = across ? pixel.i : pixel.j;
          index =
              in_proportion ? index * (smaller - 1) / (count - 1) : std::min(index, smaller - 1);
        }
        out.push_back(std::move(less));
      }
    }
  }
  for (std::size_t k = 0; k < the_case.pixels.size(); ++k) {
    if (the_case.pixels[k] == scene::Pixel{}) continue;
    Case first = the_case;
    first.pixels[k] = {};
    out.push_back(std::move(first));
  }
}

}  // namespace

int complexity(double value) {
  if (value == 0) return 0;
  int exponent = 0;
  std::frexp(value, &exponent);
  return significant_bits(value) + std::abs(exponent - 1) + (value < 0 ? 1 : 0);
}

std::vector<double> simpler(double value) {
  std::vector<double> result;
  const auto offer = [&](double candidate) {
    if (!std::isfinite(candidate) || complexity(candidate) >= complexity(value)) return;
    if (std::find(result.begin(), result.end(), candidate) == result.end()) {
      result.push_back(candidate);
    }
  };
  const int bits = significant_bits(value);
  offer(0);
  offer(1);
  offer(-1);
  offer(std::abs(value));
  offer(std::round(value));
  offer(std::trunc(value));
  for (const int fewer : {1, 2, 4, 8, bits / 2, bits - 1}) {
    if (fewer > 0 && fewer < bits) offer(rounded_to_bits(value, fewer));
  }
  offer(value / 2);
  offer(value * 2);
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  offer(std::ldexp(fraction, exponent / 2));
  return result;
}

std::vector<Case> simpler(const Case& the_case) {
  std::vector<Case> result;
  leave_one_out(
      the_case, [](auto& c) -> auto& { return c.scene.spheres; }, 0, result);
  leave_one_out(
      the_case, [](auto& c) -> auto& { return c.pixels; }, 1, result);
  leave_one_out(
      the_case, [](auto& c) -> auto& { return c.scene.rays; }, 1, result);
  reset(the_case, &scene::Conventions::rows, result);
  reset(the_case, &scene::Conventions::samples, result);
  reset(the_case, &scene::Conventions::origin, result);
  reset(the_case, &scene::Conventions::root, result);
  reset(the_case, &scene::Conventions::tangent, result);
  if (the_case.scene.camera) shrink_image(the_case, result);

  std::size_t count = 0;
  Case scratch = the_case;
  for_each_number(scratch.scene, [&](double&) { ++count; });
  for (std::size_t target = 0; target < count; ++target) {
    double original = 0;
    const auto set = [&](Case& where, const double* value) {
      std::size_t k = 0;
      for_each_number(where.scene, [&](double& x) {
        if (k++ != target) return;
        if (value != nullptr) {
          x = *value;
        } else {
          original = x;
        }
      });
    };
    set(scratch, nullptr);
    for (const double value : simpler(original)) {
      Case with = the_case;
      set(with, &value);
      result.push_back(std::move(with));
    }
  }
  std::erase_if(result, [&](const Case& c) {
    return !is_valid(c) || count_points(c.scene) > count_points(the_case.scene);
  });
  return result;
}

Case smallest(Case from, int tries, const std::function<bool(const Case&)>& still) {
  for (bool found = true; found && tries > 0;) {
    found = false;
    for (Case& next : simpler(from)) {
      if (--tries < 0) break;
      if (!still(next)) continue;
      from = std::move(next);
      found = true;
      break;
    }
  }
  return from;
}

}  // namespace raycheck::properties
