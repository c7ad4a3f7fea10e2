// Checks all #include lines for rules that the links of the modules do not enforce: third-party headers are included
// only where they are allowed, and the directories of a module depend on each other in a fixed order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Modules with several directories, in order: a file may include headers of its own directory and of preceding ones.
const std::vector<std::vector<std::string>>& OrderedFolders() {
  static const std::vector<std::vector<std::string>> modules = {
      {"sim/scene", "sim/dynamics", "sim/render", "sim/sensors"},
      {"scenarios/sweeper/plan", "scenarios/sweeper/analysis", "scenarios/sweeper/run", "scenarios/sweeper/page"}};
  return modules;
}

/// Headers from outside the project (`header`) that files (`path`) may include. All others are rejected.
struct LibraryRule {
  std::regex path;
  std::regex header;
};

const std::vector<LibraryRule>& LibraryRules() {
  static const std::vector<LibraryRule> rules = {
      {std::regex(".*"), std::regex("[a-z_0-9]+|Eigen/.*")},
      {std::regex(".*\\.c"), std::regex("[a-z]+\\.h")},
      {std::regex("estimator/.*\\.cc"), std::regex("opencv2/.*")},
      {std::regex("sim/.*"), std::regex("(mujoco|GL|EGL|opencv2|spdlog|fmt)/.*")},
      {std::regex("scenarios/.*"), std::regex("(opencv2|yaml-cpp|CLI|nlohmann|openssl|spdlog|fmt)/.*|pugixml\\.hpp")},
      {std::regex("scenarios/report/.*"), std::regex("(cairo|kainjow)/.*")},
      {std::regex("scenarios/(experiments/paper|sweeper/page/sweep)_report\\.cc"), std::regex("kainjow/.*")},
      {std::regex("scenarios/experiments/april_tag\\.cc"), std::regex("apriltag/.*")},
      {std::regex("scenarios/sweeper/plan/sweep_store\\.cc"), std::regex("(SQLiteCpp/.*|sqlite3\\.h)")},
      {std::regex("scenarios/util/statistics\\.cc"), std::regex("boost/math/.*")},
      {std::regex("scenarios/util/utf8\\.cc"), std::regex("utf8\\.h")},
      {std::regex("scenarios/report/video_.*\\.cc"), std::regex("lib(av[a-z]+|swscale)/.*")},
      {std::regex("scenarios/datasets/(flight_bag\\.cc|bag_file\\.cc|bag_messages\\.h)"),
       std::regex("(rosbag|ros|(std|sensor|geometry|tf2)_msgs|boost|console_bridge)/.*")},
      {std::regex("scenarios/.*"), std::regex("((sys|gnu)/)?[a-z-]+\\.h")},  // Operating system.
  };
  return rules;
}

/// Whether the order of a module's directories allows that `path` includes `header`.
bool IsInOrder(const std::string& path, const std::string& header) {
  for (const auto& folders : OrderedFolders()) {
    const auto place_of = [&](const std::string& file) {
      return std::find_if(folders.begin(), folders.end(),
                          [&](const std::string& folder) { return file.starts_with(folder + "/"); });
    };
    if (place_of(path) != folders.end() && place_of(header) != folders.end()) return place_of(header) <= place_of(path);
  }
  return true;
}

bool IsLibraryAllowed(const std::string& path, const std::string& header) {
  return std::any_of(LibraryRules().begin(), LibraryRules().end(), [&](const LibraryRule& rule) {
    return std::regex_match(path, rule.path) && std::regex_match(header, rule.header);
  });
}

/// Description of the rule that an include violates; empty if it is allowed.
std::string ViolationOf(const std::string& path, const std::string& header, bool quoted) {
  if (!quoted) return IsLibraryAllowed(path, header) ? "" : "<" + header + "> is not allowed here";
  if (header.find("..") != std::string::npos || header.find('/') == std::string::npos) {
    return "include \"" + header + "\" is not relative to the root";
  }
  if (header.starts_with("tests/")) return "the program must not include headers of tests";
  return IsInOrder(path, header) ? "" : path.substr(0, path.rfind('/')) + "/ must not include " + header;
}

/// Violations in the text of a file. `path` is relative to the root, with forward slashes.
std::vector<std::string> Violations(const std::string& path, const std::string& text) {
  static const std::regex include_line(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<std::string> violations;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_search(line, match, include_line)) continue;
    const std::string violation = ViolationOf(path, match[2], match[1] == "\"");
    if (violation.empty()) continue;
    violations.push_back(path + ":" + std::to_string(number) + ": " + violation);
  }
  return violations;
}

bool IsSource(const fs::path& path) {
  const auto extension = path.extension();
  return extension == ".h" || extension == ".cc" || extension == ".c";
}

TEST(Architecture, AllIncludesAreAllowed) {
  const fs::path root = TOUCHDOWN_SOURCE_DIR;
  int files = 0;
  for (const std::string folder : {"models", "sim", "estimator", "controller", "scenarios"}) {
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

/// Violation of one include line in the file `path`; empty if it is allowed.
std::string FirstViolation(const std::string& path, const std::string& include) {
  const auto violations = Violations(path, "\n#include " + include + "\n");
  return violations.empty() ? "" : violations.front();
}

TEST(Architecture, RejectsALaterDirectoryOfTheSameModule) {
  EXPECT_EQ(FirstViolation("sim/render/a.cc", "\"sim/scene/scene.h\""), "");
  EXPECT_EQ(FirstViolation("sim/scene/a.cc", "\"sim/render/renderer.h\""),
            "sim/scene/a.cc:2: sim/scene/ must not include sim/render/renderer.h");
  EXPECT_NE(FirstViolation("scenarios/sweeper/plan/a.h", "\"scenarios/sweeper/run/process_pool.h\""), "");
}

TEST(Architecture, RejectsAnIncludeThatIsNotRelativeToTheRoot) {
  EXPECT_NE(FirstViolation("sim/a.cc", "\"../estimator/estimator.h\""), "");
  EXPECT_NE(FirstViolation("sim/a.cc", "\"world.h\""), "");
  EXPECT_NE(FirstViolation("sim/a.cc", "<estimator/estimator.h>"), "");
}

TEST(Architecture, RejectsTestHeadersInTheProgram) {
  EXPECT_NE(FirstViolation("scenarios/cli/a.cc", "\"tests/support/rooms.h\""), "");
  EXPECT_NE(FirstViolation("models/a.cc", "<tests/support/rooms.h>"), "");
}

TEST(Architecture, AllowsEachLibraryOnlyInItsModules) {
  for (const std::string folder : {"models", "controller", "estimator", "sim", "scenarios/runner"}) {
    EXPECT_EQ(FirstViolation(folder + "/a.h", "<Eigen/Core>"), "");
    EXPECT_EQ(FirstViolation(folder + "/a.h", "<string_view>"), "");
    EXPECT_NE(FirstViolation(folder + "/a.h", "<boost/optional.hpp>"), "");
  }
  EXPECT_EQ(FirstViolation("estimator/pad/edges.cc", "<opencv2/imgproc.hpp>"), "");
  EXPECT_NE(FirstViolation("estimator/pad/edges.h", "<opencv2/imgproc.hpp>"), "");
  EXPECT_NE(FirstViolation("controller/a.cc", "<opencv2/core.hpp>"), "");
  EXPECT_NE(FirstViolation("controller/a.cc", "<fmt/format.h>"), "");
  EXPECT_NE(FirstViolation("models/a.cc", "<unistd.h>"), "");
  EXPECT_EQ(FirstViolation("sim/a.cc", "<mujoco/mujoco.h>"), "");
  EXPECT_EQ(FirstViolation("scenarios/datasets/flight_bag.cc", "<rosbag/bag.h>"), "");
  EXPECT_NE(FirstViolation("scenarios/datasets/flight_bag.h", "<rosbag/bag.h>"), "");
  EXPECT_NE(FirstViolation("scenarios/datasets/footage.cc", "<sensor_msgs/Image.h>"), "");
  EXPECT_EQ(FirstViolation("controller/a.cc", "<mujoco/mujoco.h>"),
            "controller/a.cc:2: <mujoco/mujoco.h> is not allowed here");
}

}  // namespace
