#include "scenarios/config/config_node.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <unordered_map>

#include "scenarios/util/utf8.h"

namespace touchdown::config {
namespace {

constexpr std::size_t kMaxLevels = 32;
constexpr std::streamsize kMaxFile_bytes = 1 << 20;
constexpr std::size_t kMaxMessagePart = 400;

using OriginOf = std::function<Origin(const YAML::Mark&)>;

/// Builds the tree of one document from the parser's events.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(OriginOf origin_of) : origin_of_(std::move(origin_of)) {}

  const ConfigNode& root() const { return root_; }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    ConfigNode node = MakeNode(ConfigNode::Kind::kNothing, mark, "?", anchor);
    // The parser reports a missing value on the next line, so the location of the key is used.
    if (!open_.empty() && open_.back().pending) node.origin = open_.back().pending->origin;
    Add(std::move(node));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    throw ConfigError(origin_of_(mark), "", "aliases (*name) are not supported");
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    if (!open_.empty() && open_.back().node->kind == ConfigNode::Kind::kKeys && !open_.back().pending) {
      const Origin origin = origin_of_(mark);
      const auto [first, is_new] = open_.back().places.emplace(value, origin.place);
      if (!is_new) throw ConfigError(origin, value, "duplicate key, first given at " + first->second);
      open_.back().pending = PendingKey{value, origin};
      return;
    }
    ConfigNode node = MakeNode(ConfigNode::Kind::kText, mark, tag, anchor);
    node.text = value;
    node.quoted = tag == "!";
    Add(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    Open(MakeNode(ConfigNode::Kind::kList, mark, tag, anchor));
  }
  void OnSequenceEnd() override { Close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    Open(MakeNode(ConfigNode::Kind::kKeys, mark, tag, anchor));
  }
  void OnMapEnd() override { Close(); }

 private:
  struct PendingKey {
    std::string name;
    Origin origin;
  };
  struct OpenNode {
    ConfigNode* node;
    std::optional<PendingKey> pending;                    ///< Key whose value follows.
    std::unordered_map<std::string, std::string> places;  ///< Places of the keys so far.
  };

  ConfigNode MakeNode(ConfigNode::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    const Origin origin = origin_of_(mark);
    if (anchor != YAML::NullAnchor) throw ConfigError(origin, "", "anchors (&name) are not supported");
    if (!tag.empty() && tag != "?" && tag != "!") throw ConfigError(origin, "", "tags (!name) are not supported");
    ConfigNode node;
    node.kind = kind;
    node.origin = origin;
    return node;
  }

  ConfigNode* Add(ConfigNode node) {
    if (open_.empty()) {
      root_ = std::move(node);
      return &root_;
    }
    OpenNode& open = open_.back();
    ConfigNode& parent = *open.node;
    if (parent.kind == ConfigNode::Kind::kList) {
      parent.items.push_back(std::move(node));
      return &parent.items.back();
    }
    if (!open.pending) {
      const bool is_bracket = node.kind != ConfigNode::Kind::kNothing;
      throw ConfigError(node.origin, "",
                        fmt::format("a key must be plain text{}", is_bracket ? "; is a bracket not closed?" : ""));
    }
    parent.keys.push_back({std::move(open.pending->name), std::move(node)});
    open.pending.reset();
    return &parent.keys.back().node;
  }

  void Open(ConfigNode node) {
    if (open_.size() >= kMaxLevels) {
      throw ConfigError(node.origin, "", fmt::format("nested more than {} levels deep", kMaxLevels));
    }
    ConfigNode* const opened = Add(std::move(node));
    open_.push_back({opened, {}, {}});
  }

  void Close() { open_.pop_back(); }

  OriginOf origin_of_;
  ConfigNode root_;
  // Only the innermost open node grows, so the addresses of the enclosing nodes remain valid.
  std::vector<OpenNode> open_;
};

ConfigNode Parse(const std::string& text, const OriginOf& origin_of) {
  if (text.find('\0') != std::string::npos) throw ConfigError(origin_of(YAML::Mark()), "", "is not a text file");
  if (const std::size_t valid = util::Utf8Bytes(text); valid < text.size()) {
    YAML::Mark mark;
    mark.line = static_cast<int>(std::ranges::count(std::string_view(text).substr(0, valid), '\n'));
    throw ConfigError(origin_of(mark), "", "is not UTF-8");
  }
  std::istringstream stream(text);
  TreeBuilder builder(origin_of);
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) return builder.root();
    TreeBuilder second(origin_of);
    if (parser.HandleNextDocument(second)) {
      throw ConfigError(second.root().origin, "", "must contain only one YAML document");
    }
  } catch (const YAML::Exception& error) {
    throw ConfigError(origin_of(error.mark), "", "is not YAML: " + error.msg);
  }
  return builder.root();
}

std::string OneLine(std::string_view text) {
  std::string line;
  for (const char c : text.substr(0, kMaxMessagePart)) {
    line += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  }
  if (text.size() > kMaxMessagePart) line += "...";
  return line;
}

}  // namespace

const ConfigNode* ConfigNode::Find(std::string_view key) const {
  const auto found =
      std::find_if(keys.begin(), keys.end(), [key](const ConfigEntry& entry) { return entry.key == key; });
  return found == keys.end() ? nullptr : &found->node;
}

InputError ConfigError(const Origin& origin, std::string_view path, std::string_view message) {
  const std::string place = OneLine(origin.place), key = OneLine(path), text = OneLine(message);
  return InputError(key.empty() ? fmt::format("{}: {}", place, text) : fmt::format("{}: {}: {}", place, key, text));
}

ConfigNode ParseConfig(const std::string& text, const std::string& name, const std::filesystem::path& folder) {
  ConfigNode root = Parse(text, [&](const YAML::Mark& mark) {
    return Origin{fmt::format("{}:{}", name, std::max(mark.line, 0) + 1), folder};
  });
  if (root.kind == ConfigNode::Kind::kNothing) throw ConfigError({name + ":1", folder}, "", "is empty");
  if (root.kind != ConfigNode::Kind::kKeys) throw ConfigError(root.origin, "", "must be a list of `key: value`");
  return root;
}

ConfigNode ReadConfigFile(const std::filesystem::path& file) {
  const Origin origin{file.string(), {}};
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw ConfigError(origin, "", "no such file");
  if (std::filesystem::is_directory(status)) throw ConfigError(origin, "", "is a folder, not a file");
  const std::string name = file.filename().string();
  if (util::Utf8Bytes(name) < name.size()) throw ConfigError(origin, "", "the file name is not UTF-8");
  std::ifstream stream(file, std::ios::binary);
  std::string text(kMaxFile_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad() || (stream.fail() && !stream.eof())) throw ConfigError(origin, "", "cannot be read");
  if (stream.gcount() > kMaxFile_bytes) throw ConfigError(origin, "", "is larger than 1 MiB");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return ParseConfig(text, file.string(), file.parent_path());
}

ConfigNode ParseOverride(const std::string& assignment, const std::string& place, const std::filesystem::path& folder) {
  const Origin origin{place, folder};
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) throw ConfigError(origin, "", "must have the form key=value");
  const std::string path = assignment.substr(0, equals);
  ConfigNode node = Parse(assignment.substr(equals + 1), [&](const YAML::Mark&) { return origin; });
  node.origin = origin;
  std::size_t end = path.size();
  for (int depth = 0;; ++depth) {
    if (depth > static_cast<int>(kMaxLevels)) throw ConfigError(origin, "", "the key has too many dots");
    const std::size_t dot = path.rfind('.', end - 1);
    const std::size_t begin = dot == std::string::npos || end == 0 ? 0 : dot + 1;
    if (begin >= end) throw ConfigError(origin, path, "the key has an empty part");
    ConfigNode parent;
    parent.kind = ConfigNode::Kind::kKeys;
    parent.origin = origin;
    parent.patch = true;
    parent.keys.push_back({path.substr(begin, end - begin), std::move(node)});
    node = std::move(parent);
    if (begin == 0) return node;
    end = begin - 1;
  }
}

}  // namespace touchdown::config
