// The flat interface answers as the exact ray does, within the bounds that it returns, for every
// layout of the arrays and any number of threads; and it names what is not valid.

#include "tests/library/batch.h"

namespace raycheck::tests {
namespace {

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

}  // namespace
}  // namespace raycheck::tests
