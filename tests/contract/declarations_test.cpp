#include "contract/declarations.h"

#include <raycheck/candidate.h>

#include <raycheck/candidate.hpp>

#include "contract/public_structs.h"
#include "tests/testing.h"

namespace raycheck::contract {
namespace {

Declarations declared(std::string_view contract) {
  Declarations all;
  declare_all(contract, all);
  return all;
}

TEST(Declarations, are_read_from_the_statements_that_they_write) {
  std::vector<std::string> tried = {"roots as-asked", "roots () 1e-04 100 radius back-faces",
                                    "lengths 1e-30 1e+30"};
  const Declarations usual;
  for_each_tolerance(usual.tolerances, [&](const std::string& name, double, auto) {
    tried.push_back(name + " 1e-12");
  });
  for_each_declaration(usual, [&](const std::string& name, const auto& value, auto) {
    if constexpr (requires { words_of(*value); }) {
      for (const auto word : words_of(*value)) tried.push_back(name + " " + std::string(word));
    } else if constexpr (requires { words_of(value); }) {
      for (const auto word : words_of(value)) {
        if (word != words_of(value)[0]) tried.push_back(name + " " + std::string(word));
      }
    }
  });
  for (const std::string& one : tried) EXPECT_EQ(statements(declared(one)), std::vector{one});
  EXPECT_GT(tried.size(), 30u);
  EXPECT_TRUE(statements({}).empty());
}

TEST(Declarations, of_several_statements_are_all_taken) {
  const Declarations all = declared(
      " t_min 0x1p-10;\n interval (] ;; convention rows top-first; convention root smaller;");
  EXPECT_EQ(all.conventions.valid,
            (scene::ValidRoots{.t_min = 0x1p-10, .ends = scene::Ends::kOpenMin}));
  EXPECT_EQ(all.conventions.rows, scene::Rows::kTopFirst);
}

TEST(Declarations, that_are_unknown_or_malformed_are_refused_with_what_is_expected) {
  for (const auto& [contract, why] :
       {std::pair("rows up", "'up', not one of bottom-first, top-first"),
        {"level", "too few words"},
        {"rows top-first; t_min 1; rows bottom-first", "the contract declares rows twice"},
        {"returns hit point", "too many words"},
        {"t_min soon", "not a number"},
        {"samplez edges",
         "'samplez', not one of rows, samples, corners, origin, root, tangent, roots, level"}}) {
    EXPECT_TRUE(has(thrown_by<std::invalid_argument>([&] { declared(contract); }), why));
  }
  for (const auto& [contract, field] :
       {std::pair("lengths 2 1", "lengths"),
        {"lengths nan 1", "lengths"},
        {"lengths inf inf", "lengths"},
        {"t_min 2; t_max 1", "conventions.t_max"},
        {"t_min -1", "conventions.t_min"},
        {"tolerance_c -1", "tolerance_c"},
        {"rays end; directions unit", "rays"},
        {"from_inside start; t_min 0.1", "from_inside"},
        {"from_inside start; returns roots", "from_inside"},
        {"from_inside near-root; returns squared-distance", "from_inside"},
        {"tolerance_c -1", "tolerance_c"},
        {"tolerance_d_sq nan", "tolerance_d_sq"},
        {"tolerance_s inf", "tolerance_s"}}) {
    const std::vector<scene::Defect> found = defects(declared(contract));
    ASSERT_EQ(found.size(), 1u) << contract;
    EXPECT_EQ(found[0].field, field);
  }
}

/// Whether the public enumerators from `first` on are raycheck's, of which the last is this one.
template <class Enum>
testing::AssertionResult has_enumerators(int first, int last, Enum value = {}) {
  const int count = static_cast<int>(names_of(value).size());
  if (last - first + 1 != count) return testing::AssertionFailure() << count;
  for (int k = 0; k < count; ++k) {
    from_public(first + k, "it", value, first);
    if (static_cast<int>(value) != k) return testing::AssertionFailure() << k;
  }
  const std::string why =
      thrown_by<std::invalid_argument>([&] { from_public(last + 1, "it", value, first); });
  return has(why, "it = " + std::to_string(last + 1) + ": expected " + std::to_string(first));
}

TEST(PublicStructs, have_the_enumerators_of_raycheck_in_C_and_in_CPlusPlus) {
  EXPECT_TRUE(has_enumerators<scene::Rows>(1, RAYCHECK_ROWS_TOP_FIRST));
  EXPECT_TRUE(has_enumerators<scene::Samples>(1, RAYCHECK_SAMPLES_CORNERS));
  EXPECT_TRUE(has_enumerators<scene::Origin>(1, RAYCHECK_ORIGIN_FOCAL));
  EXPECT_TRUE(has_enumerators<scene::Root>(1, RAYCHECK_ROOT_SMALLER));
  EXPECT_TRUE(has_enumerators<scene::Tangent>(1, RAYCHECK_TANGENT_EITHER));
  EXPECT_TRUE(has_enumerators<Level>(1, RAYCHECK_LEVEL_EXTREME));
  EXPECT_TRUE(has_enumerators<scene::Ends>(0, RAYCHECK_ENDS_OPEN));
  EXPECT_TRUE(has_enumerators<scene::TUnit>(0, RAYCHECK_T_LENGTH));
  EXPECT_TRUE(has_enumerators<scene::Culling>(0, RAYCHECK_CULL_FRONT_FACES));
  EXPECT_TRUE(has_enumerators<RootsOf>(0, RAYCHECK_ROOTS_AS_ASKED));
  EXPECT_TRUE(has_enumerators<scene::Precision>(0, RAYCHECK_PRECISION_SINGLE));
  EXPECT_TRUE(has_enumerators<Directions>(0, RAYCHECK_DIRECTIONS_UNIT));
  EXPECT_TRUE(has_enumerators<Returns>(0, RAYCHECK_RETURNS_ROOTS));
  EXPECT_EQ(static_cast<int>(raycheck::Rows::top_first), RAYCHECK_ROWS_TOP_FIRST);
  EXPECT_EQ(static_cast<int>(raycheck::Samples::centres), RAYCHECK_SAMPLES_CENTRES);
  EXPECT_EQ(static_cast<int>(raycheck::Samples::corners), RAYCHECK_SAMPLES_CORNERS);
  EXPECT_EQ(static_cast<int>(raycheck::Origin::focal), RAYCHECK_ORIGIN_FOCAL);
  EXPECT_EQ(static_cast<int>(raycheck::Root::smaller), RAYCHECK_ROOT_SMALLER);
  EXPECT_EQ(static_cast<int>(raycheck::Tangent::either), RAYCHECK_TANGENT_EITHER);
  EXPECT_EQ(static_cast<int>(raycheck::Level::extreme), RAYCHECK_LEVEL_EXTREME);
  EXPECT_EQ(static_cast<int>(raycheck::Ends::open), RAYCHECK_ENDS_OPEN);
  EXPECT_EQ(static_cast<int>(raycheck::TUnit::length), RAYCHECK_T_LENGTH);
  EXPECT_EQ(static_cast<int>(raycheck::Culling::front_faces), RAYCHECK_CULL_FRONT_FACES);
  EXPECT_EQ(static_cast<int>(raycheck::Roots::as_asked), RAYCHECK_ROOTS_AS_ASKED);
  EXPECT_EQ(static_cast<int>(raycheck::Precision::single), RAYCHECK_PRECISION_SINGLE);
  EXPECT_EQ(static_cast<int>(raycheck::Directions::unit), RAYCHECK_DIRECTIONS_UNIT);
  EXPECT_EQ(static_cast<int>(raycheck::Returns::roots), RAYCHECK_RETURNS_ROOTS);
}

TEST(PublicStructs, keep_every_member_of_a_camera_and_of_conventions) {
  const scene::Camera camera = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, -1, {}, -2, 3, -4, 5, 6, 7};
  EXPECT_EQ(contract::camera(contract::camera<raycheck_camera>(camera)), camera);
  EXPECT_EQ(contract::camera(contract::camera<raycheck::Camera>(camera)), camera);
  scene::Conventions conventions = {scene::Rows::kTopFirst, scene::Samples::kCentres,
                                    scene::Origin::kFocal, scene::Root::kSmaller,
                                    scene::Tangent::kEither};
  conventions.valid = {1, 2, scene::Ends::kOpenMin, scene::TUnit::kLength,
                       scene::Culling::kFrontFaces};
  const auto back = [&](const auto& fixed, const auto& roots) {
    scene::Conventions same = declared_conventions(fixed).over(scene::Conventions{});
    same.valid = valid_roots(roots);
    return same;
  };
  EXPECT_EQ(back(contract::conventions<raycheck_conventions>(conventions),
                 valid_roots<raycheck_valid_roots>(conventions.valid)),
            conventions);
  EXPECT_EQ(back(contract::conventions<raycheck::Conventions>(conventions),
                 valid_roots<raycheck::ValidRoots>(conventions.valid)),
            conventions);
}

TEST(PublicStructs, declare_what_the_header_of_their_version_has) {
  raycheck_candidate library = {};
  library.declared.root = RAYCHECK_ROOT_SMALLER;
  library.level = RAYCHECK_LEVEL_EXTREME;
  library.largest_length = 2;
  library.precision = RAYCHECK_PRECISION_SINGLE;
  library.roots = RAYCHECK_ROOTS_AS_ASKED;
  library.returns = RAYCHECK_RETURNS_POINT;
  library.contract = "rows top-first";
  const std::vector<std::vector<std::string>> by_version = {{"root smaller"},
                                                            {"lengths 0 2", "level extreme"},
                                                            {"precision single", "roots as-asked"},
                                                            {"returns point"},
                                                            {"rows top-first"},
                                                            {}};
  std::vector<std::string> expected;
  for (std::uint32_t version = 1; version <= by_version.size(); ++version) {
    const std::vector<std::string>& more = by_version[version - 1];
    expected.insert(expected.end(), more.begin(), more.end());
    std::ranges::sort(expected);
    EXPECT_EQ(statements(declarations(library, library.declared, library.declared_roots, version)),
              expected);
  }
  EXPECT_EQ(by_version.size(), std::size_t{RAYCHECK_CANDIDATE_VERSION});
  library.smallest_length = 2;
  library.largest_length = 0;  // no bound
  const Declarations declared = declarations(library, library.declared, library.declared_roots, 2);
  EXPECT_EQ(declared.lengths, (Lengths{.smallest = 2}));
  EXPECT_TRUE(defects(declared).empty());
}

}  // namespace
}  // namespace raycheck::contract
