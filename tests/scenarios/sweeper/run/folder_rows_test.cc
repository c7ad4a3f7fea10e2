#include "scenarios/sweeper/run/folder_rows.h"

#include <gtest/gtest.h>

#include "scenarios/sweeper/run/fly_row.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::sweeper {
namespace {

TEST(FolderRows, MatchTheResultOfCollecting) {
  const tests::TemporaryFolder folder;
  SweepStore store(folder.path(), SweepStore::Access::kWrite);
  const RowFolder row_files(folder.path());
  store.Put({.id = "stored", .process = ProcessEnd::kFlown});
  store.Put({.id = "flown before", .process = ProcessEnd::kFlown});
  row_files.Write({.id = "flown before", .process = ProcessEnd::kCrashed});
  store.Put({.id = "flown now", .process = ProcessEnd::kCrashed});
  row_files.Write({.id = "flown now", .process = ProcessEnd::kFlown});
  store.Put({.id = "not flown", .process = ProcessEnd::kCrashed});
  row_files.Write({.id = "not flown", .process = ProcessEnd::kHung});

  const FolderRows rows(folder.path(), &store);
  for (const char* id : {"stored", "flown before", "flown now"})
    EXPECT_EQ(rows.Find(id)->process, ProcessEnd::kFlown) << id;
  EXPECT_EQ(rows.Find("not flown")->process, ProcessEnd::kHung);
  EXPECT_FALSE(rows.Find("none"));
  EXPECT_EQ(FolderRows(folder.path(), nullptr).Find("flown before")->process, ProcessEnd::kCrashed);
  EXPECT_FALSE(FolderRows(folder.path(), nullptr).Find("stored"));
}

}  // namespace
}  // namespace touchdown::sweeper
