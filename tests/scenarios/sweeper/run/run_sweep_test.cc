#include "scenarios/sweeper/run/run_sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "models/error.h"
#include "scenarios/sweeper/run/fly_row.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::sweeper {
namespace {

namespace fs = std::filesystem;
using testing::UnorderedElementsAre;

FlightRow FlownRow(const std::string& id) {
  return {.id = id, .process = ProcessEnd::kFlown, .verdict = runner::Verdict::kPass};
}

class CollectRowsTest : public testing::Test {
 protected:
  void Collect() {
    SweepStore store(folder_.path(), SweepStore::Access::kWrite);
    CollectRows(folder_.path(), store);
  }
  std::vector<std::string> RowFiles() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / "rows")) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }
  void MakeOld(const char* name) const {
    fs::last_write_time(folder_ / name, fs::file_time_type::clock::now() - std::chrono::hours(1));
  }

  const tests::TemporaryFolder folder_;
};

TEST_F(CollectRowsTest, CollectsRowsAndRenamesDamagedFiles) {
  RowFolder(folder_.path()).Write(FlownRow("complete"));
  folder_.Put("rows/empty.json", "");
  folder_.Put("rows/half.json", RowJson(FlownRow("half")).substr(0, 40));
  nlohmann::json other = nlohmann::json::parse(RowJson(FlownRow("end")));
  other["process"] = "flow";
  folder_.Put("rows/end.json", other.dump());
  other["process"] = "flown";
  other["verdict"] = "maybe";
  folder_.Put("rows/verdict.json", other.dump());
  other["verdict"] = "pass";
  other["schema"] = "one";
  folder_.Put("rows/schema.json", other.dump());
  folder_.Put("rows/.new.json.partial-1", "being written");
  folder_.Put("rows/.old.json.partial-2", "from a killed program");
  for (const char* name : {"rows/half.json", "rows/.old.json.partial-2"}) MakeOld(name);
  Collect();
  EXPECT_THAT(RowFiles(), UnorderedElementsAre("empty.damaged", "half.damaged", "end.damaged", "verdict.damaged",
                                               "schema.damaged", ".new.json.partial-1"));
  const SweepStore store(folder_.path(), SweepStore::Access::kRead);
  EXPECT_TRUE(store.Find("complete"));
  EXPECT_FALSE(store.Find("half"));
}

TEST_F(CollectRowsTest, KeepsUnreadableFiles) {
  fs::create_directories(folder_ / "rows/unreadable.json");
  EXPECT_THROW(Collect(), InputError);
  EXPECT_THAT(RowFiles(), UnorderedElementsAre("unreadable.json"));
}

TEST(ShardOf, DividesCellsAndFlightsEvenly) {
  constexpr int kSeeds = 6, kCells = 4;
  for (const int shards : {1, 2, 3, 4, 5}) {
    SweepPlan plan{.keys = {"cell"}, .total = kSeeds * kCells};
    for (int i = 0; i < kSeeds * kCells; ++i) {
      plan.flights.push_back({.position = i,
                              .id = std::to_string(i),
                              .seed = static_cast<std::uint64_t>(i / kCells),
                              .values = {std::to_string(i % kCells)}});
    }
    std::set<std::int64_t> positions;
    for (int shard = 0; shard < shards; ++shard) {
      const SweepPlan part = ShardOf(plan, shard, shards);
      EXPECT_EQ(part.total, plan.total);
      EXPECT_NEAR(static_cast<double>(part.flights.size()), 1.0 * kSeeds * kCells / shards, 1.0 + kCells);
      std::set<std::string> cells;
      for (const PlannedFlight& flight : part.flights) {
        EXPECT_TRUE(positions.insert(flight.position).second);
        cells.insert(flight.values.front());
      }
      EXPECT_EQ(cells.size(), static_cast<std::size_t>(kCells)) << shard << " of " << shards;
    }
    EXPECT_EQ(positions.size(), plan.flights.size());
  }
}

}  // namespace
}  // namespace touchdown::sweeper
