#include "scenarios/sweeper/plan/sweep_store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "models/error.h"
#include "scenarios/sweeper/analysis/rows_csv.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::sweeper {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

SweepPlan PlanOf(const std::vector<std::string>& ids) {
  SweepPlan plan{.keys = {"camera.noise_sigma", "start.yaw_deg"}, .flights = {}};
  for (const std::string& id : ids) {
    plan.flights.push_back(
        {.position = static_cast<std::int64_t>(plan.flights.size()), .id = id, .seed = 7, .values = {"3", "1.5"}});
  }
  return plan;
}

SweepSpec Spec() {
  return {.name = "sweep",
          .description = "For people: \"so\".",
          .axes = {{"camera.noise_sigma", {"3", "4.5"}}, {"start.yaw_deg", {}}},
          .variants = {"a", "b"},
          .criteria = {{.metric = "pass_rate", .min = 0.9, .max = 1.0},
                       {.metric = "flight.sim_time_s", .quantile = 0.25, .max = 0.1 + 0.2, .by = JudgedBy::kInterval}},
          .stop_when = StopWhen{.good_pass_rate = 0.9, .bad_pass_rate = 0.8},
          .search = SearchedBoundary{"camera.noise_sigma", 3.0, 4.5, 0.9}};
}

FlightRow Row(const std::string& id, runner::Verdict verdict = runner::Verdict::kPass,
              const std::string& program = "this") {
  return {.id = id,
          .program = program,
          .version = "1",
          .host = "h",
          .process = ProcessEnd::kFlown,
          .verdict = verdict,
          .outcome = runner::Outcome::kLanded,
          .metrics = {{"flight.sim_time_s", 0.1 + 0.2}, {"estimate.false_pads", 2.0}},
          .log_sha256 = "abc",
          .wall_s = 2.5,
          .stderr_tail = "a line\n",
          .scenario = "seed: 7\n"};
}

class SweepStoreTest : public testing::Test {
 protected:
  SweepStore Open(SweepStore::Access access = SweepStore::Access::kWrite) { return {folder_.path(), access}; }
  std::string ErrorOnOpening(SweepStore::Access access) {
    try {
      Open(access);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  const tests::TemporaryFolder folder_;
};

TEST_F(SweepStoreTest, ReadsBackStoredRows) {
  {
    SweepStore store = Open();
    store.SetPlan(Spec(), PlanOf({"a", "b"}), "this");
    store.Put(Row("a", runner::Verdict::kFail));
  }
  const SweepStore store = Open(SweepStore::Access::kRead);
  EXPECT_EQ(store.planned(), 2u);
  EXPECT_EQ(RowJson(store.Find("a").value()), RowJson(Row("a", runner::Verdict::kFail)));
  EXPECT_EQ(store.Find("b"), std::nullopt);
  const std::vector<SweepResult> results = store.Results();
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].seed, 7u);
  EXPECT_THAT(results[0].values, ElementsAre("3", "1.5"));
  EXPECT_EQ(results[0].row.metrics.at("flight.sim_time_s"), 0.1 + 0.2) << "to the last bit";
}

TEST_F(SweepStoreTest, StoresTheSpecification) {
  EXPECT_THAT(Open().spec().keys(), testing::IsEmpty()) << "no plan yet";
  Open().SetPlan(Spec(), PlanOf({"a"}), "this");
  const SweepSpec spec = Open(SweepStore::Access::kRead).spec();
  EXPECT_EQ(spec.name, "sweep");
  EXPECT_EQ(spec.description, "For people: \"so\".");
  EXPECT_THAT(spec.keys(), ElementsAre("camera.noise_sigma", "start.yaw_deg"));
  EXPECT_THAT(spec.axes[0].listed, ElementsAre("3", "4.5"));
  EXPECT_THAT(spec.axes[1].listed, testing::IsEmpty());
  EXPECT_THAT(spec.variants, ElementsAre("a", "b"));
  ASSERT_EQ(spec.criteria.size(), 2u);
  EXPECT_EQ(spec.criteria[0].quantile, std::nullopt);
  EXPECT_EQ(spec.criteria[0].min, 0.9);
  EXPECT_EQ(spec.criteria[0].max, 1.0);
  EXPECT_EQ(spec.criteria[1].metric, "flight.sim_time_s");
  EXPECT_EQ(spec.criteria[1].quantile, 0.25);
  EXPECT_EQ(spec.criteria[1].min, std::nullopt);
  EXPECT_EQ(spec.criteria[1].max, 0.1 + 0.2) << "to the last bit";
  EXPECT_EQ(spec.criteria[0].by, JudgedBy::kValue);
  EXPECT_EQ(spec.criteria[1].by, JudgedBy::kInterval);
  ASSERT_TRUE(spec.stop_when);
  EXPECT_EQ(spec.stop_when->bad_pass_rate, 0.8);
  ASSERT_TRUE(spec.search);
  EXPECT_EQ(spec.search->key, "camera.noise_sigma");
  EXPECT_EQ(spec.search->max, 4.5);
  EXPECT_EQ(spec.search->pass_rate, 0.9);
}

TEST(SweepSpec, ReadsASweepFileAndRoundTripsJson) {
  const SweepFile file{
      .name = "n",
      .description = "d",
      .parameters = {{.key = "a", .values = ListedValues{{"1", "2"}}}, {.key = "b", .values = UniformValues{}}},
      .variants = {{.name = "v"}, {.name = "w"}},
      .criteria = {{.metric = "pass_rate", .min = 0.5}}};
  const SweepSpec spec = SpecOf(file);
  EXPECT_THAT(spec.axes[0].listed, ElementsAre("1", "2"));
  EXPECT_THAT(spec.axes[1].listed, testing::IsEmpty());
  EXPECT_THAT(spec.variants, ElementsAre("v", "w"));
  EXPECT_THAT(SpecOf({.variants = std::vector<SweepVariant>(1)}).variants, testing::IsEmpty());
  EXPECT_EQ(SpecJson(SpecFromJson(SpecJson(spec))), SpecJson(spec));
  EXPECT_THROW(SpecFromJson("{}"), InputError);
  EXPECT_THROW(SpecFromJson("no json"), InputError);
}

TEST_F(SweepStoreTest, CountsARepeatedFlightOnce) {
  SweepStore store = Open();
  store.SetPlan(Spec(), PlanOf({"a"}), "this");
  store.Put(Row("a"));
  store.Put(Row("a"));
  EXPECT_EQ(store.Results().size(), 1u);
}

TEST_F(SweepStoreTest, KeepsAFlownRowWhenARepetitionFails) {
  SweepStore store = Open();
  FlightRow crashed = Row("a", runner::Verdict::kError);
  crashed.process = ProcessEnd::kCrashed;
  crashed.metrics.clear();
  store.Put(crashed);
  EXPECT_EQ(store.Find("a")->process, ProcessEnd::kCrashed);
  store.Put(Row("a"));
  EXPECT_EQ(store.Find("a")->process, ProcessEnd::kFlown) << "a flown row replaces a failed process";
  store.Put(crashed);
  EXPECT_EQ(RowJson(store.Find("a").value()), RowJson(Row("a")));
}

TEST_F(SweepStoreTest, StoresAllRowsOrNone) {
  SweepStore store = Open();
  FlightRow crashed = Row("a", runner::Verdict::kError);
  crashed.process = ProcessEnd::kCrashed;
  FlightRow not_a_number = Row("c");
  not_a_number.metrics["flight.sim_time_s"] = std::nan("");
  EXPECT_THROW(store.Put(std::vector{Row("b"), not_a_number}), InputError) << "SQLite converts it to NULL";
  EXPECT_FALSE(store.Find("b"));
  store.Put(std::vector{Row("a"), crashed, Row("b")});
  EXPECT_EQ(store.Find("a")->process, ProcessEnd::kFlown);
  EXPECT_TRUE(store.Find("b"));
}

TEST_F(SweepStoreTest, TryPutReturnsFalseWhileAnotherProgramReads) {
  SweepStore store = Open();
  store.SetPlan(Spec(), PlanOf({"a", "b"}), "this");
  {
    SQLite::Database reader((folder_ / "sweep.db").string(), SQLite::OPEN_READONLY);
    SQLite::Statement query(reader, "SELECT * FROM plan");
    ASSERT_TRUE(query.executeStep());
    EXPECT_FALSE(store.TryPut(Row("a")));
  }
  EXPECT_TRUE(store.TryPut(Row("a")));
  EXPECT_TRUE(store.Find("a"));
}

TEST_F(SweepStoreTest, RollsBackAnIncompleteTransactionOnReading) {
  {
    SweepStore store = Open();
    store.SetPlan(Spec(), PlanOf({"a"}), "this");
    for (int i = 0; i < 200; ++i) store.Put(Row("row " + std::to_string(i)));
  }
  {
    SQLite::Database writer((folder_ / "sweep.db").string(), SQLite::OPEN_READWRITE);
    writer.exec("PRAGMA cache_size = 1");  // Forces writes to the file before the commit.
    SQLite::Transaction transaction(writer);
    writer.exec("UPDATE flights SET verdict = 'half written'");
    for (const char* name : {"sweep.db", "sweep.db-journal"})
      folder_.Put(std::string("killed/") + name, folder_.Content(name));
  }
  EXPECT_THAT(folder_.Content("killed/sweep.db"), HasSubstr("half written"));
  const SweepStore store(folder_ / "killed", SweepStore::Access::kRead);
  EXPECT_EQ(store.Find("row 7")->verdict, runner::Verdict::kPass);
}

TEST_F(SweepStoreTest, KeepsButDoesNotCountOtherRows) {
  SweepStore store = Open();
  store.SetPlan(Spec(), PlanOf({"a", "b"}), "old");
  store.Put(Row("a", runner::Verdict::kPass, "old"));
  store.SetPlan(Spec(), PlanOf({"c"}), "this");
  store.Put(Row("c"));
  EXPECT_EQ(store.Results().size(), 1u);
  EXPECT_EQ(store.stale(), 1u);
  EXPECT_EQ(store.unplanned(), 0u);
  store.SetPlan(Spec(), PlanOf({"d"}), "this");
  EXPECT_EQ(store.unplanned(), 1u);
  EXPECT_TRUE(store.Find("a"));
}

TEST_F(SweepStoreTest, RejectsOtherFiles) {
  EXPECT_THAT(ErrorOnOpening(SweepStore::Access::kRead), HasSubstr("sweep.db: no such file"));
  folder_.Put("sweep.db", "someone's text");
  EXPECT_THAT(ErrorOnOpening(SweepStore::Access::kWrite), HasSubstr("sweep.db: file is not a database"));
  EXPECT_EQ(folder_.Content("sweep.db"), "someone's text");
}

TEST_F(SweepStoreTest, RejectsAnotherVersionAndADamagedFile) {
  {
    SweepStore store = Open();
    store.SetPlan(Spec(), PlanOf({"a"}), "this");
    for (int i = 0; i < 200; ++i) store.Put(Row("row " + std::to_string(i)));
  }
  const std::string content = folder_.Content("sweep.db");
  std::string other = content;
  other[63] = 9;  // The last byte of the file's user_version.
  folder_.Put("sweep.db", other);
  EXPECT_THAT(ErrorOnOpening(SweepStore::Access::kWrite),
              HasSubstr("sweep.db: sweep database of version 9; this program supports version 2"));
  folder_.Put("sweep.db", content.substr(0, content.size() / 2));
  EXPECT_THAT(ErrorOnOpening(SweepStore::Access::kWrite), HasSubstr("sweep.db: "));
  EXPECT_THAT(ErrorOnOpening(SweepStore::Access::kRead), HasSubstr("sweep.db: "));
  EXPECT_EQ(folder_.Content("sweep.db").size(), content.size() / 2) << "unchanged";
}

TEST_F(SweepStoreTest, RejectsAnUnknownProcessEnd) {
  SweepStore store = Open();
  store.SetPlan(Spec(), PlanOf({"a"}), "this");
  store.Put(Row("a"));
  SQLite::Database((folder_ / "sweep.db").string(), SQLite::OPEN_READWRITE).exec("UPDATE flights SET process = 'flow'");
  try {
    store.Results();
    ADD_FAILURE() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("sweep.db: damaged: flight a: process is 'flow'"));
  }
}

TEST_F(SweepStoreTest, ReportsInvalidParametersAsDamage) {
  SweepStore store = Open();
  store.SetPlan(Spec(), PlanOf({"a"}), "this");
  store.Put(Row("a"));
  SQLite::Database((folder_ / "sweep.db").string(), SQLite::OPEN_READWRITE).exec("UPDATE plan SET parameters = 'x'");
  try {
    store.Results();
    ADD_FAILURE() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("sweep.db: damaged: flight a: invalid parameters"));
  }
}

TEST_F(SweepStoreTest, ReturnsTheMetricsOfEachFlight) {
  SweepStore store = Open();
  store.SetPlan(Spec(), PlanOf({"a", "b", "c"}), "this");
  FlightRow b = Row("b"), c = Row("c");
  b.metrics = {{"flight.sim_time_s", 7.0}};
  c.metrics = {};
  store.Put(std::vector{Row("a"), b, c, Row("unplanned")});
  const std::vector<SweepResult> results = store.Results();
  ASSERT_EQ(results.size(), 3u);
  EXPECT_EQ(results[0].row.metrics, Row("a").metrics);
  EXPECT_EQ(results[1].row.metrics, b.metrics);
  EXPECT_TRUE(results[2].row.metrics.empty());
}

TEST(FlightRow, HasTheSameNamesInFileAndDatabase) {
  const nlohmann::json json = nlohmann::json::parse(RowJson(Row("a")));
  const tests::TemporaryFolder folder;
  SweepStore(folder.path(), SweepStore::Access::kWrite).Put(Row("a"));
  SQLite::Database db((folder / "sweep.db").string());
  SQLite::Statement columns(db, "SELECT name FROM pragma_table_info('flights')");
  std::size_t count = 0;
  for (; columns.executeStep(); ++count) EXPECT_TRUE(json.contains(columns.getColumn(0).getString()));
  EXPECT_EQ(json.size(), count + 2) << "plus schema and metrics";
}

TEST(RowsCsv, IsSortedByIdAndQuoted) {
  SweepResult b{.seed = 2, .variant = "", .values = {"[0, 1]"}, .row = Row("b")};
  SweepResult a{.seed = 1, .variant = "", .values = {"[2, \"x\"]"}, .row = Row("a", runner::Verdict::kFail)};
  const std::string csv = RowsCsv({"start.position_m"}, {b, a});
  EXPECT_THAT(csv, StartsWith("id,variant,start.position_m,seed,process,verdict,outcome,flight.sim_time_s,"));
  const std::size_t first = csv.find("\na,,\"[2, \"\"x\"\"]\",1,flown,fail,landed,0.30000000000000004,"),
                    second = csv.find("\nb,,\"[0, 1]\",2,flown,pass,landed,");
  ASSERT_NE(first, std::string::npos) << csv;
  EXPECT_LT(first, second);
  EXPECT_THAT(csv, testing::EndsWith(",abc\n"));
  EXPECT_THAT(csv, testing::Not(HasSubstr(",h,"))) << "no host";
}

TEST_F(SweepStoreTest, ReadsBackThePlan) {
  SweepStore store = Open();
  SweepPlan plan = PlanOf({"a", "b"});
  plan.total = 6;
  plan.flights[1].position = 5;
  plan.flights[1].variant = "windy";
  store.SetPlan(Spec(), plan, "this");
  const SweepPlan read = store.Plan();
  EXPECT_EQ(store.program(), "this");
  EXPECT_EQ(read.total, 6u);
  EXPECT_EQ(read.keys, plan.keys);
  ASSERT_EQ(read.flights.size(), 2u);
  EXPECT_EQ(read.flights[1].position, 5);
  EXPECT_EQ(read.flights[1].id, "b");
  EXPECT_EQ(read.flights[1].seed, 7u);
  EXPECT_EQ(read.flights[1].variant, "windy");
  EXPECT_THAT(read.flights[1].values, ElementsAre("3", "1.5"));
}

}  // namespace
}  // namespace touchdown::sweeper
