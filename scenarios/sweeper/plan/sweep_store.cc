#include "scenarios/sweeper/plan/sweep_store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <map>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "models/error.h"
#include "scenarios/sweeper/plan/parameter_json.h"
#include "scenarios/util/enum_names.h"
#include "scenarios/util/number.h"

namespace touchdown::sweeper {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kApplicationId = 0x7464776e;  // "tdwn", the application_id of a sweep database (PRAGMA application_id).
constexpr int kVersion = 2;

/// Tables and views, except the table `flights` (FlightsSchema).
constexpr const char* kTables = R"(
CREATE TABLE sweep (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE plan (
  position INTEGER PRIMARY KEY, id TEXT NOT NULL, seed INTEGER NOT NULL, variant TEXT NOT NULL, parameters TEXT NOT NULL);
CREATE TABLE metrics (
  id TEXT NOT NULL REFERENCES flights ON DELETE CASCADE, name TEXT NOT NULL, value REAL NOT NULL,
  PRIMARY KEY (id, name)) WITHOUT ROWID;
CREATE VIEW results AS
  SELECT plan.*, process, verdict, outcome, reason, failed_check, failed_phase, log_sha256, wall_s, version, host
  FROM plan JOIN flights USING (id);
CREATE VIEW stale AS
  SELECT * FROM flights WHERE program <> (SELECT value FROM sweep WHERE key = 'program');
)";

/// SQL statement "CREATE TABLE flights (id TEXT PRIMARY KEY, program TEXT NOT NULL, ...".
std::string FlightsSchema() {
  FlightRow row;
  std::string columns;
  VisitColumns(row, [&columns]<typename T>(const char* name, const T&) {
    const char* const type = std::is_same_v<T, double> ? "REAL" : "TEXT";
    columns +=
        columns.empty() ? fmt::format("{} {} PRIMARY KEY", name, type) : fmt::format(", {} {} NOT NULL", name, type);
  });
  return fmt::format("CREATE TABLE flights ({}) WITHOUT ROWID;", columns);
}

std::string InsertFlight() {
  FlightRow row;
  std::string placeholders;
  VisitColumns(row, [&placeholders](const char*, const auto&) { placeholders += placeholders.empty() ? "?" : ", ?"; });
  return fmt::format("INSERT OR REPLACE INTO flights VALUES ({})", placeholders);
}

InputError Damaged(const fs::path& file, std::string_view what) {
  return InputError(fmt::format("{}: damaged: {}", file.string(), what));
}

/// Reads a row of the table `flights`, without metrics.
FlightRow RowFrom(const SQLite::Statement& query, const fs::path& file) {
  FlightRow row;
  VisitColumns(row, [&]<typename T>(const char* name, T& value) {
    const SQLite::Column column = query.getColumn(name);
    if constexpr (std::is_same_v<T, double>) {
      value = column.getDouble();
    } else if constexpr (std::is_enum_v<T>) {
      const std::optional<T> named = util::EnumFromName<T>(column.getString());
      if (!named) throw Damaged(file, fmt::format("flight {}: {} is '{}'", row.id, name, column.getString()));
      value = *named;
    } else {
      value = column.getString();
    }
  });
  return row;
}

/// Reads the values of the parameters `keys` of a planned flight.
std::vector<std::string> ValuesFrom(const SQLite::Statement& query, const std::vector<std::string>& keys,
                                    const fs::path& file) {
  try {
    const Json parameters = Json::parse(query.getColumn("parameters").getString());
    std::vector<std::string> values;
    for (const std::string& key : keys) values.push_back(ParameterFrom(parameters.at(key)));
    return values;
  } catch (const Json::exception&) {
    throw Damaged(file, fmt::format("flight {}: invalid parameters", query.getColumn("id").getString()));
  }
}

}  // namespace

struct SweepStore::Impl {
  fs::path file;
  std::optional<SQLite::Database> db;

  /// Runs a database operation and converts its errors to InputError.
  template <typename Work>
  auto Guarded(Work&& work) -> decltype(work()) {
    try {
      return work();
    } catch (const SQLite::Exception& error) {
      throw InputError(fmt::format("{}: {}", file.string(), error.what()));
    }
  }

  int Pragma(const char* name) { return db->execAndGet(fmt::format("PRAGMA {}", name)).getInt(); }

  void Check() {
    if (Pragma("application_id") != kApplicationId)
      throw InputError(fmt::format("{}: not a sweep database", file.string()));
    const int version = Pragma("user_version");
    if (version != kVersion) {
      throw InputError(fmt::format("{}: sweep database of version {}; this program supports version {}", file.string(),
                                   version, kVersion));
    }
    const std::string state = db->execAndGet("PRAGMA quick_check").getString();
    if (state != "ok") throw Damaged(file, state.substr(0, state.find('\n')));
  }

  void Create() {
    SQLite::Transaction transaction(*db);
    db->exec(fmt::format("PRAGMA application_id = {}", kApplicationId));
    db->exec(fmt::format("PRAGMA user_version = {}", kVersion));
    db->exec(FlightsSchema());
    db->exec(kTables);
    transaction.commit();
  }

  std::string Value(const char* key) {
    SQLite::Statement query(*db, "SELECT value FROM sweep WHERE key = ?");
    query.bind(1, key);
    return query.executeStep() ? query.getColumn(0).getString() : "";
  }

  void Put(std::span<const FlightRow> rows) {
    SQLite::Transaction transaction(*db);
    for (const FlightRow& row : rows) PutRow(row);
    transaction.commit();
  }

  void PutRow(const FlightRow& row) {
    if (row.process != ProcessEnd::kFlown) {
      SQLite::Statement flown(*db, "SELECT 1 FROM flights WHERE id = ? AND process = ?");
      flown.bind(1, row.id);
      flown.bind(2, std::string(Name(ProcessEnd::kFlown)));
      if (flown.executeStep()) return;
    }
    SQLite::Statement put(*db, InsertFlight());
    int column = 0;
    VisitColumns(row, [&]<typename T>(const char*, const T& value) {
      if constexpr (std::is_enum_v<T>) {
        put.bind(++column, std::string(Name(value)));
      } else {
        put.bind(++column, value);
      }
    });
    put.exec();
    SQLite::Statement put_metric(*db, "INSERT OR REPLACE INTO metrics VALUES (?, ?, ?)");
    for (const auto& [name, value] : row.metrics) {
      put_metric.bind(1, row.id);
      put_metric.bind(2, name);
      put_metric.bind(3, value);
      put_metric.exec();
      put_metric.reset();
    }
  }

  runner::Metrics MetricsOf(const std::string& id) {
    SQLite::Statement query(*db, "SELECT name, value FROM metrics WHERE id = ?");
    query.bind(1, id);
    runner::Metrics metrics;
    while (query.executeStep()) metrics[query.getColumn(0).getString()] = query.getColumn(1).getDouble();
    return metrics;
  }

  /// Metrics of all planned flights, by flight id.
  std::map<std::string, runner::Metrics> MetricsOfPlan() {
    SQLite::Statement query(*db, "SELECT id, name, value FROM metrics WHERE id IN (SELECT id FROM plan)");
    std::map<std::string, runner::Metrics> metrics;
    while (query.executeStep()) {
      metrics[query.getColumn(0).getString()][query.getColumn(1).getString()] = query.getColumn(2).getDouble();
    }
    return metrics;
  }
};

SweepStore::SweepStore(const fs::path& folder, Access access) : impl_(std::make_unique<Impl>()) {
  impl_->file = folder / "sweep.db";
  const bool exists = fs::exists(impl_->file);
  if (access == Access::kRead && !exists) throw InputError(fmt::format("{}: no such file", impl_->file.string()));
  impl_->Guarded([&] {
    constexpr int kWait_ms = 5000;
    // SQLite rolls back an incomplete transaction of a killed program, which needs write access even for reading.
    impl_->db.emplace(impl_->file.string(),
                      access == Access::kRead ? SQLite::OPEN_READWRITE : SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE,
                      kWait_ms);
    impl_->db->exec("PRAGMA foreign_keys = ON");
    // The file is empty if a program was killed just after it created the file.
    if (access == Access::kWrite && impl_->Pragma("page_count") == 0) {
      impl_->Create();
    } else {
      impl_->Check();
    }
  });
}

SweepStore::~SweepStore() = default;

void SweepStore::SetPlan(const SweepSpec& spec, const SweepPlan& plan, const std::string& program_digest) {
  impl_->Guarded([&] {
    SQLite::Database& db = *impl_->db;
    SQLite::Transaction transaction(db);
    db.exec("DELETE FROM plan");
    db.exec("DELETE FROM sweep");
    SQLite::Statement put_value(db, "INSERT INTO sweep VALUES (?, ?)");
    for (const auto& [key, value] : {std::pair<std::string, std::string>("program", program_digest),
                                     {"terms", SpecJson(spec)},
                                     {"flights", std::to_string(plan.total)}}) {
      put_value.bind(1, key);
      put_value.bind(2, value);
      put_value.exec();
      put_value.reset();
    }
    SQLite::Statement put(db, "INSERT INTO plan VALUES (?, ?, ?, ?, ?)");
    for (const PlannedFlight& flight : plan.flights) {
      Json parameters = Json::object();
      for (std::size_t i = 0; i < plan.keys.size(); ++i) parameters[plan.keys[i]] = ParameterJson(flight.values[i]);
      put.bind(1, flight.position);
      put.bind(2, flight.id);
      put.bind(3, static_cast<std::int64_t>(flight.seed));
      put.bind(4, flight.variant);
      put.bind(5, parameters.dump());
      put.exec();
      put.reset();
    }
    transaction.commit();
  });
}

void SweepStore::Put(const FlightRow& row) { Put({&row, 1}); }

void SweepStore::Put(std::span<const FlightRow> rows) {
  impl_->Guarded([&] { impl_->Put(rows); });
}

bool SweepStore::TryPut(const FlightRow& row) {
  return impl_->Guarded([&] {
    try {
      impl_->Put({&row, 1});
      return true;
    } catch (const SQLite::Exception& error) {
      if (error.getErrorCode() == SQLITE_BUSY) return false;
      throw;
    }
  });
}

std::optional<FlightRow> SweepStore::Find(const std::string& id) const {
  return impl_->Guarded([&]() -> std::optional<FlightRow> {
    SQLite::Statement query(*impl_->db, "SELECT * FROM flights WHERE id = ?");
    query.bind(1, id);
    if (!query.executeStep()) return std::nullopt;
    FlightRow row = RowFrom(query, impl_->file);
    row.metrics = impl_->MetricsOf(id);
    return row;
  });
}

bool SweepStore::has_plan() const { return !program().empty(); }

std::string SweepStore::program() const {
  return impl_->Guarded([&] { return impl_->Value("program"); });
}

SweepSpec SweepStore::spec() const {
  const std::string json = impl_->Guarded([&] { return impl_->Value("terms"); });
  try {
    return json.empty() ? SweepSpec() : SpecFromJson(json);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", impl_->file.string(), error.what()));
  }
}

std::size_t SweepStore::planned() const {
  return impl_->Guarded(
      [&] { return static_cast<std::size_t>(impl_->db->execAndGet("SELECT count(*) FROM plan").getInt64()); });
}

std::size_t SweepStore::total() const {
  return impl_->Guarded([&] { return util::FiniteNumber<std::size_t>(impl_->Value("flights")).value_or(0); });
}

SweepPlan SweepStore::Plan() const {
  SweepPlan plan{.keys = spec().keys(), .flights = {}, .total = total()};
  return impl_->Guarded([&] {
    SQLite::Statement query(*impl_->db, "SELECT * FROM plan ORDER BY position");
    while (query.executeStep()) {
      plan.flights.push_back({.position = query.getColumn("position").getInt64(),
                              .id = query.getColumn("id").getString(),
                              .seed = static_cast<std::uint64_t>(query.getColumn("seed").getInt64()),
                              .variant = query.getColumn("variant").getString(),
                              .values = ValuesFrom(query, plan.keys, impl_->file)});
    }
    return plan;
  });
}

std::vector<SweepResult> SweepStore::Results() const {
  const std::vector<std::string> keys = spec().keys();
  return impl_->Guarded([&] {
    const SQLite::Transaction one_state(*impl_->db);
    const std::map<std::string, runner::Metrics> metrics = impl_->MetricsOfPlan();
    std::vector<SweepResult> results;
    SQLite::Statement query(
        *impl_->db, "SELECT seed, variant, parameters, flights.* FROM plan JOIN flights USING (id) ORDER BY position");
    while (query.executeStep()) {
      SweepResult result{.seed = static_cast<std::uint64_t>(query.getColumn("seed").getInt64()),
                         .variant = query.getColumn("variant").getString(),
                         .values = ValuesFrom(query, keys, impl_->file),
                         .row = RowFrom(query, impl_->file)};
      if (const auto found = metrics.find(result.row.id); found != metrics.end()) result.row.metrics = found->second;
      results.push_back(std::move(result));
    }
    return results;
  });
}

std::size_t SweepStore::stale() const {
  return impl_->Guarded(
      [&] { return static_cast<std::size_t>(impl_->db->execAndGet("SELECT count(*) FROM stale").getInt64()); });
}

std::size_t SweepStore::unplanned() const {
  constexpr const char* kCount =
      "SELECT count(*) FROM flights WHERE id NOT IN (SELECT id FROM plan) AND id NOT IN (SELECT id FROM stale)";
  return impl_->Guarded([&] { return static_cast<std::size_t>(impl_->db->execAndGet(kCount).getInt64()); });
}

}  // namespace touchdown::sweeper
