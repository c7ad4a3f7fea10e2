#include "scenarios/sweeper/analysis/rows_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "models/error.h"
#include "scenarios/util/text.h"

namespace touchdown::sweeper {
namespace {

/// The cells of the line that begins at `at`, which is moved behind it; quoted ones may hold line ends.
std::vector<std::string> TakeLine(const std::string& csv, std::size_t& at) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (; at < csv.size(); ++at) {
    const char c = csv[at];
    if (c == '"' && is_quoted && at + 1 < csv.size() && csv[at + 1] == '"') {
      cells.back() += csv[++at];
    } else if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      cells.emplace_back();
    } else if (c == '\n' && !is_quoted) {
      ++at;
      break;
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

/// Where the parts of a row lie: id, variant, parameters, seed, verdict, outcome, metrics, log_sha256.
struct Layout {
  std::vector<std::string> head;
  std::size_t seed = 0;

  explicit Layout(std::vector<std::string> cells) : head(std::move(cells)) {
    seed = static_cast<std::size_t>(std::find(head.begin(), head.end(), "seed") - head.begin());
  }
  bool IsValid() const {
    return head.size() > seed + 3 && seed >= 2 && head[0] == "id" && head[1] == "variant" &&
           head[seed + 1] == "verdict" && head[seed + 2] == "outcome" && head.back() == "log_sha256";
  }
};

/// Throws std::invalid_argument for what is none, as a whole.
template <typename Value>
Value NumberIn(const std::string& cell) {
  Value value{};
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool is_whole = error == std::errc() && end == cell.data() + cell.size();
  if (!is_whole || !std::isfinite(static_cast<double>(value))) throw std::invalid_argument("no number: " + cell);
  return value;
}

SweepResult ResultFrom(const Layout& layout, const std::vector<std::string>& cells) {
  const auto begin = cells.begin();
  SweepResult result{.seed = NumberIn<std::uint64_t>(cells[layout.seed]), .variant = cells[1]};
  result.values.assign(begin + 2, begin + static_cast<std::ptrdiff_t>(layout.seed));
  result.row.id = cells[0];
  result.row.end = RowEnd::kFlown;
  result.row.verdict = cells[layout.seed + 1];
  constexpr std::array<std::string_view, 3> kVerdicts = {"pass", "fail", "error"};
  if (std::find(kVerdicts.begin(), kVerdicts.end(), result.row.verdict) == kVerdicts.end()) {
    throw std::invalid_argument("no verdict: " + result.row.verdict);
  }
  result.row.outcome = cells[layout.seed + 2];
  result.row.log_sha256 = cells.back();
  for (std::size_t i = layout.seed + 3; i + 1 < cells.size(); ++i) {
    if (!cells[i].empty() && runner::FindMetric(layout.head[i]) != nullptr)
      result.row.metrics[layout.head[i]] = NumberIn<double>(cells[i]);
  }
  return result;
}

/// Of a flight without a result, how its process ended.
std::string OutcomeOf(const FlightRow& row) {
  return row.end == RowEnd::kFlown ? row.outcome : std::string(Name(row.end));
}

}  // namespace

std::string RowsCsv(const std::vector<std::string>& keys, std::vector<SweepResult> results) {
  std::sort(results.begin(), results.end(), [](const SweepResult& a, const SweepResult& b) {
    return std::tie(a.row.id, a.variant, a.values) < std::tie(b.row.id, b.variant, b.values);
  });
  std::vector<std::string> head{"id", "variant"};
  head.insert(head.end(), keys.begin(), keys.end());
  for (const char* name : {"seed", "verdict", "outcome"}) head.push_back(name);
  for (const runner::MetricInfo& metric : runner::AllMetrics()) head.emplace_back(metric.name);
  head.push_back("log_sha256");
  std::string csv = util::QuotedCsvLine(head);
  for (const SweepResult& result : results) {
    std::vector<std::string> cells{result.row.id, result.variant};
    cells.insert(cells.end(), result.values.begin(), result.values.end());
    for (const std::string& cell : {std::to_string(result.seed), result.row.verdict, OutcomeOf(result.row)}) {
      cells.push_back(cell);
    }
    for (const runner::MetricInfo& metric : runner::AllMetrics()) {
      const auto found = result.row.metrics.find(metric.name);
      cells.push_back(found == result.row.metrics.end() ? "" : fmt::format("{}", found->second));
    }
    cells.push_back(result.row.log_sha256);
    csv += util::QuotedCsvLine(std::move(cells));
  }
  return csv;
}

StoredResults ReadRowsCsv(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(fmt::format("{}: cannot be read", file.string()));
  const std::string csv{std::istreambuf_iterator<char>(stream), {}};
  std::size_t at = 0;
  const Layout layout(TakeLine(csv, at));
  if (!layout.IsValid()) throw InputError(fmt::format("{}:1: is no header of a sweep's rows", file.string()));
  StoredResults stored{.source = file.string(), .keys = {}, .results = {}};
  stored.keys.assign(layout.head.begin() + 2, layout.head.begin() + static_cast<std::ptrdiff_t>(layout.seed));
  for (int line = 2; at < csv.size(); ++line) {
    const std::vector<std::string> cells = TakeLine(csv, at);
    const auto fail = [&] { return InputError(fmt::format("{}:{}: is no row of a sweep", file.string(), line)); };
    if (cells.size() != layout.head.size()) throw fail();
    try {
      stored.results.push_back(ResultFrom(layout, cells));
    } catch (const std::invalid_argument&) {
      throw fail();
    }
  }
  return stored;
}

}  // namespace touchdown::sweeper
