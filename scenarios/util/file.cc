#include "scenarios/util/file.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "models/error.h"

namespace touchdown::util {
namespace {

InputError Unreadable(const std::filesystem::path& file, int error) {
  return InputError(fmt::format("{}: cannot be read: {}", file.string(), std::generic_category().message(error)));
}

}  // namespace

std::optional<std::string> ReadTextFileIfPresent(const std::filesystem::path& file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rbe"), std::fclose);
  if (!stream) {
    if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
    throw Unreadable(file, errno);
  }
  std::string content;
  std::array<char, 1 << 16> block;
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), stream.get())) {
    content.append(block.data(), size);
  }
  if (std::ferror(stream.get())) throw Unreadable(file, errno);
  return content;
}

std::string ReadTextFile(const std::filesystem::path& file) {
  std::optional<std::string> content = ReadTextFileIfPresent(file);
  if (!content) throw Unreadable(file, ENOENT);
  return *std::move(content);
}

}  // namespace touchdown::util
