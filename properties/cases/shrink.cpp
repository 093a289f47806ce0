#include "properties/cases/shrink.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
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
  const Camera& camera = *the_case.scene.camera;
  return std::all_of(the_case.pixels.begin(), the_case.pixels.end(),
                     [&](const Pixel& p) { return p.i < camera.width && p.j < camera.height; });
}

/// The number of spheres of radius 0. They are harder to picture, so a radius of 0 does not make a
/// case simpler.
std::ptrdiff_t count_points(const Scene& scene) {
  return std::count_if(scene.spheres.begin(), scene.spheres.end(),
                       [](const Sphere& sphere) { return sphere.radius == 0; });
}

/// Called with one case after another until it returns true.
using Take = std::function<bool(Case&&)>;

/// Cases without some elements: first without half of them, then without fewer; at least `keep`
/// remain.
template <class Member>
bool leave_some_out(const Case& the_case, Member member, std::size_t keep, const Take& take) {
  const std::size_t count = member(the_case).size();
  const std::size_t most = count - std::min(count, keep);
  for (std::size_t some = std::min(most, std::max<std::size_t>(1, count / 2)); some > 0;
       some /= 2) {
    for (std::size_t at = 0; at + some <= count; at += some) {
      Case fewer = the_case;
      auto& list = member(fewer);
      const auto first = list.begin() + static_cast<std::ptrdiff_t>(at);
      list.erase(first, first + static_cast<std::ptrdiff_t>(some));
      if (take(std::move(fewer))) return true;
    }
  }
  return false;
}

template <class Convention>
bool reset(const Case& the_case, Convention Conventions::*member, const Take& take) {
  Case plain = the_case;
  plain.scene.conventions.*member = Conventions{}.*member;
  return !(plain.scene.conventions == the_case.scene.conventions) && take(std::move(plain));
}

/// 2, then counts that approach `count`: halving finds the smallest that is enough.
std::vector<std::int64_t> smaller_counts(std::int64_t count) {
  std::vector<std::int64_t> result = {2};
  for (std::int64_t step = count / 2; step > 0; step /= 2) result.push_back(count - step);
  std::erase_if(result, [count](std::int64_t smaller) { return smaller >= count; });
  return result;
}

bool shrink_image(const Case& the_case, const Take& take) {
  const Camera& camera = *the_case.scene.camera;
  for (const bool across : {true, false}) {
    const std::int64_t count = across ? camera.width : camera.height;
    for (const std::int64_t smaller : smaller_counts(count)) {
      // Pixels keep their relative position in the image or, if these still exist, their indices.
      for (const bool in_proportion : {true, false}) {
        Case less = the_case;
        (across ? less.scene.camera->width : less.scene.camera->height) = smaller;
        for (Pixel& pixel : less.pixels) {
          std::int64_t& index = across ? pixel.i : pixel.j;
          index =
              in_proportion ? index * (smaller - 1) / (count - 1) : std::min(index, smaller - 1);
        }
        if (take(std::move(less))) return true;
      }
    }
  }
  for (std::size_t k = 0; k < the_case.pixels.size(); ++k) {
    if (the_case.pixels[k] == Pixel{}) continue;
    Case first = the_case;
    first.pixels[k] = {};
    if (take(std::move(first))) return true;
  }
  return false;
}

bool simplify_numbers(const Case& the_case, const Take& take) {
  std::vector<double> numbers;
  Case scratch = the_case;
  for_each_number(scratch.scene, [&](double& x) { numbers.push_back(x); });
  for (std::size_t target = 0; target < numbers.size(); ++target) {
    for (const double value : simpler(numbers[target])) {
      Case with = the_case;
      std::size_t k = 0;
      for_each_number(with.scene, [&](double& x) {
        if (k++ == target) x = value;
      });
      if (take(std::move(with))) return true;
    }
  }
  return false;
}

/// Tries the cases of simpler(). Each is made when it is tried, because the memory for all of them
/// grows with the square of the scene's size.
bool any_simpler(const Case& the_case, const Take& take) {
  const std::ptrdiff_t points = count_points(the_case.scene);
  const Take valid = [&](Case&& next) {
    return is_valid(next) && count_points(next.scene) <= points && take(std::move(next));
  };
  const auto of = [](auto member) {
    return [member](auto& c) -> auto& { return c.scene.*member; };
  };
  const auto pixels = [](auto& c) -> auto& { return c.pixels; };
  return leave_some_out(the_case, of(&Scene::spheres), 0, valid) ||
         leave_some_out(the_case, pixels, 1, valid) ||
         leave_some_out(the_case, of(&Scene::rays), 1, valid) ||
         reset(the_case, &Conventions::rows, valid) ||
         reset(the_case, &Conventions::samples, valid) ||
         reset(the_case, &Conventions::origin, valid) ||
         reset(the_case, &Conventions::root, valid) ||
         reset(the_case, &Conventions::tangent, valid) ||
         (the_case.scene.camera && shrink_image(the_case, valid)) ||
         simplify_numbers(the_case, valid);
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
  any_simpler(the_case, [&](Case&& next) {
    result.push_back(std::move(next));
    return false;
  });
  return result;
}

Case smallest(Case from, ShrinkBudget& budget, const std::function<bool(const Case&)>& still) {
  bool found = true;
  const auto take = [&](Case&& next) {
    if (budget.is_spent()) return true;
    --budget.tries;
    budget.parts -=
        std::ssize(next.scene.spheres) + std::ssize(next.scene.rays) + std::ssize(next.pixels);
    if (!still(next)) return false;
    from = std::move(next);
    return found = true;
  };
  while (found) {
    found = false;
    const Case now = from;
    any_simpler(now, take);
  }
  return from;
}

}  // namespace raycheck::properties
