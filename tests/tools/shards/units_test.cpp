#include "tools/shards/units.h"

#include <limits>

#include "properties/quantile_sketch.h"
#include "tests/tools/limited_run.h"
#include "tools/shards/run_units.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

const CampaignIdentity kCampaign = {"properties", {"--cases", "2"}, "1", {}};

/// A folder that is not there yet, and goes with the test.
fs::path fresh_folder(const std::string& name) {
  static const fs::path all = tests::temporary_folder("units");
  return all / name;
}

TEST(Units, are_each_done_by_one_shard) {
  std::vector<int> done(100);
  for (std::int64_t k = 1; k <= 7; ++k) {
    Units shard(kCampaign, fresh_folder("one"), {k, 7, {}});
    for (const std::int64_t unit : shard.open(100)) ++done[static_cast<std::size_t>(unit)];
  }
  EXPECT_EQ(done, std::vector<int>(100, 1));
}

TEST(Units, that_contradict_each_other_are_named) {
  const fs::path a = fresh_folder("a"), b = fresh_folder("b");
  for (const auto& [folder, result] : {std::pair(a, "one"), {b, "another"}}) {
    Units units(kCampaign, folder, {});
    units.open(1);
    units.write(0, result);
  }
  Units both(kCampaign, std::vector<fs::path>{a, b});
  both.open(1);
  try {
    both.read(0);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_TRUE(has(error.what(), "contradict each other")) << error.what();
    EXPECT_TRUE(has(error.what(), a.string()));
    EXPECT_TRUE(has(error.what(), b.string()));
  }
}

TEST(Units, keep_every_bit_of_a_sketch) {
  properties::QuantileSketch sketch;
  const double kTiny = std::numeric_limits<double>::denorm_min();
  for (const double x :
       {0.0, kTiny, 3 * kTiny, 0x1.23456789p-1030, 0.1, 0.1, 1e300,
        std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity()}) {
    sketch.add(x);
  }
  for (int k = 0; k < 3000; ++k) sketch.add(k * 0.37);
  const auto again = from_bytes<properties::QuantileSketch>(to_bytes(sketch));
  EXPECT_TRUE(again == sketch);
  EXPECT_EQ(again.quantile(0.999), sketch.quantile(0.999));
}

}  // namespace
}  // namespace raycheck::tools
