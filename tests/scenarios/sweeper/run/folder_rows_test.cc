#include "scenarios/sweeper/run/folder_rows.h"

#include <gtest/gtest.h>

#include "scenarios/sweeper/run/fly_row.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::sweeper {
namespace {

TEST(FolderRows, AreWhatTakingThemInWouldLeave) {
  const tests::TemporaryFolder folder;
  SweepStore store(folder.path(), SweepStore::Access::kWrite);
  const RowFolder left(folder.path());
  store.Put({.id = "stored", .end = RowEnd::kFlown});
  store.Put({.id = "flown before", .end = RowEnd::kFlown});
  left.Leave({.id = "flown before", .end = RowEnd::kCrashed});
  store.Put({.id = "flown now", .end = RowEnd::kCrashed});
  left.Leave({.id = "flown now", .end = RowEnd::kFlown});
  store.Put({.id = "not flown", .end = RowEnd::kCrashed});
  left.Leave({.id = "not flown", .end = RowEnd::kHung});

  const FolderRows rows(folder.path(), &store);
  for (const char* id : {"stored", "flown before", "flown now"}) EXPECT_EQ(rows.Find(id)->end, RowEnd::kFlown) << id;
  EXPECT_EQ(rows.Find("not flown")->end, RowEnd::kHung);
  EXPECT_FALSE(rows.Find("none"));
  EXPECT_EQ(FolderRows(folder.path(), nullptr).Find("flown before")->end, RowEnd::kCrashed);
  EXPECT_FALSE(FolderRows(folder.path(), nullptr).Find("stored"));
}

}  // namespace
}  // namespace touchdown::sweeper
