// The flat interface answers as the exact ray does, within the bounds that it returns, for every
// layout of the arrays and any number of threads; and it names what is not valid.

#include <raycheck/cases.h>
#include <raycheck/exact.h>

#include <array>
#include <random>
#include <raycheck/batch.hpp>

#include "tests/testing.h"

namespace raycheck::tests {
namespace {

/// Rays and spheres in arrays, and the answers to all of them.
struct Many {
  std::vector<Ray> rays;
  std::vector<Sphere> spheres;
  std::vector<std::uint8_t> hit_class, root;
  std::vector<double> s, s_error;
  std::array<std::vector<double>, 3> point, point_error;
  raycheck_options options = batch::options();

  void add(const Ray& ray, const Sphere& sphere) {
    rays.push_back(ray);
    spheres.push_back(sphere);
  }
  raycheck_rays given() const {
    raycheck_rays given = {};
    given.origin = batch::points<Ray>(rays, &Ray::origin);
    given.direction = batch::points<Ray>(rays, &Ray::direction);
    return given;
  }
  raycheck_spheres balls() const {
    raycheck_array radius = {};
    if (!spheres.empty()) {
      radius = {&spheres[0].radius, spheres.size(), sizeof(Sphere), RAYCHECK_FLOAT64};
    }
    return {batch::points<Sphere>(spheres, &Sphere::centre), radius};
  }
  raycheck_decided to(std::size_t count) {
    hit_class.assign(count, 77);
    root.assign(count, 77);
    for (auto* one : {&s, &s_error, &point[0], &point[1], &point[2], &point_error[0],
                      &point_error[1], &point_error[2]}) {
      one->assign(count, 77);
    }
    return {
        batch::output(hit_class), batch::output(root),
        batch::output(s),         batch::output(point[0], point[1], point[2]),
        batch::output(s_error),   batch::output(point_error[0], point_error[1], point_error[2])};
  }
  std::int32_t decide() {
    const raycheck_rays its_rays = given();
    const raycheck_spheres its_spheres = balls();
    const bool every = options.pairing == RAYCHECK_EACH_WITH_EVERY;
    const raycheck_decided answers = to(rays.size() * (every ? spheres.size() : 1));
    return raycheck_decide(&its_rays, &its_spheres, &options, &answers, &batch::error());
  }
};

raycheck_asked asked_of(const Conventions& c) {
  return {{static_cast<int>(c.rows), static_cast<int>(c.samples), static_cast<int>(c.origin),
           static_cast<int>(c.root), static_cast<int>(c.tangent)},
          {c.valid.t_min, c.valid.t_max, static_cast<int>(c.valid.ends),
           static_cast<int>(c.valid.unit), static_cast<int>(c.valid.culling)}};
}

/// The error of a value, and the least gap of doubles around the exact number.
double error_of(double value, const exact::Number& number) {
  const exact::Interval around = number.interval();
  const double nearer =
      std::abs(around.lower) < std::abs(around.upper) ? around.lower : around.upper;
  if (nearer == 0) return std::max(std::abs(value - around.lower), std::abs(value - around.upper));
  const double ulp = std::nextafter(std::abs(nearer), kInfinity) - std::abs(nearer);
  return number.ulp_error(value) * ulp;
}

/// How near errors come to their bounds, so that no test passes for bounds that are too wide.
struct Bounds {
  int pairs = 0, hits = 0, tangents = 0;
  double worst_s = 0, worst_point = 0;  ///< The largest error, in bounds.

  /// Classes and roots; the errors of every `step`-th.
  void compare(const Many& many, std::size_t k, const exact::Intersection& truth,
               std::size_t step = 1) {
    ++pairs;
    ASSERT_EQ(many.hit_class[k], static_cast<int>(truth.hit_class)) << k;
    if (truth.hit_class == exact::HitClass::miss) {
      ASSERT_TRUE(std::isnan(many.s[k]) && std::isnan(many.point[1][k]));
      return;
    }
    ++hits;
    tangents += truth.hit_class == exact::HitClass::tangent ? 1 : 0;
    ASSERT_EQ(many.root[k], static_cast<int>(truth.root)) << k;
    if (k % step != 0) return;
    const auto share = [](double value, double bound, const exact::Number& number) {
      if (std::isinf(value))
        return number.rounded() == value && std::isinf(bound) ? 0.0 : kInfinity;
      const double error = error_of(value, number);
      return error == 0 ? 0 : error / bound;
    };
    worst_s = std::max(worst_s, share(many.s[k], many.s_error[k], *truth.parameter));
    const auto& Q = *truth.point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const exact::Number& number = axis == 0 ? Q.x : axis == 1 ? Q.y : Q.z;
      worst_point =
          std::max(worst_point, share(many.point[axis][k], many.point_error[axis][k], number));
    }
  }
  void expect_kept() const {
    EXPECT_LE(worst_s, 1 + 1e-4);
    EXPECT_GT(worst_s, 0.8);
    EXPECT_LE(worst_point, 1 + 1e-4);
    EXPECT_GT(worst_point, 0.8);
  }
};

/// Rays of every source of given rays, with their spheres. RAYCHECK_BATCH_CASES: of each source.
Many hard_rays(std::uint64_t first = 0) {
  const char* const asked = std::getenv("RAYCHECK_BATCH_CASES");
  const std::uint64_t cases = asked == nullptr ? 6000 : std::stoull(asked);
  Many many;
  for (const Source& source : sources()) {
    if (source.has_camera) continue;
    for (std::uint64_t k = first; k < first + cases; ++k) {
      const auto severity = static_cast<int>(k % static_cast<std::uint64_t>(source.highest + 1));
      const Case one = make_case(source.name, 5, k, severity);
      for (const Sphere& sphere : one.scene.spheres) many.add(one.scene.rays.front(), sphere);
    }
  }
  return many;
}

TEST(Batch, DecidesAsTheExactRayWithinItsBounds) {
  for (const Root root : {Root::nearest, Root::smaller}) {
    Many many = hard_rays(root == Root::nearest ? 0 : 1'000'000);
    Conventions conventions;
    conventions.root = root;
    const raycheck_asked asked = asked_of(conventions);
    many.options.asked = &asked;
    ASSERT_EQ(many.decide(), RAYCHECK_OK) << batch::error().reason;
    Bounds bounds;
    for (std::size_t k = 0; k < many.rays.size(); ++k) {
      bounds.compare(many, k, exact::hit(many.rays[k], many.spheres[k], conventions), 7);
      if (HasFatalFailure()) return;
    }
    bounds.expect_kept();
    EXPECT_GT(bounds.pairs, 50000);
    EXPECT_GT(bounds.hits, 20000);
    EXPECT_GT(bounds.tangents, 500);
  }
}

/// Integers are decided here in integers.
TEST(Batch, DecidesSmallIntegersAsIntegersDo) {
  Many many;
  std::mt19937 random(3);
  const auto any = [&](int most) {
    return static_cast<double>(static_cast<int>(random() % (2U * static_cast<unsigned>(most) + 1)) -
                               most);
  };
  while (many.rays.size() < 100'000) {
    const Ray ray{{any(5), any(5), any(5)}, {any(3), any(3), any(3)}};
    if (ray.direction.x == 0 && ray.direction.y == 0 && ray.direction.z == 0) continue;
    many.add(ray, {{any(5), any(5), any(5)}, std::abs(any(6))});
  }
  ASSERT_EQ(many.decide(), RAYCHECK_OK);
  std::array<int, 3> count{};
  for (std::size_t k = 0; k < many.rays.size(); ++k) {
    const auto [o, d] = many.rays[k];
    const auto [centre, radius] = many.spheres[k];
    const auto dot = [](const Vector& u, const Vector& v) {
      return static_cast<std::int64_t>(u.x * v.x + u.y * v.y + u.z * v.z);
    };
    const Vector T{centre.x - o.x, centre.y - o.y, centre.z - o.z};
    const std::int64_t a = dot(d, d), b = dot(T, d);
    const std::int64_t c = dot(T, T) - static_cast<std::int64_t>(radius * radius);
    const std::int64_t disc = b * b - a * c;
    const bool met = disc >= 0 && (c <= 0 || b > 0);
    const int expected = !met ? 0 : disc == 0 ? 2 : 1;
    ASSERT_EQ(many.hit_class[k], expected) << k;
    ++count[static_cast<std::size_t>(expected)];
    if (met) {
      ASSERT_EQ(many.root[k], c < 0 || (c == 0 && b < 0) ? 1 : 0) << k;
    }
  }
  EXPECT_GT(count[0], 10000);
  EXPECT_GT(count[1], 10000);
  EXPECT_GT(count[2], 200);
}

TEST(Batch, FollowsEveryConvention) {
  std::vector<Conventions> all(6);
  all[0].valid.t_min = -kInfinity;
  all[1].valid.t_min = 0.25;
  all[2].valid.culling = Culling::front_faces;
  all[3].valid.culling = Culling::back_faces;
  all[4].valid = {0, 2, Ends::open, TUnit::radius};
  all[5].valid = {0.5, 1e3, Ends::open_max, TUnit::length};
  for (const Conventions& conventions : all) {
    Many many = hard_rays();
    many.rays.resize(3000);
    many.spheres.resize(3000);
    const raycheck_asked asked = asked_of(conventions);
    many.options.asked = &asked;
    ASSERT_EQ(many.decide(), RAYCHECK_OK) << batch::error().reason;
    Bounds bounds;
    for (std::size_t k = 0; k < many.rays.size(); ++k) {
      bounds.compare(many, k, exact::hit(many.rays[k], many.spheres[k], conventions));
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(bounds.hits, 200);
  }
}

Camera small_camera() { return {{1, 2, 30}, {0, 0, 0}, {0, 1, 0.2}, -1, -.3, .3, -.2, .2, 48, 35}; }
raycheck_camera in_c(const Camera& c) {
  const auto triple = [](const Vector& v) { return raycheck_vector{v.x, v.y, v.z}; };
  return {triple(c.eye), triple(c.look_at), triple(c.up), c.near_plane, c.left,
          c.right,       c.bottom,          c.top,        c.width,      c.height};
}

/// Spheres in view, some of them twice, and integers that meet.
std::vector<Sphere> some_spheres(int count) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> at(-5, 5);
  std::vector<Sphere> spheres;
  for (int k = 0; k < count; ++k) {
    const Sphere one{{at(random), at(random), at(random)}, 0.3 + std::abs(at(random)) / 8};
    spheres.push_back(one);
    if (k % 7 == 0) spheres.push_back(one);
  }
  return spheres;
}

TEST(Batch, DecidesTheExactRaysOfACamera) {
  const Camera camera = small_camera();
  Many many;
  many.spheres = {{{0, 0, 0}, 4}};
  raycheck_rays rays = {};
  const raycheck_camera seen = in_c(camera);
  rays.camera = &seen;
  const std::size_t pixels = 48 * 35;
  const raycheck_spheres spheres = many.balls();
  const raycheck_decided to = many.to(pixels);
  ASSERT_EQ(raycheck_decide(&rays, &spheres, &many.options, &to, &batch::error()), RAYCHECK_OK);
  Bounds bounds;
  const exact::Camera known(camera);
  for (std::size_t k = 0; k < pixels; ++k) {
    const auto pixel = static_cast<std::int64_t>(k);
    bounds.compare(many, k, known.ray({pixel % 48, pixel / 48}).hit(many.spheres[0]));
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(bounds.hits, 100);
  // Two pixels by their columns and rows.
  const std::vector<std::int32_t> i = {20, 24}, j = {17, 18};
  rays.pixel_i = batch::array(i);
  rays.pixel_j = batch::array(j);
  std::vector<double> s(2);
  raycheck_decided two = {};
  two.s = batch::output(s);
  ASSERT_EQ(raycheck_decide(&rays, &spheres, &many.options, &two, &batch::error()), RAYCHECK_OK);
  EXPECT_EQ(s[1], many.s[18 * 48 + 24]);
  EXPECT_EQ(s[0], many.s[17 * 48 + 20]);
}

/// The same answers, to the bit, from every layout.
TEST(Batch, ReadsAndWritesEveryLayout) {
  Many many = hard_rays();
  const std::size_t count = 5003;
  many.rays.resize(count);
  many.spheres.resize(count);
  for (Ray& ray : many.rays) {  // floats, so that both types can hold them
    for (double* x : {&ray.origin.x, &ray.origin.y, &ray.origin.z, &ray.direction.x,
                      &ray.direction.y, &ray.direction.z}) {
      *x = static_cast<float>(*x);
      if (!std::isfinite(*x)) *x = 1;
    }
    if (ray.direction.x == 0 && ray.direction.y == 0) ray.direction.z = 1;
  }
  ASSERT_EQ(many.decide(), RAYCHECK_OK) << batch::error().reason;
  const raycheck_rays given = many.given();
  const raycheck_spheres balls = many.balls();
  std::array<std::vector<double>, 6> columns;
  std::array<std::vector<float>, 6> single;
  for (const Ray& ray : many.rays) {
    const std::array<double, 6> all = {ray.origin.x,    ray.origin.y,    ray.origin.z,
                                       ray.direction.x, ray.direction.y, ray.direction.z};
    for (std::size_t c = 0; c < 6; ++c) {
      columns[c].push_back(all[c]);
      single[c].push_back(static_cast<float>(all[c]));
    }
  }
  const auto of = [](const auto& c) {
    raycheck_rays rays = {};
    rays.origin = batch::array(c[0], c[1], c[2]);
    rays.direction = batch::array(c[3], c[4], c[5]);
    return rays;
  };
  std::vector<std::int64_t> classes(count), reversed(count);
  std::vector<float> s(count), s_error(count);
  struct Gap {
    char gap;
    double value;
  };
  std::vector<Gap> gaps(count);
  for (const raycheck_rays& rays : {given, of(columns), of(single)}) {
    for (const int threads : {1, 3}) {
      const raycheck_options options = batch::options(threads);
      raycheck_decided to = {};
      to.hit_class = batch::output(classes);
      to.root = {&reversed.back(), count, -8, RAYCHECK_INT64};
      to.s = batch::output(s);
      to.s_error = batch::output(s_error);
      to.point = {&gaps[0].value, &gaps[0].value, &gaps[0].value,
                  count,          sizeof(Gap),    RAYCHECK_FLOAT64};
      ASSERT_EQ(raycheck_decide(&rays, &balls, &options, &to, &batch::error()), RAYCHECK_OK);
      for (std::size_t k = 0; k < count; ++k) {
        ASSERT_EQ(classes[k], many.hit_class[k]);
        if (classes[k] == RAYCHECK_MISS) continue;
        ASSERT_EQ(reversed[count - 1 - k], many.root[k]);
        ASSERT_EQ(s[k], static_cast<float>(many.s[k]));
        ASSERT_GE(s_error[k], many.s_error[k]);
        const double off = std::abs(static_cast<double>(s[k]) - many.s[k]);
        if (std::isfinite(s[k])) {
          ASSERT_GE(static_cast<double>(s_error[k]), off);
        }
        ASSERT_EQ(gaps[k].value, many.point[2][k]);
      }
    }
  }
}

TEST(Batch, ComparesEachRayWithEverySphere) {
  Many many = hard_rays();
  many.rays.resize(1300);
  many.spheres = some_spheres(5);
  many.options.pairing = RAYCHECK_EACH_WITH_EVERY;
  ASSERT_EQ(many.decide(), RAYCHECK_OK);
  Many one = many;
  one.options = batch::options();
  for (std::size_t m = 0; m < many.spheres.size(); ++m) {
    one.spheres = {many.spheres[m]};
    ASSERT_EQ(one.decide(), RAYCHECK_OK);
    for (std::size_t k = 0; k < one.rays.size(); ++k) {
      ASSERT_EQ(one.hit_class[k], many.hit_class[m * one.rays.size() + k]);
      if (one.hit_class[k] != RAYCHECK_MISS) {
        ASSERT_EQ(one.s[k], many.s[m * one.rays.size() + k]);
      }
    }
  }
}

TEST(Batch, NamesWhatIsNotValidAndAnswersTheRest) {
  Many right = hard_rays();
  right.rays.resize(2000);
  right.spheres.resize(2000);
  ASSERT_EQ(right.decide(), RAYCHECK_OK);
  const auto expect = [&](Many& wrong, std::size_t at, const char* array, const char* reason) {
    for (const int threads : {1, 2}) {
      wrong.options.threads = threads;
      EXPECT_EQ(wrong.decide(), RAYCHECK_INVALID_INPUT);
      EXPECT_EQ(std::string(batch::error().array), array);
      EXPECT_EQ(batch::error().index, at);
      EXPECT_TRUE(has(batch::error().reason, reason)) << batch::error().reason;
      for (std::size_t k = 0; k < wrong.rays.size(); ++k) {
        if (k == at || k == 1999) continue;
        ASSERT_EQ(wrong.hit_class[k], right.hit_class[k]);
        if (wrong.hit_class[k] == RAYCHECK_HIT) {
          ASSERT_EQ(wrong.s[k], right.s[k]);
        }
      }
      EXPECT_EQ(wrong.hit_class[at], RAYCHECK_INVALID);
      EXPECT_TRUE(std::isnan(wrong.s[at]) && std::isnan(wrong.s_error[at]));
      EXPECT_TRUE(std::isnan(wrong.point[0][at]) && std::isnan(wrong.point_error[0][at]));
    }
  };
  const double nan = std::nan("");
  Many wrong = right;
  wrong.rays[1999].origin.x = nan;
  wrong.rays[700].origin.y = kInfinity;
  expect(wrong, 700, "origin", "is not finite");
  wrong = right;
  wrong.rays[5].direction = {0, 0, 0};
  expect(wrong, 5, "direction", "0");
  wrong = right;
  wrong.rays[1501].direction.z = nan;
  expect(wrong, 1501, "direction", "is not finite");
  wrong = right;
  wrong.spheres[1022].radius = -1;
  expect(wrong, 1022, "radius", "-1");
  wrong = right;
  wrong.spheres[0].centre.z = nan;
  expect(wrong, 0, "centre", "is not finite");
  wrong.spheres = {{{0, 0, 0}, -1}};  // one for all rays
  EXPECT_EQ(wrong.decide(), RAYCHECK_INVALID_INPUT);
  EXPECT_EQ(std::string(batch::error().array), "radius");
  EXPECT_EQ(std::count(wrong.hit_class.begin(), wrong.hit_class.end(), RAYCHECK_INVALID), 2000);
}

TEST(Batch, RefusesArraysThatDoNotFit) {
  Many many = hard_rays();
  const raycheck_rays rays = many.given();
  const raycheck_spheres spheres = many.balls();
  const auto refused = [&](const raycheck_rays* its_rays, const raycheck_spheres* its_spheres,
                           const raycheck_options* options, const raycheck_decided* to) {
    EXPECT_EQ(raycheck_decide(its_rays, its_spheres, options, to, &batch::error()),
              RAYCHECK_INVALID_ARGUMENT);
    EXPECT_EQ(raycheck_decide(its_rays, its_spheres, options, to, nullptr),
              RAYCHECK_INVALID_ARGUMENT);
    return std::string(batch::error().array);
  };
  const raycheck_options options = batch::options();
  raycheck_decided to = many.to(many.rays.size());
  EXPECT_EQ(refused(nullptr, &spheres, &options, &to), "rays");
  EXPECT_EQ(refused(&rays, &spheres, nullptr, &to), "options");
  EXPECT_EQ(refused(&rays, &spheres, &options, nullptr), "to");
  raycheck_options other = options;
  other.version = 9;
  EXPECT_EQ(refused(&rays, &spheres, &other, &to), "version");
  other = options;
  other.pairing = 7;
  EXPECT_EQ(refused(&rays, &spheres, &other, &to), "pairing");
  raycheck_asked asked = asked_of(Conventions{});
  asked.conventions.root = 9;
  other = options;
  other.asked = &asked;
  EXPECT_EQ(refused(&rays, &spheres, &other, &to), "asked");
  raycheck_decided few = to;
  few.s.count = 3;
  EXPECT_EQ(refused(&rays, &spheres, &options, &few), "s");
  few = to;
  few.hit_class.type = RAYCHECK_FLOAT64;
  EXPECT_EQ(refused(&rays, &spheres, &options, &few), "hit_class");
  few = to;
  few.point.y = nullptr;
  EXPECT_EQ(refused(&rays, &spheres, &options, &few), "point");
  raycheck_spheres three = spheres;
  three.radius.count = three.centre.count = 3;
  EXPECT_EQ(refused(&rays, &three, &options, &to), "centre");
  raycheck_rays lacking = rays;
  lacking.direction.count = 4;
  EXPECT_EQ(refused(&lacking, &spheres, &options, &to), "direction");
  raycheck_camera camera = {};
  lacking = {};
  lacking.camera = &camera;
  EXPECT_TRUE(has(refused(&lacking, &spheres, &options, &to), "camera"));
  EXPECT_EQ(refused(&rays, nullptr, &options, &to), "centre");
  EXPECT_EQ(many.hit_class[0], 77);  // nothing is written
  EXPECT_THROW(batch::check(RAYCHECK_INVALID_ARGUMENT), std::invalid_argument);
}

TEST(Batch, JudgesNothingWhereThereAreNoSpheres) {
  Many many = hard_rays();
  const raycheck_rays rays = many.given();
  raycheck_options options = batch::options();
  const std::uint8_t hit = 1;
  std::vector<std::uint8_t> wrong(many.rays.size(), 77);
  raycheck_answers answers = {};
  answers.is_hit = {&hit, 1, 0, RAYCHECK_UINT8};
  raycheck_errors to = {};
  to.hit_class = batch::output(wrong);
  EXPECT_EQ(raycheck_error_of(&rays, nullptr, &options, &answers, &to, &batch::error()),
            RAYCHECK_INVALID_ARGUMENT);
  EXPECT_STREQ(batch::error().array, "centre");
  options.pairing = RAYCHECK_EACH_WITH_EVERY;
  to.hit_class.count = 0;
  EXPECT_EQ(raycheck_error_of(&rays, nullptr, &options, &answers, &to, &batch::error()),
            RAYCHECK_OK);
  EXPECT_EQ(wrong, std::vector<std::uint8_t>(wrong.size(), 77));
}

TEST(Batch, RefusesBytesForIndicesAndCountsOfSpheres) {
  Many many;
  many.add({{0, 0, 0}, {0, 0, 1}}, {{0, 0, 5}, 1});
  const raycheck_rays rays = many.given();
  const raycheck_spheres spheres = many.balls();
  const raycheck_options options = batch::options();
  std::vector<std::uint8_t> bytes(many.rays.size());
  for (const auto member : {&raycheck_seen::sphere, &raycheck_seen::ties}) {
    raycheck_seen to = {};
    to.*member = batch::output(bytes);
    EXPECT_EQ(raycheck_nearest(&rays, &spheres, &options, &to, &batch::error()),
              RAYCHECK_INVALID_ARGUMENT);
    EXPECT_TRUE(has(batch::error().reason, "integers of 32 or 64 bits"));
  }
}

/// The answers about nearest spheres.
struct Seen {
  std::vector<std::int32_t> sphere, ties;
  std::vector<double> s, s_error, x, y, z;
  explicit Seen(std::size_t count)
      : sphere(count), ties(count), s(count), s_error(count), x(count), y(count), z(count) {}
  raycheck_seen to() {
    return {batch::output(sphere), batch::output(ties), batch::output(s), batch::output(x, y, z),
            batch::output(s_error)};
  }
  void compare(std::size_t k, const std::optional<exact::Nearest>& truth) {
    ASSERT_EQ(sphere[k], truth ? static_cast<int>(truth->index) : -1) << k;
    ASSERT_EQ(ties[k], truth ? static_cast<int>(truth->ties.size()) : 0) << k;
    if (!truth) {
      ASSERT_EQ(s[k], kInfinity);
      return;
    }
    ASSERT_LE(error_of(s[k], *truth->intersection.parameter), s_error[k] * (1 + 1e-4));
    ASSERT_LE(error_of(z[k], truth->intersection.point->z), 1e-5);
  }
};

TEST(Batch, FindsTheNearestSpheresAndTheirTies) {
  Many many;
  std::mt19937 random(8);
  const auto any = [&] { return static_cast<double>(static_cast<int>(random() % 7)) - 3; };
  while (many.rays.size() < 3000) {
    const Ray ray{{any(), any(), any() - 8}, {any() / 4, any() / 4, 1 + any() / 16}};
    many.rays.push_back(ray);
  }
  many.spheres = some_spheres(20);
  for (int k = 0; k < 30; ++k) many.spheres.push_back({{any(), any(), any()}, std::abs(any())});
  for (const auto& [tangent, t_max] :
       {std::pair(Tangent::hit, kInfinity), {Tangent::miss, kInfinity}, {Tangent::hit, 8.0}}) {
    Conventions conventions;
    conventions.tangent = tangent;
    conventions.valid.t_max = t_max;
    const raycheck_asked asked = asked_of(conventions);
    many.options.asked = &asked;
    const raycheck_rays rays = many.given();
    const raycheck_spheres spheres = many.balls();
    for (const int threads : {1, 2}) {
      many.options.threads = threads;
      Seen seen(many.rays.size());
      const raycheck_seen to = seen.to();
      ASSERT_EQ(raycheck_nearest(&rays, &spheres, &many.options, &to, &batch::error()),
                RAYCHECK_OK);
      int tied = 0;
      for (std::size_t k = 0; k < many.rays.size(); ++k) {
        seen.compare(k, exact::nearest(many.rays[k], many.spheres, conventions));
        if (HasFatalFailure()) return;
        tied += seen.ties[k] > 1 ? 1 : 0;
      }
      EXPECT_GT(tied, 50);
    }
  }
  many.spheres[3].radius = -1;  // is left out, and named
  many.rays[7].direction = {0, 0, 0};
  const raycheck_rays rays = many.given();
  const raycheck_spheres spheres = many.balls();
  many.options.asked = nullptr;
  Seen seen(many.rays.size());
  const raycheck_seen to = seen.to();
  ASSERT_EQ(raycheck_nearest(&rays, &spheres, &many.options, &to, &batch::error()),
            RAYCHECK_INVALID_INPUT);
  EXPECT_EQ(batch::error().index, 7u);
  EXPECT_TRUE(std::isnan(seen.s[7]) && seen.sphere[7] == -1);
  many.spheres[3] = {{1e6, 0, 0}, 1};
  seen.compare(8, exact::nearest(many.rays[8], many.spheres));
}

TEST(Batch, DrawsTheImageOfTheExactRays) {
  Camera camera = small_camera();
  std::vector<Sphere> spheres = some_spheres(12);
  // Two spheres that meet in a plane through the eye, in a column of pixels.
  for (const Origin origin : {Origin::pixel, Origin::focal}) {
    Conventions conventions;
    conventions.origin = origin;
    const raycheck_asked asked = asked_of(conventions);
    raycheck_options options = batch::options(2, &asked);
    const raycheck_camera seen_by = in_c(camera);
    Many many;
    many.spheres = spheres;
    const raycheck_spheres balls = many.balls();
    const std::size_t pixels = 48 * 35;
    Seen seen(pixels);
    const raycheck_seen to = seen.to();
    ASSERT_EQ(raycheck_image(&seen_by, &balls, &options, &to, &batch::error()), RAYCHECK_OK)
        << batch::error().reason;
    const exact::Camera known(camera, conventions);
    int tied = 0, seen_pixels = 0;
    for (std::size_t k = 0; k < pixels; ++k) {
      const auto pixel = static_cast<std::int64_t>(k);
      seen.compare(k, known.ray({pixel % 48, pixel / 48}).nearest(spheres, conventions));
      if (HasFatalFailure()) return;
      tied += seen.ties[k] > 1 ? 1 : 0;
      seen_pixels += seen.sphere[k] >= 0 ? 1 : 0;
    }
    EXPECT_GT(tied, 20);
    EXPECT_GT(seen_pixels, 80);
  }
}

/// Mirror images: every pixel of the middle column meets both spheres at one s.
TEST(Batch, CountsTheTiesOfDifferentSpheresInAnImage) {
  const Camera camera{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, -1, -.2, .2, -.2, .2, 33, 33};
  Many many;
  many.spheres = {{{-0.5, 0, 0}, 1}, {{0.5, 0, 0}, 1}, {{0.5, 0, 0}, 1}, {{7, 7, 7}, -1}};
  const raycheck_camera seen_by = in_c(camera);
  const raycheck_spheres balls = many.balls();
  const raycheck_options options = batch::options();
  std::vector<std::int64_t> sphere(33 * 33), ties(33 * 33);
  raycheck_seen to = {};
  to.ties = batch::output(ties);
  to.sphere = batch::output(sphere);
  ASSERT_EQ(raycheck_image(&seen_by, &balls, &options, &to, &batch::error()),
            RAYCHECK_INVALID_INPUT);
  EXPECT_EQ(batch::error().index, 3u);
  EXPECT_EQ(ties[16 * 33 + 16], 3);
  EXPECT_EQ(sphere[16 * 33 + 16], 0);
  EXPECT_EQ(ties[16 * 33 + 17], 2);
  EXPECT_EQ(sphere[16 * 33 + 17], 1);
  EXPECT_EQ(ties[16 * 33 + 15], 1);
  EXPECT_EQ(ties[0], 0);
  EXPECT_EQ(sphere[0], -1);
}

/// A number for each ray, and a vector for each ray.
struct Columns {
  std::array<std::vector<double>, 3> of;
  explicit Columns(std::size_t count) {
    for (auto& one : of) one.resize(count);
  }
  raycheck_output number() { return batch::output(of[0]); }
  raycheck_output3 vector() { return batch::output(of[0], of[1], of[2]); }
};

/// The values of rays of all sources are those of exact.h, for given rays and for a camera's.
TEST(Batch, EnclosesRoundsAndConditionsAsExactDoes) {
  Many many = hard_rays();
  many.rays.resize(1500);
  many.spheres.resize(1500);
  const raycheck_camera seen_by = in_c(small_camera());
  const exact::Camera known(small_camera());
  for (const bool is_of_camera : {false, true}) {
    if (is_of_camera) many.spheres.assign(1, {{0, 0, 0}, 4});
    raycheck_rays rays = many.given();
    if (is_of_camera) rays.camera = &seen_by;
    const std::size_t count = is_of_camera ? 48 * 35 : many.rays.size();
    const raycheck_spheres spheres = many.balls();
    const raycheck_options options = batch::options(2);
    Columns s_low(count), s_high(count), Q_low(count), Q_high(count), D_low(count), D_high(count),
        P_low(count), P_high(count), s(count), Q(count), D(count), P(count), s_k(count), Q_k(count),
        D_k(count), P_k(count);
    const raycheck_enclosed ends = {s_low.number(),  s_high.number(), Q_low.vector(),
                                    Q_high.vector(), D_low.vector(),  D_high.vector(),
                                    P_low.vector(),  P_high.vector()};
    const raycheck_values rounded = {s.number(), Q.vector(), D.vector(), P.vector()};
    const raycheck_values numbers = {s_k.number(), Q_k.vector(), D_k.vector(), P_k.vector()};
    ASSERT_EQ(raycheck_enclose(&rays, &spheres, &options, &ends, &batch::error()), RAYCHECK_OK);
    ASSERT_EQ(raycheck_round(&rays, &spheres, &options, &rounded, &batch::error()), RAYCHECK_OK);
    ASSERT_EQ(raycheck_condition(&rays, &spheres, &options, &numbers, &batch::error()),
              RAYCHECK_OK);
    int hits = 0;
    const auto compare = [&](std::size_t k, const exact::Number& number, const Columns& low,
                             const Columns& high, const Columns& value, const Columns& condition,
                             std::size_t axis) {
      const exact::Interval around = number.interval();
      ASSERT_EQ(low.of[axis][k], around.lower);
      ASSERT_EQ(high.of[axis][k], around.upper);
      ASSERT_EQ(value.of[axis][k], number.rounded());
      ASSERT_LE(low.of[axis][k], value.of[axis][k]);
      ASSERT_LE(value.of[axis][k], high.of[axis][k]);
      ASSERT_EQ(condition.of[axis][k], number.condition());
    };
    for (std::size_t k = 0; k < count; ++k) {
      const auto pixel = static_cast<std::int64_t>(k);
      const exact::Ray ray =
          is_of_camera ? known.ray({pixel % 48, pixel / 48}) : exact::Ray(many.rays[k]);
      const exact::Intersection met = ray.hit(many.spheres[is_of_camera ? 0 : k]);
      const exact::Numbers direction = ray.direction(), origin = ray.origin();
      compare(k, direction.y, D_low, D_high, D, D_k, 1);
      compare(k, origin.z, P_low, P_high, P, P_k, 2);
      if (HasFatalFailure()) return;
      if (!met.parameter) {
        ASSERT_TRUE(std::isnan(s.of[0][k]) && std::isnan(Q_high.of[2][k]));
        continue;
      }
      ++hits;
      compare(k, *met.parameter, s_low, s_high, s, s_k, 0);
      compare(k, met.point->x, Q_low, Q_high, Q, Q_k, 0);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(hits, 100);
  }
}

/// Floats are neighbours around the number, and rounded once.
TEST(Batch, RoundsOnceToFloats) {
  Many many;
  // s = 1 + 2^-24 + 2^-54 rounds to 1 + 2^-24 in double, and that to 1 in float.
  many.add({{0, 0, 0}, {1, 0, 0}}, {{3 + 0x1p-24, 0x1p-26, 0}, 2});
  const raycheck_rays rays = many.given();
  const raycheck_spheres spheres = many.balls();
  const raycheck_options options = batch::options();
  std::vector<float> s(1), low(1), high(1);
  raycheck_values to = {};
  to.s = batch::output(s);
  raycheck_enclosed ends = {};
  ends.s_lower = batch::output(low);
  ends.s_upper = batch::output(high);
  ASSERT_EQ(raycheck_round(&rays, &spheres, &options, &to, &batch::error()), RAYCHECK_OK);
  ASSERT_EQ(raycheck_enclose(&rays, &spheres, &options, &ends, &batch::error()), RAYCHECK_OK);
  EXPECT_EQ(s[0], std::nextafter(1.0F, 2.0F));
  EXPECT_EQ(low[0], 1.0F);
  EXPECT_EQ(high[0], std::nextafter(1.0F, 2.0F));
}

/// Bounds and condition numbers of floats are not below those of doubles.
TEST(Batch, RoundsBoundsOfFloatsUp) {
  const raycheck_camera camera = in_c(small_camera());
  Many many;
  many.spheres = some_spheres(12);
  raycheck_spheres spheres = many.balls();
  const raycheck_options options = batch::options();
  const std::size_t pixels = 48 * 35;
  std::vector<double> s(pixels), bound(pixels);
  std::vector<float> s_single(pixels), bound_single(pixels);
  raycheck_seen seen = {}, single = {};
  seen.s = batch::output(s);
  seen.s_error = batch::output(bound);
  single.s = batch::output(s_single);
  single.s_error = batch::output(bound_single);
  ASSERT_EQ(raycheck_image(&camera, &spheres, &options, &seen, nullptr), RAYCHECK_OK);
  ASSERT_EQ(raycheck_image(&camera, &spheres, &options, &single, nullptr), RAYCHECK_OK);
  int seen_pixels = 0;
  for (std::size_t k = 0; k < pixels; ++k) {
    if (!std::isfinite(s[k])) continue;
    ++seen_pixels;
    ASSERT_GE(static_cast<double>(bound_single[k]),
              std::abs(static_cast<double>(s_single[k]) - s[k]) + bound[k])
        << k;
  }
  EXPECT_GT(seen_pixels, 80);
  // The same bounds, whose s are doubles.
  single.s = batch::output(s);
  ASSERT_EQ(raycheck_image(&camera, &spheres, &options, &single, nullptr), RAYCHECK_OK);
  for (std::size_t k = 0; k < pixels; ++k)
    ASSERT_GE(static_cast<double>(bound_single[k]), bound[k]);
  raycheck_rays rays = {};
  rays.camera = &camera;
  spheres.centre.count = spheres.radius.count = 1;
  raycheck_values to = {}, to_single = {};
  to.s = batch::output(bound);
  to_single.s = batch::output(bound_single);
  ASSERT_EQ(raycheck_condition(&rays, &spheres, &options, &to, nullptr), RAYCHECK_OK);
  ASSERT_EQ(raycheck_condition(&rays, &spheres, &options, &to_single, nullptr), RAYCHECK_OK);
  int hits = 0;
  for (std::size_t k = 0; k < pixels; ++k) {
    if (std::isnan(bound[k])) continue;
    ++hits;
    ASSERT_GE(static_cast<double>(bound_single[k]), bound[k]);
  }
  EXPECT_GT(hits, 5);
}

/// Errors are those that exact.h measures; wrong classes, roots and excuses are found.
TEST(Batch, JudgesTheAnswersOfOthers) {
  Many many = hard_rays();
  ASSERT_EQ(many.decide(), RAYCHECK_OK);
  const std::size_t count = many.rays.size();
  std::vector<std::uint8_t> is_hit(count);
  std::vector<double> s = many.s;
  std::vector<int> wrong_class(count, 0);
  for (std::size_t k = 0; k < count; ++k) {
    is_hit[k] = many.hit_class[k] == RAYCHECK_MISS ? 0 : 1;
    if (k % 5 == 0) s[k] = std::nextafter(std::nextafter(s[k], kInfinity), kInfinity);
    if (k % 11 == 0) {
      is_hit[k] = 1 - is_hit[k];
      wrong_class[k] = 1;
      if (is_hit[k] == 1) s[k] = 1;
    }
  }
  const raycheck_rays rays = many.given();
  const raycheck_spheres spheres = many.balls();
  std::vector<std::uint8_t> class_error(count), root_error(count), excused(count);
  std::vector<double> s_ulp(count), point_u(count);
  raycheck_answers answers = {};
  answers.is_hit = batch::array(is_hit);
  answers.s = batch::array(s);
  answers.point = batch::array(many.point[0], many.point[1], many.point[2]);
  const raycheck_errors to = {batch::output(class_error), batch::output(root_error),
                              batch::output(excused), batch::output(s_ulp), batch::output(point_u)};
  const raycheck_options options = batch::options(2);
  ASSERT_EQ(raycheck_error_of(&rays, &spheres, &options, &answers, &to, &batch::error()),
            RAYCHECK_OK);
  int compared = 0, excuses = 0, convicted = 0;
  for (std::size_t k = 0; k < count; ++k) {
    ASSERT_EQ(class_error[k], wrong_class[k]) << k;
    excuses += excused[k];
    convicted += class_error[k] != 0 && excused[k] == 0 ? 1 : 0;
    if (class_error[k] != 0 || is_hit[k] == 0) {
      ASSERT_EQ(s_ulp[k], 0);
      continue;
    }
    ASSERT_EQ(excused[k], 0);
    if (k % 3 != 0) continue;
    ++compared;
    const double expected = exact::hit(many.rays[k], many.spheres[k]).parameter->ulp_error(s[k]);
    ASSERT_GE(s_ulp[k], expected * (1 - 1e-4)) << k;
    ASSERT_LE(s_ulp[k], expected * (1 + 1e-4) + 0x1p-12) << k;
    if (!std::isfinite(many.s[k])) continue;
    const auto size = [&](const auto& of) { return std::hypot(of[0][k], of[1][k], of[2][k]); };
    ASSERT_LE(point_u[k] * 0x1p-53 * size(many.point), size(many.point_error) * 1.001) << k;
  }
  EXPECT_GT(compared, 5000);
  EXPECT_GT(excuses, 50);
  EXPECT_GT(convicted, 500);
  // The far root, and none that is near it.
  Many two;
  two.add({{0, 0, 0}, {0, 0, 1}}, {{0, 0, 5}, 1});
  two.add({{0, 0, 0}, {0, 0, 1}}, {{0, 0, 5}, 1});
  const std::vector<double> roots = {6, 4.4};
  const std::vector<std::int32_t> hits = {1, 1};
  const raycheck_rays its_rays = two.given();
  const raycheck_spheres its_spheres = two.balls();
  answers = {};
  answers.is_hit = batch::array(hits);
  answers.s = batch::array(roots);
  std::vector<std::int32_t> wrong(2);
  raycheck_errors only = {};
  only.root = batch::output(wrong);
  ASSERT_EQ(raycheck_error_of(&its_rays, &its_spheres, &options, &answers, &only, &batch::error()),
            RAYCHECK_OK);
  EXPECT_EQ(wrong[0], 1);
  EXPECT_EQ(wrong[1], 0);
}

/// The roots are 1 and 1 - 2/(D^2 + 1), which rounds to 1, too, or to the number below.
TEST(Batch, ConvictsNoRoundedRoot) {
  Many two;
  for (const double D : {0x1p28, 0x1p27}) two.add({{0, 0, 0}, {1, 0, D}}, {{0, 0, D}, 1});
  ASSERT_EQ(two.decide(), RAYCHECK_OK);
  EXPECT_EQ(two.root[0], 0);
  const std::vector<double> s = {1, 1 - 0x1p-53};
  const std::vector<std::uint8_t> hits = {1, 1};
  EXPECT_EQ(two.s[0], s[0]);
  const raycheck_rays rays = two.given();
  const raycheck_spheres spheres = two.balls();
  raycheck_answers answers = {};
  answers.is_hit = batch::array(hits);
  answers.s = batch::array(s);
  std::vector<std::uint8_t> wrong(2, 77);
  raycheck_errors to = {};
  to.root = batch::output(wrong);
  const raycheck_options options = batch::options();
  ASSERT_EQ(raycheck_error_of(&rays, &spheres, &options, &answers, &to, &batch::error()),
            RAYCHECK_OK);
  EXPECT_EQ(wrong[0], 0);
  EXPECT_EQ(wrong[1], 0);
}

/// The square of |Q| overflows; the second answer is off by 2^-30 of |Q|.
TEST(Batch, MeasuresPointsThatAreFarFromTheOrigin) {
  Many two;
  for (int k = 0; k < 2; ++k) two.add({{0x1p530, 0, 0}, {0, 1, 0}}, {{0x1p530, 5, 0}, 1});
  ASSERT_EQ(two.decide(), RAYCHECK_OK);
  const std::vector<std::uint8_t> hits = {1, 1};
  two.point[1] = {4, 0x1p500};
  const raycheck_rays rays = two.given();
  const raycheck_spheres spheres = two.balls();
  raycheck_answers answers = {};
  answers.is_hit = batch::array(hits);
  answers.point = batch::array(two.point[0], two.point[1], two.point[2]);
  std::vector<double> point_u(2);
  raycheck_errors to = {};
  to.point_u = batch::output(point_u);
  const raycheck_options options = batch::options();
  ASSERT_EQ(raycheck_error_of(&rays, &spheres, &options, &answers, &to, &batch::error()),
            RAYCHECK_OK);
  EXPECT_LE(point_u[0], 0x1p-12);
  EXPECT_NEAR(point_u[1], 0x1p23, 0x1p8);
}

/// Ray 0 passes the sphere at 2^-50, ray 1 at 1.
TEST(Batch, ExcusesHitsWithoutTheirS) {
  Many two;
  for (const double gap : {0x1p-50, 1.0}) two.add({{0, 1 + gap, 0}, {0, 0, 1}}, {{0, 0, 5}, 1});
  const std::vector<std::uint8_t> hits = {1, 1};
  const raycheck_rays rays = two.given();
  const raycheck_spheres spheres = two.balls();
  raycheck_answers answers = {};
  answers.is_hit = batch::array(hits);
  std::vector<std::uint8_t> wrong(2), excused(2, 77);
  raycheck_errors to = {};
  to.hit_class = batch::output(wrong);
  to.excused = batch::output(excused);
  const raycheck_options options = batch::options();
  ASSERT_EQ(raycheck_error_of(&rays, &spheres, &options, &answers, &to, &batch::error()),
            RAYCHECK_OK);
  EXPECT_EQ(wrong, (std::vector<std::uint8_t>{1, 1}));
  EXPECT_EQ(excused, (std::vector<std::uint8_t>{1, 0}));
}

}  // namespace
}  // namespace raycheck::tests
