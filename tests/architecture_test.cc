// The house's rule of layers, read from every #include: siblings never include each other, the ground floor includes
// nobody, and each library is used only where it belongs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"models", {"models"}},
    {"sim", {"sim", "models"}},
    {"estimator", {"estimator", "models"}},
    {"controller", {"controller", "models"}},
    {"scenarios", {"scenarios", "sim", "estimator", "controller", "models"}},
};

struct LibraryRule {
  std::regex header;
  std::regex allowed_path;  // Of the file that includes it.
};

const std::vector<LibraryRule>& LibraryRules() {
  static const std::vector<LibraryRule> rules = {
      {std::regex("(mujoco|GL|EGL)/.*"), std::regex("sim/.*")},
      {std::regex("opencv2/.*"), std::regex("(sim/.*)|(scenarios/.*)|(estimator/.*\\.cc)|(estimator/paper/.*)")},
      {std::regex("(yaml-cpp|CLI|nlohmann|openssl)/.*"), std::regex("scenarios/.*")},
      {std::regex("(spdlog|fmt)/.*"), std::regex("(scenarios|sim)/.*")},
  };
  return rules;
}

/// The complaints about one file's text. `path` is relative to the root, with forward slashes.
std::vector<std::string> Violations(const std::string& path, const std::string& text) {
  static const std::regex include_line(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  const std::string folder = path.substr(0, path.find('/'));
  std::vector<std::string> complaints;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_search(line, match, include_line)) continue;
    const bool quoted = match[1] == "\"";
    const std::string header = match[2];
    const std::string where = path + ":" + std::to_string(number) + ": ";
    const std::string target = header.substr(0, header.find('/'));
    if (quoted && (header.find("..") != std::string::npos || header.find('/') == std::string::npos)) {
      complaints.push_back(where + "include \"" + header + "\" is not written from the root");
    } else if ((quoted || kMayInclude.contains(target)) && !kMayInclude.at(folder).contains(target)) {
      complaints.push_back(where + folder + "/ must not include " + target + "/");
    }
    for (const auto& rule : LibraryRules()) {
      if (std::regex_match(header, rule.header) && !std::regex_match(path, rule.allowed_path)) {
        complaints.push_back(where + "<" + header + "> does not belong here");
      }
    }
  }
  return complaints;
}

bool IsSource(const fs::path& path) {
  const auto extension = path.extension();
  return extension == ".h" || extension == ".cc" || extension == ".c";
}

TEST(Architecture, NoIncludeClimbsOrGoesSideways) {
  const fs::path root = TOUCHDOWN_SOURCE_DIR;
  int files = 0;
  for (const auto& [folder, unused] : kMayInclude) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file() || !IsSource(entry.path())) continue;
      std::ifstream stream(entry.path());
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      EXPECT_THAT(Violations(fs::relative(entry.path(), root).generic_string(), text), testing::IsEmpty());
      ++files;
    }
  }
  EXPECT_GT(files, 50);
}

TEST(Architecture, ComplainsOfASiblingAnUpperFloorAndALibraryOutOfPlace) {
  EXPECT_THAT(Violations("estimator/a.cc", "#include \"sim/world.h\"\n"),
              testing::ElementsAre("estimator/a.cc:1: estimator/ must not include sim/"));
  EXPECT_THAT(Violations("models/a.h", "\n#include \"scenarios/flight/metrics.h\"\n"),
              testing::ElementsAre("models/a.h:2: models/ must not include scenarios/"));
  EXPECT_THAT(Violations("controller/a.cc", "#include <mujoco/mujoco.h>\n"),
              testing::ElementsAre("controller/a.cc:1: <mujoco/mujoco.h> does not belong here"));
  EXPECT_THAT(Violations("estimator/estimator.h", "#include <opencv2/core.hpp>\n"), testing::SizeIs(1));
  EXPECT_THAT(Violations("sim/a.cc", "#include \"../estimator/estimator.h\"\n"), testing::SizeIs(1));
  EXPECT_THAT(Violations("sim/a.cc", "#include \"world.h\"\n"), testing::SizeIs(1));
  EXPECT_THAT(Violations("sim/a.cc", "#include \"tests/support/rooms.h\"\n"), testing::SizeIs(1));
  EXPECT_THAT(Violations("sim/a.cc", "#include <estimator/estimator.h>\n"), testing::SizeIs(1));
  EXPECT_THAT(Violations("scenarios/flight/a.cc", "#include \"sim/world.h\"\n#include \"models/time.h\"\n"),
              testing::IsEmpty());
}

}  // namespace
