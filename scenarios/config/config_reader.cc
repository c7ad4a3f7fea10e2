#include "scenarios/config/config_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scenarios/config/file_format.h"
#include "scenarios/util/number.h"

namespace touchdown::config {
namespace {

std::string Excerpt(const std::string& text) {
  return text.size() <= 40 ? fmt::format("'{}'", text) : fmt::format("'{}...'", text.substr(0, 40));
}

double ParseNumber(const ConfigNode& node, const std::string& path, const models::Range& range) {
  const auto fail = [&](const std::string& message) -> InputError { return ConfigError(node.origin, path, message); };
  if (node.kind != ConfigNode::Kind::kText || node.quoted) throw fail("must be a number");
  static constexpr std::string_view kNotFinite[] = {".nan", ".NaN",  ".NAN",  ".inf",  ".Inf",
                                                    ".INF", "-.inf", "-.Inf", "-.INF", "+.inf"};
  const bool is_not_finite = std::find(std::begin(kNotFinite), std::end(kNotFinite), node.text) != std::end(kNotFinite);
  const util::NumberToken<double> parsed = util::ReadNumber<double>(node.text);
  if (is_not_finite || parsed.is_out_of_range || (parsed.value && !std::isfinite(*parsed.value))) {
    throw fail("must be a finite number, is " + Excerpt(node.text));
  }
  if (!parsed.value) throw fail("must be a number, is " + Excerpt(node.text));
  if (!range.Contains(*parsed.value)) throw fail(fmt::format("{}, is {}", range.Sentence(), node.text));
  return *parsed.value;
}

std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string UnknownKeyMessage(std::string_view key, const std::set<std::string, std::less<>>& known) {
  if (known.empty()) return "unknown key";
  const std::string& nearest = *std::min_element(known.begin(), known.end(), [key](const auto& a, const auto& b) {
    return EditDistance(key, a) < EditDistance(key, b);
  });
  if (EditDistance(key, nearest) <= 1 + key.size() / 3) return fmt::format("unknown key, did you mean {}?", nearest);
  return fmt::format("unknown key; allowed: {}", fmt::join(known, ", "));
}

}  // namespace

ConfigReader::ConfigReader(const ConfigNode& root, OriginByPath& origins) : origins_(origins) { EnterKeys(&root, ""); }

std::string ConfigReader::PathOf(std::string_view key) const {
  const std::string& parent = open_.back().path;
  return parent.empty() ? std::string(key) : fmt::format("{}.{}", parent, key);
}

const ConfigNode* ConfigReader::Visit(const models::Key& key) {
  Open& open = open_.back();
  open.visited.emplace(key.name);
  if (open.node == nullptr) return nullptr;
  const ConfigNode* const node = open.node->Find(key.name);
  if (node == nullptr) {
    if (key.required && !open.node->patch) throw ConfigError(open.node->origin, PathOf(key.name), "must be given");
    return nullptr;
  }
  if (node->kind == ConfigNode::Kind::kNothing) throw ConfigError(node->origin, PathOf(key.name), "has no value");
  origins_[PathOf(key.name)] = node->origin;
  return node;
}

const ConfigNode* ConfigReader::VisitText(const models::Key& key, std::string_view what) {
  const ConfigNode* const node = Visit(key);
  if (node != nullptr && node->kind != ConfigNode::Kind::kText) {
    throw ConfigError(node->origin, PathOf(key.name), fmt::format("must be {}", what));
  }
  return node;
}

void ConfigReader::Number(const models::Key& key, double& value, const models::Unit&, const models::Range& range) {
  if (const ConfigNode* const node = Visit(key)) value = ParseNumber(*node, PathOf(key.name), range);
}

void ConfigReader::OptionalNumber(const models::Key& key, std::optional<double>& value, const models::Unit&,
                                  const models::Range& range) {
  if (const ConfigNode* const node = Visit(key)) value = ParseNumber(*node, PathOf(key.name), range);
}

void ConfigReader::Numbers(const models::Key& key, const std::vector<double*>& values, const models::Unit&,
                           const models::Range& range) {
  const ConfigNode* const node = Visit(key);
  if (node == nullptr) return;
  const std::string path = PathOf(key.name);
  if (node->kind == ConfigNode::Kind::kKeys && node->patch) {
    for (const auto& [index_text, value] : node->keys) {
      const auto index = util::FiniteNumber<std::size_t>(index_text);
      if (!index || *index >= values.size()) throw ConfigError(value.origin, path + "." + index_text, "unknown key");
      *values[*index] = ParseNumber(value, path + "." + index_text, range);
    }
    return;
  }
  if (node->kind != ConfigNode::Kind::kList || node->items.size() != values.size()) {
    throw ConfigError(node->origin, path, fmt::format("must be a list of {} numbers", values.size()));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    *values[i] = ParseNumber(node->items[i], fmt::format("{}.{}", path, i), range);
  }
}

void ConfigReader::Integer64(const models::Key& key, std::int64_t& value, const models::Range& range) {
  const ConfigNode* const node = VisitText(key, "an integer");
  if (node == nullptr) return;
  const util::NumberToken<std::int64_t> parsed =
      node->quoted ? util::NumberToken<std::int64_t>{} : util::ReadNumber<std::int64_t>(node->text);
  const auto fail = [&](const std::string& message) { return ConfigError(node->origin, PathOf(key.name), message); };
  if (parsed.is_out_of_range) throw fail("is too large");
  if (!parsed.value) throw fail("must be an integer, is " + Excerpt(node->text));
  if (!range.Contains(static_cast<double>(*parsed.value))) {
    throw fail(fmt::format("{}, is {}", range.Sentence(), node->text));
  }
  value = *parsed.value;
}

void ConfigReader::Boolean(const models::Key& key, bool& value) {
  const ConfigNode* const node = VisitText(key, "true or false");
  if (node == nullptr) return;
  if (node->quoted || (node->text != "true" && node->text != "false")) {
    throw ConfigError(node->origin, PathOf(key.name), "must be true or false, is " + Excerpt(node->text));
  }
  value = node->text == "true";
}

void ConfigReader::Text(const models::Key& key, std::string& value) {
  if (const ConfigNode* const node = VisitText(key, "text")) value = node->text;
}

void ConfigReader::Choice(const models::Key& key, int& index, std::span<const std::string_view> names) {
  const std::string one_of = fmt::format("{}{}", names.size() > 1 ? "one of " : "", fmt::join(names, ", "));
  const ConfigNode* const node = VisitText(key, one_of);
  if (node == nullptr) return;
  const auto found = std::find(names.begin(), names.end(), node->text);
  if (found == names.end()) {
    throw ConfigError(node->origin, PathOf(key.name), fmt::format("must be {}, is {}", one_of, Excerpt(node->text)));
  }
  index = static_cast<int>(found - names.begin());
}

void ConfigReader::Section(const models::Key& key, const models::SectionFile& file,
                           const std::function<void(models::ConfigVisitor&)>& describe) {
  const ConfigNode* node = Visit(key);
  const std::string path = PathOf(key.name);
  if (node != nullptr && node->kind == ConfigNode::Kind::kText && file.allowed) {
    try {
      ConfigNode root = ReadConfigFile(node->origin.folder / node->text);
      node = &files_.emplace_back(SectionKeys(std::move(root), file));
    } catch (const InputError& error) {
      throw ConfigError(node->origin, path, error.what());
    }
    origins_[path] = node->origin;
  }
  if (node != nullptr && node->kind != ConfigNode::Kind::kKeys) {
    throw ConfigError(node->origin, path, file.allowed ? "must be keys or the name of a file" : "must be keys");
  }
  EnterKeys(node, path);
  describe(*this);
  LeaveKeys();
}

void ConfigReader::OptionalSection(const models::Key& key, bool is_set, const models::SectionFile& file,
                                   const std::function<void(models::ConfigVisitor&)>& describe) {
  Open& open = open_.back();
  open.visited.emplace(key.name);
  if (is_set || (open.node != nullptr && open.node->Find(key.name) != nullptr)) Section(key, file, describe);
}

void ConfigReader::List(const models::Key& key, std::size_t count, const std::function<void(std::size_t)>& resize,
                        const std::function<void(models::ConfigVisitor&, std::size_t)>& describe) {
  const ConfigNode* const node = Visit(key);
  if (node == nullptr) return;
  const std::string path = PathOf(key.name);
  if (node->patch && node->kind == ConfigNode::Kind::kKeys) {
    PatchItems(*node, path, count, describe);
    return;
  }
  if (node->kind != ConfigNode::Kind::kList) throw ConfigError(node->origin, path, "must be a list");
  resize(node->items.size());
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const std::string item_path = fmt::format("{}.{}", path, i);
    if (node->items[i].kind != ConfigNode::Kind::kKeys) {
      throw ConfigError(node->items[i].origin, item_path, "must be keys");
    }
    origins_[item_path] = node->items[i].origin;
    EnterKeys(&node->items[i], item_path);
    describe(*this, i);
    LeaveKeys();
  }
}

void ConfigReader::Renamed(std::string_view old_key, std::string_view new_key) {
  const ConfigNode* const node = open_.back().node != nullptr ? open_.back().node->Find(old_key) : nullptr;
  if (node != nullptr) {
    throw ConfigError(node->origin, PathOf(old_key), fmt::format("was renamed to {}", PathOf(new_key)));
  }
}

void ConfigReader::PatchItems(const ConfigNode& node, const std::string& path, std::size_t count,
                              const std::function<void(models::ConfigVisitor&, std::size_t)>& describe) {
  for (const auto& [index_text, item] : node.keys) {
    const std::string item_path = path + "." + index_text;
    const auto index = util::FiniteNumber<std::size_t>(index_text);
    if (!index || *index >= count) {
      throw ConfigError(item.origin, item_path, fmt::format("unknown key; the list has {} items", count));
    }
    if (item.kind != ConfigNode::Kind::kKeys) throw ConfigError(item.origin, item_path, "must be keys");
    origins_[item_path] = item.origin;
    EnterKeys(&item, item_path);
    describe(*this, *index);
    LeaveKeys();
  }
}

void ConfigReader::EnterKeys(const ConfigNode* node, const std::string& path) { open_.push_back({node, path, {}}); }

void ConfigReader::LeaveKeys() {
  const Open open = std::move(open_.back());
  open_.pop_back();
  if (open.node == nullptr) return;
  for (const auto& [name, node] : open.node->keys) {
    if (!open.visited.contains(name)) {
      const std::string path = open.path.empty() ? name : fmt::format("{}.{}", open.path, name);
      throw ConfigError(node.origin, path, UnknownKeyMessage(name, open.visited));
    }
  }
}

const Origin& OriginChecker::OriginOf(std::string_view path) const {
  for (;;) {
    if (const auto origin = origins_.find(path); origin != origins_.end()) return origin->second;
    const std::size_t dot = path.rfind('.');
    if (dot == std::string_view::npos) return fallback_;
    path = path.substr(0, dot);
  }
}

InputError OriginChecker::Error(const std::string& path, const std::string& message) const {
  return ConfigError(OriginOf(path), path, message);
}

}  // namespace touchdown::config
