#include "scenarios/sweeper/analysis/rows_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "models/error.h"
#include "scenarios/util/csv_reader.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/enum_names.h"
#include "scenarios/util/file.h"
#include "scenarios/util/number.h"

namespace touchdown::sweeper {
namespace {

constexpr const char* kSeed = "seed";
constexpr const char* kLogDigest = "log_sha256";

/// Columns between `seed` and the metrics.
constexpr std::array<const char*, 3> kFlightColumns = {"process", "verdict", "outcome"};

/// Column indices of a row: id, variant, parameters, seed, flight columns, metrics, log_sha256.
///
/// Files of versions before 0.2 have no column `process`. In these files, a process that did not end normally is given
/// in the column `outcome`.
struct Layout {
  std::vector<std::string> head;
  std::size_t seed = 0;
  bool has_process = false;

  explicit Layout(const std::vector<std::string_view>& cells) : head(cells.begin(), cells.end()) {
    seed = static_cast<std::size_t>(std::find(head.begin(), head.end(), kSeed) - head.begin());
    has_process = seed + 1 < head.size() && head[seed + 1] == kFlightColumns[0];
  }
  std::size_t verdict() const { return seed + (has_process ? 2 : 1); }
  std::size_t outcome() const { return verdict() + 1; }
  bool IsValid() const {
    return seed >= 2 && head.size() > outcome() + 1 && head[0] == "id" && head[1] == "variant" &&
           head[verdict()] == kFlightColumns[1] && head[outcome()] == kFlightColumns[2] && head.back() == kLogDigest;
  }
};

/// Required value of a cell; throws std::invalid_argument for nullopt.
template <typename Value>
Value Required(const std::optional<Value>& value) {
  if (!value) throw std::invalid_argument("not a row");
  return *value;
}

void ReadFlightColumns(const Layout& layout, const std::vector<std::string_view>& cells, FlightRow& row) {
  const std::string_view outcome = cells[layout.outcome()];
  row.verdict = Required(util::EnumFromName<runner::Verdict>(cells[layout.verdict()]));
  if (layout.has_process) {
    row.process = Required(util::EnumFromName<ProcessEnd>(cells[layout.seed + 1]));
  } else {
    const auto process = util::EnumFromName<ProcessEnd>(outcome);
    row.process = process && row.verdict == runner::Verdict::kError ? *process : ProcessEnd::kFlown;
    if (row.process != ProcessEnd::kFlown) return;
  }
  row.outcome = Required(util::EnumFromName<runner::Outcome>(outcome));
}

SweepResult ResultFrom(const Layout& layout, const std::vector<std::string_view>& cells) {
  SweepResult result{.seed = Required(util::FiniteNumber<std::uint64_t>(cells[layout.seed])),
                     .variant = std::string(cells[1])};
  result.values.assign(cells.begin() + 2, cells.begin() + static_cast<std::ptrdiff_t>(layout.seed));
  result.row.id = cells[0];
  ReadFlightColumns(layout, cells, result.row);
  result.row.log_sha256 = cells.back();
  for (std::size_t i = layout.outcome() + 1; i + 1 < cells.size(); ++i) {
    if (!cells[i].empty() && runner::FindMetric(layout.head[i]) != nullptr) {
      result.row.metrics[layout.head[i]] = Required(util::FiniteNumber(cells[i]));
    }
  }
  return result;
}

}  // namespace

std::string RowsCsv(const std::vector<std::string>& keys, std::vector<SweepResult> results) {
  std::sort(results.begin(), results.end(), [](const SweepResult& a, const SweepResult& b) {
    return std::tie(a.row.id, a.variant, a.values) < std::tie(b.row.id, b.variant, b.values);
  });
  util::CsvWriter csv;
  csv << "id"
      << "variant";
  for (const std::string& key : keys) csv << key;
  csv << kSeed;
  for (const char* const column : kFlightColumns) csv << column;
  for (const runner::MetricInfo& metric : runner::AllMetrics()) csv << metric.name;
  csv << kLogDigest;
  csv.EndLine();
  for (const SweepResult& result : results) {
    const FlightRow& row = result.row;
    csv << row.id << result.variant;
    for (const std::string& value : result.values) csv << value;
    csv << result.seed << Name(row.process) << Name(row.verdict) << Name(row.outcome);
    for (const runner::MetricInfo& metric : runner::AllMetrics()) {
      const auto found = row.metrics.find(metric.name);
      found == row.metrics.end() ? csv.Empty(1) : csv << found->second;
    }
    csv << row.log_sha256;
    csv.EndLine();
  }
  return csv.Take();
}

StoredResults ReadRowsCsv(const std::filesystem::path& file) {
  const std::string text = util::ReadTextFile(file);
  util::CsvReader reader(text);
  const Layout layout(reader.Next().value_or(util::CsvRow()).cells);
  if (!layout.IsValid()) throw InputError(fmt::format("{}:1: not the header of sweep rows", file.string()));
  StoredResults stored{.source = file.string(), .keys = {}, .results = {}};
  stored.keys.assign(layout.head.begin() + 2, layout.head.begin() + static_cast<std::ptrdiff_t>(layout.seed));
  while (const std::optional<util::CsvRow> row = reader.Next()) {
    const auto fail = [&] { return InputError(fmt::format("{}:{}: not a row of a sweep", file.string(), row->line)); };
    if (row->cells.size() != layout.head.size()) throw fail();
    try {
      stored.results.push_back(ResultFrom(layout, row->cells));
    } catch (const std::invalid_argument&) {
      throw fail();
    }
  }
  return stored;
}

}  // namespace touchdown::sweeper
