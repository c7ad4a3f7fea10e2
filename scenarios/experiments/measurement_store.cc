#include "scenarios/experiments/measurement_store.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "models/error.h"
#include "scenarios/util/file.h"
#include "scenarios/util/output_file.h"
#include "scenarios/util/platform.h"

namespace touchdown::experiments {
namespace {

constexpr const char* kStoreSignature = "touchdown.measurement";

}  // namespace

MeasurementStore::MeasurementStore(std::filesystem::path folder, std::string origin)
    : folder_(std::move(folder)), origin_(std::move(origin)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw InputError(fmt::format("output folder {}: {}", folder_.string(), error.message()));
}

std::optional<Json> MeasurementStore::Read(const std::string& id) const {
  const std::optional<std::string> text = util::ReadTextFileIfPresent(FileOf(id));
  if (!text) return std::nullopt;
  Json file = Json::parse(*text, nullptr, false);
  if (!file.is_object() || file.value("kind", "") != kStoreSignature || file.value("origin", "") != origin_)
    return std::nullopt;
  return file;
}

std::optional<Json> MeasurementStore::Find(const std::string& id) const {
  const std::optional<Json> file = Read(id);
  return file ? std::optional(file->at("value")) : std::nullopt;
}

std::vector<std::pair<std::string, std::string>> MeasurementStore::PlatformOf(const std::string& id) const {
  std::vector<std::pair<std::string, std::string>> facts;
  const std::optional<Json> file = Read(id);
  if (!file) return facts;
  for (const auto& [name, value] : file->at("platform").items()) facts.emplace_back(name, value.get<std::string>());
  return facts;
}

void MeasurementStore::Put(const std::string& id, const Json& value) const {
  Json file{{"kind", kStoreSignature}, {"origin", origin_}, {"platform", Json::object()}, {"value", value}};
  for (const auto& [name, fact] : util::PlatformFacts()) file["platform"][name] = fact;
  util::WriteOutputFile(FileOf(id), file.dump(1) + "\n", kStoreSignature);
}

}  // namespace touchdown::experiments
