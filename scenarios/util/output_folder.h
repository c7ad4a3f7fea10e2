#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown::util {

/// Subfolder of a results folder.
struct SubfolderKind {
  std::string name;
  std::function<bool(const std::filesystem::path&)>
      holds;  ///< Whether a file, relative to the subfolder, belongs to it.
};

/// Signature of a folder of results, by which it is recognized.
struct FolderKind {
  std::vector<std::string> files;  ///< Names of its files; the first one always exists.
  std::string mark;                ///< Text that the first file contains.
  std::vector<SubfolderKind> subfolders = {};
};

/// A results folder that appears completely or not at all: it is filled under a hidden name and renamed by Commit.
/// Without Commit, nothing appears.
///
/// No file of a user is lost: a path with anything other than an earlier folder of the same kind is refused. In an
/// earlier folder, Commit replaces the files of its kind and touches no others. A folder with foreign files in its
/// subfolders is refused.
class OutputFolder {
 public:
  /// Throws InputError when `place` contains something else or cannot be written.
  OutputFolder(const std::filesystem::path& place, FolderKind kind);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Writes a file. Throws InputError when it cannot, e.g. on a full disk.
  void Write(std::string_view name, std::string_view content);

  /// Path of a file before Commit, for code that writes it directly.
  std::filesystem::path PathOf(std::string_view name) const { return temporary_ / name; }

  /// Moves the files to their final path. Throws InputError when it cannot. In an earlier folder of the same kind,
  /// whose first file is removed before the others change and comes back last, a failure halfway leaves no first file.
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
  std::vector<std::filesystem::path> made_;  ///< Created parent folders, the outermost first.
  bool committed_ = false;
};

}  // namespace touchdown::util
