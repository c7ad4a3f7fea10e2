#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/sweeper/plan/flight_row.h"

namespace touchdown::sweeper {

/// Reads a row file; nullopt if there is no file or no complete row in it. Throws InputError if it cannot be read.
std::optional<FlightRow> ReadRow(const std::filesystem::path& file);
/// Like ReadRow, but renames a file without a complete row to ID.damaged. Also throws InputError if renaming fails.
std::optional<FlightRow> ReadRowOrSetAside(const std::filesystem::path& file);

/// Row files and images of a sweep, named by flight id.
class RowFolder {
 public:
  /// `folder` is the output directory of the sweep. Creates its subfolders rows and pictures; throws InputError if it
  /// cannot.
  explicit RowFolder(const std::filesystem::path& folder);

  std::filesystem::path RowFile(const std::string& id) const { return rows_ / (id + ".json"); }
  std::filesystem::path ImageFile(const std::string& id) const { return images_ / (id + ".png"); }
  const std::filesystem::path& rows() const { return rows_; }

  /// Row of a flight, see ReadRow.
  std::optional<FlightRow> Find(const std::string& id) const { return ReadRow(RowFile(id)); }

  /// Writes a row file, completely or not at all. Throws InputError if it cannot be written.
  void Write(const FlightRow& row) const;

 private:
  std::filesystem::path rows_, images_;
};

/// Flies a resolved scenario and writes its row under `id`, and a contact sheet if the flight did not pass. An
/// InputError during the flight gives a row with its message as the reason; other exceptions are rethrown. Throws
/// InputError if the row cannot be written or the scenario is invalid.
void FlyRow(const std::string& scenario_yaml, const std::string& id, const RowFolder& folder);

}  // namespace touchdown::sweeper
