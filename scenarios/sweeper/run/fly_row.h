#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/sweeper/plan/flight_row.h"

namespace touchdown::sweeper {

/// Reads a row file; nullopt when there is no file or no complete row in it. Throws InputError when it cannot be read.
std::optional<FlightRow> ReadRow(const std::filesystem::path& file);
/// Same as ReadRow, but renames a file without a complete row to ID.damaged. Throws InputError also when that fails.
std::optional<FlightRow> ReadRowOrSetAside(const std::filesystem::path& file);

/// Folder into which processes write their rows, each under the id of its flight.
class RowFolder {
 public:
  /// `folder` is the folder of the sweep. Throws InputError when the subfolders cannot be created.
  explicit RowFolder(const std::filesystem::path& folder);

  /// Writes a row; the file appears completely or not at all.
  std::filesystem::path RowOf(const std::string& id) const { return rows_ / (id + ".json"); }
  std::filesystem::path PictureOf(const std::string& id) const { return pictures_ / (id + ".png"); }
  const std::filesystem::path& rows() const { return rows_; }

  /// See ReadRow.
  std::optional<FlightRow> Find(const std::string& id) const { return ReadRow(RowOf(id)); }

  /// Throws InputError when it cannot be written.
  void Leave(const FlightRow& row) const;

 private:
  std::filesystem::path rows_, pictures_;
};

/// Flies a resolved scenario and writes its row under `id`, and a contact sheet of a flight that did not pass. A
/// failure during the flight becomes a row with that reason, except a lack of memory, which is rethrown. Throws
/// InputError when the row cannot be written or the scenario is invalid.
void FlyRow(const std::string& scenario_yaml, const std::string& id, const RowFolder& folder);

}  // namespace touchdown::sweeper
