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
  /// Whether a file, given relative to the subfolder, is one of its results.
  std::function<bool(const std::filesystem::path&)> holds;
};

/// Files and signature by which a results folder is recognized.
struct FolderKind {
  std::vector<std::string> files;  ///< Names of its files; the first one always exists.
  std::string signature;           ///< Text that the first file contains.
  std::vector<SubfolderKind> subfolders = {};
};

/// Results folder that is created atomically. The files are written to a hidden folder, which Commit renames. Without
/// Commit, the hidden folder is removed.
///
/// No file of the user is lost. An existing path must be empty or an earlier folder of the same kind, and its
/// subfolders must not contain other files. In an earlier folder, Commit replaces the files of its kind and keeps all
/// others.
class OutputFolder {
 public:
  /// Throws InputError if `place` is not such a path or cannot be written.
  OutputFolder(const std::filesystem::path& place, FolderKind kind);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Writes a file. Throws InputError on failure, for example if the disk is full.
  void Write(std::string_view name, std::string_view content);

  /// Path of a file before Commit, for code that writes it directly.
  std::filesystem::path PathOf(std::string_view name) const { return temporary_ / name; }

  /// Moves the files to their final path. Throws InputError on failure. In an earlier folder of the same kind, the
  /// first file is removed first and written last, so that it is missing after an incomplete replacement.
  void Commit();

 private:
  void CheckPlace() const;
  void MakeFolders();
  bool IsOfKind() const;
  void CheckSubfolders() const;
  void ReplaceFiles() const;
  void MoveToPlace(const std::string& name) const;

  std::filesystem::path place_;
  FolderKind kind_;
  std::filesystem::path temporary_;
  std::vector<std::filesystem::path> made_;  ///< Created parent folders, the outermost first.
  bool committed_ = false;
};

}  // namespace touchdown::util
