#include "scenarios/util/output_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <optional>
#include <system_error>

#include "models/error.h"
#include "scenarios/util/file.h"

namespace touchdown::util {
namespace {

namespace fs = std::filesystem;

InputError UnusableFolder(const fs::path& place, std::string_view why) {
  return InputError(fmt::format("output folder {}: {}", place.string(), why));
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& place, FolderKind kind) : kind_(std::move(kind)) {
  std::error_code error;
  place_ = fs::weakly_canonical(fs::absolute(place, error), error);
  if (error || place_.empty() || !place_.has_filename()) {
    if (!error && place_.has_parent_path() && place_ != place_.root_path()) {
      place_ = place_.parent_path();
    } else {
      throw UnusableFolder(place, "is not a folder name");
    }
  }
  CheckPlace();
  MakeFolders();
}

void OutputFolder::CheckPlace() const {
  std::error_code error;
  const fs::file_status status = fs::status(place_, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) throw UnusableFolder(place_, "is a file");
  if (fs::equivalent(place_, fs::current_path(error), error)) {
    throw UnusableFolder(place_, "is the current folder; choose another one");
  }
  const bool empty = fs::is_empty(place_, error);
  if (error) throw UnusableFolder(place_, error.message());
  if (!empty && !IsOfKind()) {
    throw UnusableFolder(place_, fmt::format("contains other files, but no {} of an earlier run; nothing was written",
                                             kind_.files.front()));
  }
  CheckSubfolders();
}

void OutputFolder::CheckSubfolders() const {
  for (const SubfolderKind& subfolder : kind_.subfolders) {
    const fs::path inside = place_ / subfolder.name;
    std::error_code error;
    if (!fs::exists(inside, error)) continue;
    for (fs::recursive_directory_iterator entry(inside, error), end; !error && entry != end; entry.increment(error)) {
      const fs::path file = entry->path().lexically_relative(inside);
      if (entry->is_directory() || subfolder.holds(file)) continue;
      throw UnusableFolder(place_, fmt::format("{} is not a file of an earlier run; nothing was written",
                                               (subfolder.name / file).string()));
    }
    if (error) throw UnusableFolder(inside, error.message());
  }
}

bool OutputFolder::IsOfKind() const {
  const std::optional<std::string> content = ReadTextFileIfPresent(place_ / kind_.files.front());
  return content && content->find(kind_.signature) != std::string::npos;
}

void OutputFolder::MakeFolders() {
  std::error_code error;
  const std::string hidden = fmt::format(".{}.partial-{}", place_.filename().string(), getpid());
  if (fs::exists(place_, error)) {
    temporary_ = place_ / hidden;
  } else {
    for (fs::path parent = place_.parent_path(); !fs::exists(parent, error) && parent != parent.root_path();
         parent = parent.parent_path()) {
      made_.insert(made_.begin(), parent);
    }
    temporary_ = place_.parent_path() / hidden;
  }
  fs::create_directories(temporary_, error);
  if (error) {
    const std::string why = error.message();
    for (auto parent = made_.rbegin(); parent != made_.rend(); ++parent) fs::remove(*parent, error);
    throw UnusableFolder(place_, why);
  }
}

OutputFolder::~OutputFolder() {
  std::error_code error;
  fs::remove_all(temporary_, error);
  if (committed_) return;
  for (auto parent = made_.rbegin(); parent != made_.rend(); ++parent) fs::remove(*parent, error);
}

void OutputFolder::Write(std::string_view name, std::string_view content) {
  std::ofstream file(PathOf(name), std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) throw UnusableFolder(place_, fmt::format("{} cannot be written", name));
}

void OutputFolder::Commit() {
  std::error_code error;
  if (temporary_.parent_path() == place_) {
    ReplaceFiles();
  } else {
    if (fs::exists(place_, error)) throw UnusableFolder(place_, "was created by another program in the meantime");
    fs::rename(temporary_, place_, error);
    if (error) throw UnusableFolder(place_, error.message());
  }
  committed_ = true;
}

void OutputFolder::ReplaceFiles() const {
  // The first file indicates a complete set, so it is removed first and written last.
  std::error_code error;
  for (const std::string& name : kind_.files) {
    fs::remove(place_ / name, error);
    if (error) throw UnusableFolder(place_, fmt::format("{}: {}", name, error.message()));
  }
  for (const SubfolderKind& subfolder : kind_.subfolders) {
    fs::remove_all(place_ / subfolder.name, error);
    if (error) throw UnusableFolder(place_, fmt::format("{}: {}", subfolder.name, error.message()));
  }
  for (const SubfolderKind& subfolder : kind_.subfolders) MoveToPlace(subfolder.name);
  for (auto name = kind_.files.rbegin(); name != kind_.files.rend(); ++name) MoveToPlace(*name);
}

void OutputFolder::MoveToPlace(const std::string& name) const {
  std::error_code error;
  if (!fs::exists(temporary_ / name, error)) return;
  fs::rename(temporary_ / name, place_ / name, error);
  if (error) throw UnusableFolder(place_, fmt::format("{}: {}", name, error.message()));
}

}  // namespace touchdown::util
