#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown::scenarios {

/// How to tell a folder of results from any other.
struct FolderKind {
  std::vector<std::string> files;  ///< The names that it may hold; the first is always there.
  std::string mark;                ///< A text that the first file holds.
};

/// A folder of results that appears whole or not at all: it is filled under a hidden name beside its place, and takes
/// its place with Commit. Until then, and when it is destroyed before, nothing is to be seen of it.
///
/// Nothing that a user made is lost: a place that holds anything but an earlier folder of the same kind is refused; of
/// an earlier one the files that this program writes are replaced, and all others stay.
class OutputFolder {
 public:
  /// Throws InputError when `place` is in use for something else, or cannot be written.
  OutputFolder(const std::filesystem::path& place, FolderKind kind);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Throws InputError when the disk is full or the like.
  void Write(std::string_view name, std::string_view content);

  /// Moves the folder to its place. Throws InputError when it cannot; then its place is as it was.
  void Commit();

 private:
  void CheckPlace() const;
  void MakeFolders();
  bool IsOfKind() const;
  void TakePlaceOfOld();
  void KeepOthersFiles(const std::filesystem::path& old_folder) const;

  std::filesystem::path place_;
  FolderKind kind_;
  std::filesystem::path temporary_;
  std::vector<std::filesystem::path> made_;  ///< Parents that were made for it, the outermost first.
  bool committed_ = false;
};

}  // namespace touchdown::scenarios
