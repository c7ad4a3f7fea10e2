#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/sweeper/plan/flight_row.h"

namespace touchdown::sweeper {

/// nullopt when there is no file, or what it holds is no whole row. Throws InputError when it cannot be read.
std::optional<FlightRow> ReadRow(const std::filesystem::path& file);
/// The same, and what it holds else is kept as ID.damaged. Throws InputError when that cannot be done, too.
std::optional<FlightRow> ReadRowOrSetAside(const std::filesystem::path& file);

/// A folder into which processes leave what they flew, each under its flight's id.
class RowFolder {
 public:
  /// `folder` is the sweep's. Throws InputError when what is needed cannot be made in it.
  explicit RowFolder(const std::filesystem::path& folder);

  /// Its file is there whole or not at all.
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

/// Flies a resolved scenario and leaves its row under `id`; of a flight that did not pass, a contact sheet too. What
/// goes wrong in the flight is a row that says so, but for a lack of memory, which is thrown on. Throws InputError when
/// the row cannot be written or the scenario is none.
void FlyRow(const std::string& scenario_yaml, const std::string& id, const RowFolder& folder);

}  // namespace touchdown::sweeper
