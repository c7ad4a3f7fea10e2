#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown::util {

/// A folder within a folder of results.
struct SubfolderKind {
  std::string name;
  std::function<bool(const std::filesystem::path&)> holds;  ///< Whether a file, relative to it, is one of its own.
};

/// Signature of a folder of results, by which it is recognized.
struct FolderKind {
  std::vector<std::string> files;  ///< The names that it may hold; the first is always there.
  std::string mark;                ///< A text that the first file holds.
  std::vector<SubfolderKind> subfolders = {};
};

/// A folder of results that appears whole or not at all: it is filled under a hidden name, and takes its place with
/// Commit. Until then, and when it is destroyed before, nothing is to be seen of it.
///
/// Nothing that a user made is lost: a place that holds anything but an earlier folder of the same kind is refused; in
/// an earlier one Commit replaces the files of its kind, and touches no other; one whose subfolders hold anything else
/// is refused.
class OutputFolder {
 public:
  /// Throws InputError when `place` is in use for something else, or cannot be written.
  OutputFolder(const std::filesystem::path& place, FolderKind kind);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Throws InputError when the disk is full or the like.
  void Write(std::string_view name, std::string_view content);

  /// Where a file lies until Commit, for what writes it by itself.
  std::filesystem::path PathOf(std::string_view name) const { return temporary_ / name; }

  /// Moves the files to their place. Throws InputError when it cannot. In an earlier folder of the same kind, whose
  /// first file is removed before the others change and comes back last, a failure halfway leaves no first file.
  void Commit();

 private:
  void CheckPlace() const;
  void MakeFolders();
  bool IsOfKind() const;
  void CheckSubfolders() const;
  void ReplaceFiles() const;
  void MoveIn(const std::string& name) const;

  std::filesystem::path place_;
  FolderKind kind_;
  std::filesystem::path temporary_;
  std::vector<std::filesystem::path> made_;  ///< Parents that were made for it, the outermost first.
  bool committed_ = false;
};

}  // namespace touchdown::util
