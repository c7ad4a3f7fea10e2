#include "scenarios/sweep/run_sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "models/error.h"
#include "scenarios/sweep/fly_row.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::scenarios {
namespace {

namespace fs = std::filesystem;
using testing::UnorderedElementsAre;

FlightRow Row(const std::string& id) { return {.id = id, .end = RowEnd::kFlown, .verdict = "pass"}; }

class TakeInRowsTest : public testing::Test {
 protected:
  void TakeIn() {
    SweepStore store(folder_.path(), SweepStore::Access::kWrite);
    TakeInRows(folder_.path(), store);
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

TEST_F(TakeInRowsTest, TakesWholeRowsAndSetsDamagedOnesAside) {
  RowFolder(folder_.path()).Leave(Row("whole"));
  folder_.Put("rows/empty.json", "");
  folder_.Put("rows/half.json", RowJson(Row("half")).substr(0, 40));
  folder_.Put("rows/.new.json.partial-1", "being written");
  folder_.Put("rows/.old.json.partial-2", "left by a program that was ended");
  for (const char* name : {"rows/half.json", "rows/.old.json.partial-2"}) MakeOld(name);
  TakeIn();
  EXPECT_THAT(RowFiles(), UnorderedElementsAre("empty.damaged", "half.damaged", ".new.json.partial-1"));
  const SweepStore store(folder_.path(), SweepStore::Access::kRead);
  EXPECT_TRUE(store.Find("whole"));
  EXPECT_FALSE(store.Find("half"));
}

TEST_F(TakeInRowsTest, KeepsWhatCannotBeRead) {
  fs::create_directories(folder_ / "rows/unreadable.json");
  EXPECT_THROW(TakeIn(), InputError);
  EXPECT_THAT(RowFiles(), UnorderedElementsAre("unreadable.json"));
}

}  // namespace
}  // namespace touchdown::scenarios
