// Numbers of a scene that are read or used wrongly: wrong bounds, numbers read as integers, floats.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "properties/mistakes/mistake_list.h"
#include "scene/precision.h"

namespace raycheck::properties {
namespace {

double aspect(const Camera& camera) {
  return static_cast<double>(camera.width) / static_cast<double>(camera.height);
}

/// The bounds in the order of the lecture.
constexpr std::array<double Camera::*, 4> kBounds = {&Camera::left, &Camera::right, &Camera::bottom,
                                                     &Camera::top};
constexpr std::array<const char*, 4> kBoundNames = {"left", "right", "bottom", "top"};

/// Gives bounds without width or height a minimal one, so that no formula divides by 0.
void keep_apart(Camera& camera) {
  const auto beyond = [](double x) {
    return std::nextafter(x, std::numeric_limits<double>::infinity());
  };
  if (camera.left == camera.right) camera.right = beyond(camera.left);
  if (camera.bottom == camera.top) camera.top = beyond(camera.bottom);
}

struct BoundChange {
  std::string sentence;
  std::function<void(Camera&)> change;
  std::string_view group = {};
};

std::vector<Mistake> of_bounds(const std::vector<BoundChange>& changes) {
  std::vector<Mistake> all;
  for (const auto& [sentence, change, group] : changes) {
    all.push_back(camera_mistake(sentence, [change = change](Camera& its, const auto&) {
      change(its);
      keep_apart(its);
    }));
    all.back().group = group;
  }
  return all;
}

/// For each bound, the index in kBounds of the bound that is used instead.
using Order = std::array<std::size_t, 4>;

/// "top is taken from right and right from top"
std::string sentence_of(const Order& order) {
  std::string sentence;
  std::size_t last = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (order[k] != k) last = k;
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (order[k] == k) continue;
    if (!sentence.empty()) sentence += k == last ? " and " : ", ";
    sentence += kBoundNames[k];
    sentence += sentence.find("is taken") == std::string::npos ? " is taken from " : " from ";
    sentence += kBoundNames[order[k]];
  }
  return sentence;
}

BoundChange of_order(const Order& order) {
  return {sentence_of(order), [order](Camera& its) {
            const Camera given = its;
            for (std::size_t k = 0; k < 4; ++k) its.*kBounds[k] = given.*kBounds[order[k]];
          }};
}

/// Whether the order is equivalent to "rows are upside down", "columns are mirrored", or both.
bool mirrors(const Order& order) { return order[0] < 2 && order[1] < 2; }

/// Mistakes that take one bound from another, or the bounds in another order.
std::vector<BoundChange> exchanged_bounds() {
  std::vector<BoundChange> all;
  for (std::size_t taken = 0; taken < 4; ++taken) {
    for (std::size_t from = 0; from < 4; ++from) {
      if (taken == from) continue;
      Order order = {0, 1, 2, 3};
      order[taken] = from;
      all.push_back(of_order(order));
    }
  }
  Order order = {0, 1, 2, 3};
  while (std::next_permutation(order.begin(), order.end())) {
    if (!mirrors(order)) all.push_back(of_order(order));
  }
  return all;
}

double half_width(const Camera& its) { return (its.right - its.left) / 2; }
double half_height(const Camera& its) { return (its.top - its.bottom) / 2; }
void centre(Camera& its, double right, double top) {
  its.left = -right, its.right = right, its.bottom = -top, its.top = top;
}

/// Cameras with a field of view have symmetric bounds and square pixels. Here the bounds follow
/// from the size of one side, which is the wrong one. First in the list: bounds of the right size.
std::vector<BoundChange> field_of_view_changes() {
  constexpr const char* kGroup = "field of view";
  struct Where {
    const char* words;
    bool (*is)(double aspect);
  };
  constexpr std::array<Where, 3> kWhere = {
      {{"", [](double) { return true; }},
       {", where a picture is wider than high", [](double aspect) { return aspect > 1; }},
       {", where a picture is higher than wide", [](double aspect) { return aspect < 1; }}}};
  std::vector<BoundChange> all = {
      {"the image plane is taken to be centred: half its width is (right - left)/2, half its "
       "height "
       "(top - bottom)/2",
       [](Camera& its) { centre(its, half_width(its), half_height(its)); }, kGroup}};
  for (const bool across : {true, false}) {
    for (const auto& [words, is] : kWhere) {
      const std::string sentence = across
                                       ? "from left to right is taken for that from top to bottom"
                                       : "from top to bottom is taken for that from left to right";
      all.push_back({"the field of view " + sentence + words,
                     [across, is = is](Camera& its) {
                       double right = half_width(its), top = half_height(its);
                       if (is(aspect(its))) {
                         (across ? top : right) = across ? right : top;
                         (across ? right : top) = across ? top * aspect(its) : right / aspect(its);
                       }
                       centre(its, right, top);
                     },
                     kGroup});
    }
  }
  return all;
}

void scale(Camera& its, double across, double upwards) {
  its.left *= across, its.right *= across;
  its.bottom *= upwards, its.top *= upwards;
}

std::vector<BoundChange> bound_changes() {
  return {
      {"top is -bottom", [](Camera& its) { its.top = -its.bottom; }},
      {"bottom is -top", [](Camera& its) { its.bottom = -its.top; }},
      {"right is -left", [](Camera& its) { its.right = -its.left; }},
      {"left is -right", [](Camera& its) { its.left = -its.right; }},
      {"the image plane is taken to be centred: left is -right and bottom is -top",
       [](Camera& its) { centre(its, its.right, its.top); }},
      {"the image plane is taken to be centred: half its height is top, half its width top w/h",
       [](Camera& its) { centre(its, its.top * aspect(its), its.top); }},
      {"the image plane is taken to be centred: half its height is top, half its width "
       "top (right - left)/(top - bottom)",
       [](Camera& its) { centre(its, its.top * half_width(its) / half_height(its), its.top); }},
      {"the image plane is taken to be centred: half its height is top, and so is half its width",
       [](Camera& its) { centre(its, its.top, its.top); }},
      {"the height of the image plane is its width over w h, not over w/h: all rows are nearly "
       "alike",
       [](Camera& its) {
         const auto pixels = static_cast<double>(its.width) * static_cast<double>(its.height);
         centre(its, half_width(its), half_width(its) / pixels);
       }},
      {"height/width is divided as integers: the height of the image plane is its width times that",
       [](Camera& its) {
         const auto whole = static_cast<double>(its.height / its.width);
         centre(its, half_width(its), half_width(its) * whole);
       }},
      {"width/height is divided as integers: the height of a pixel is its width times that",
       [](Camera& its) {
         const auto whole = static_cast<double>(its.width / its.height);
         centre(its, half_width(its), half_width(its) / aspect(its) * whole);
       }},
      {"the bounds of rows are those of columns",
       [](Camera& its) { its.bottom = its.left, its.top = its.right; }},
      {"the height is corrected for an aspect ratio that the bounds already contain",
       [](Camera& its) { its.top = its.bottom + (its.top - its.bottom) * aspect(its); }},
      {"the aspect ratio is corrected twice: alpha is multiplied by width/height",
       [](Camera& its) { scale(its, aspect(its), 1); }},
      {"the aspect ratio is corrected twice: alpha is multiplied by height/width",
       [](Camera& its) { scale(its, 1 / aspect(its), 1); }},
      {"the aspect ratio is corrected twice: beta is multiplied by width/height",
       [](Camera& its) { scale(its, 1, aspect(its)); }},
      {"the aspect ratio is corrected twice: beta is multiplied by height/width",
       [](Camera& its) { scale(its, 1, 1 / aspect(its)); }},
      {"left and right are both negated", [](Camera& its) { scale(its, -1, 1); }},
      {"top and bottom are both negated", [](Camera& its) { scale(its, 1, -1); }},
      {"all four bounds are negated", [](Camera& its) { scale(its, -1, -1); }}};
}

/// Returns a number as it is read.
using Reading = double (*)(double);
double as_integer(double x) { return std::trunc(x); }
double as_float(double x) { return scene::rounded_to(Precision::kSingle, x); }

template <class Triple>
void read_triple(Reading as, Triple& triple) {
  triple = {as(triple.x), as(triple.y), as(triple.z)};
}

void read_bounds(Reading as, Camera& camera) {
  for (double Camera::*bound : kBounds) camera.*bound = as(camera.*bound);
  keep_apart(camera);
}

void read_view(Reading as, Camera& camera) {
  read_triple(as, camera.eye);
  read_triple(as, camera.look_at);
  read_triple(as, camera.up);
}

ChangeCamera read_camera(Reading as) {
  return [as](Camera& camera, const Conventions&) {
    read_view(as, camera);
    camera.near = as(camera.near);
    read_bounds(as, camera);
  };
}

ChangeSphere read_sphere(Reading as) {
  return [as](Sphere& sphere) {
    read_triple(as, sphere.centre);
    sphere.radius = as(sphere.radius);
  };
}

/// The root of r * r in 32-bit integer arithmetic; 0 if r * r becomes negative. Radii that are too
/// large for an integer stay.
double root_of_wrapped_square(double radius) {
  if (!(radius < 0x1p32)) return radius;
  const auto r = static_cast<std::uint32_t>(radius);
  const auto square = static_cast<std::int32_t>(r * r);
  return square < 0 ? 0 : std::sqrt(square);
}

Mistake sphere_mistake(std::string sentence, ChangeSphere change) {
  return {.sentence = std::move(sentence), .step = Step::kIntersect, .sphere = std::move(change)};
}

/// Mistakes that read numbers in this way: all numbers, the camera's, or the spheres'.
std::vector<Mistake> readings(Reading as, const std::string& how) {
  return {{.sentence = "numbers are " + how,
           .step = Step::kFrame,
           .camera = read_camera(as),
           .sphere = read_sphere(as)},
          camera_mistake("the camera's numbers are " + how, read_camera(as), Step::kFrame),
          sphere_mistake("the spheres' numbers are " + how, read_sphere(as))};
}

Ray ray_of_floats(Ray ray) {
  read_triple(as_float, ray.origin);
  read_triple(as_float, ray.direction);
  return ray;
}

/// Rounds s, Q or both to floats. Q follows from s, unless only Q is rounded.
HitAnswer of_floats(const Ray& ray, HitAnswer hit, bool s, bool Q) {
  if (s) hit = hit_at(ray, as_float(hit.parameter));
  if (Q) read_triple(as_float, hit.point);
  return hit;
}

/// Floats in code that computes in doubles: the input, or one result.
std::vector<Mistake> float_mistakes() {
  std::vector<Mistake> all = readings(as_float, "rounded to floats");
  const HitFormulas of_rays = {
      .roots = [](const Ray& ray,
                  const Sphere& sphere) { return fast::kCross.roots(ray_of_floats(ray), sphere); },
      .choose = [](const Ray& ray, const fast::Roots& roots,
                   const Conventions& c) { return usual_choice(ray_of_floats(ray), roots, c); }};
  const auto add = [&](Mistake mistake) { all.push_back(std::move(mistake)); };
  add({.sentence = "rays are rounded to floats", .step = Step::kIntersect, .hits = of_rays});
  add({.sentence = "rays and spheres are rounded to floats",
       .step = Step::kIntersect,
       .sphere = read_sphere(as_float),
       .hits = of_rays});
  for (const auto& [what, s, Q] : {std::tuple{"s is rounded to a float", true, false},
                                   std::tuple{"Q is rounded to floats", false, true},
                                   std::tuple{"s and Q are rounded to floats", true, true}}) {
    add({.sentence = what,
         .step = Step::kIntersect,
         .hit = [s = s, Q = Q](auto& ray, auto&, auto hit) { return of_floats(ray, hit, s, Q); }});
    if (Q) all.back().is_offered = returns_points;
  }
  add({.sentence = "P is rounded to floats",
       .step = Step::kPixelPoint,
       .rays = {.point = [](const Camera& c, const Vector3& g) {
         Point3 P = {c.eye.x + g.x, c.eye.y + g.y, c.eye.z + g.z};
         read_triple(as_float, P);
         return P;
       }}});
  add({.sentence = "D is rounded to floats",
       .step = Step::kRay,
       .rays = {.direction = [](auto&, auto&, const Vector3& g) {
         Vector3 D = normalised(g);
         read_triple(as_float, D);
         return D;
       }}});
  for (Mistake& mistake : all) {
    mistake.is_rounding = true;
    mistake.shows_in_pictures = false;
  }
  return all;
}

std::vector<Mistake> sphere_mistakes() {
  return {sphere_mistake("the centre is left out: spheres are about the world's origin",
                         [](Sphere& its) { its.centre = {}; }),
          sphere_mistake("the radius is taken for the diameter: spheres are half as large",
                         [](Sphere& its) { its.radius /= 2; }),
          sphere_mistake("the diameter is taken for the radius: spheres are twice as large",
                         [](Sphere& its) { its.radius *= 2; }),
          sphere_mistake("r^2 is an integer of 32 bits: it wraps around from a radius of 46,341 on",
                         [](Sphere& its) {
                           if (its.radius >= 46341) its.radius = root_of_wrapped_square(its.radius);
                         }),
          sphere_mistake("the squared radius is squared again: d^2 = r^4 - (|T|^2 - v^2)",
                         [](Sphere& its) { its.radius *= its.radius; }),
          sphere_mistake("the radius is not squared: d^2 = r - (|T|^2 - v^2)",
                         [](Sphere& its) { its.radius = std::sqrt(its.radius); })};
}

/// Mistakes that read some of the camera's numbers, or all numbers, as integers.
std::vector<Mistake> integer_mistakes() {
  const std::string how = "read as integers: their fractions are dropped";
  const auto view = [](Camera& its, auto&) { read_view(as_integer, its); };
  const auto near = [](Camera& its, auto&) { its.near = as_integer(its.near); };
  return all_of({readings(as_integer, how),
                 {camera_mistake("eye, look and up are " + how, view, Step::kFrame),
                  camera_mistake(
                      "eye, look, up and d are " + how,
                      [=](Camera& its, auto& c) { view(its, c), near(its, c); }, Step::kFrame),
                  camera_mistake("d is read as an integer: its fraction is dropped", near),
                  camera_mistake("the bounds are " + how,
                                 [](Camera& its, auto&) { read_bounds(as_integer, its); })}});
}

}  // namespace

std::vector<Mistake> number_mistakes() {
  return all_of({of_bounds(bound_changes()), of_bounds(field_of_view_changes()),
                 of_bounds(exchanged_bounds()), integer_mistakes(), sphere_mistakes(),
                 float_mistakes()});
}

}  // namespace raycheck::properties
