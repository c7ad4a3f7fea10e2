// What the links of the modules do not enforce, read from every #include: each library is used only where it belongs,
// and the folders within a module keep their order.
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

/// The folders of a module of several, from the ground up: a file may include those of its own folder and below.
const std::vector<std::vector<std::string>>& FoldersFromTheGroundUp() {
  static const std::vector<std::vector<std::string>> modules = {
      {"sim/scene", "sim/dynamics", "sim/render", "sim/sensors"},
      {"scenarios/sweeper/plan", "scenarios/sweeper/analysis", "scenarios/sweeper/run", "scenarios/sweeper/page"}};
  return modules;
}

/// What may be included from outside the project, and by which files. A header that fits no line is refused.
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
      {std::regex("scenarios/.*"), std::regex("((sys|gnu)/)?[a-z-]+\\.h")},  // The operating system's.
  };
  return rules;
}

/// Whether a file of `path` may include `header` by the order of a module's folders.
bool IsInOrder(const std::string& path, const std::string& header) {
  for (const auto& folders : FoldersFromTheGroundUp()) {
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

/// The stderr_tail about one include; empty when there is none.
std::string StderrTail(const std::string& path, const std::string& header, bool quoted) {
  if (!quoted) return IsLibraryAllowed(path, header) ? "" : "<" + header + "> does not belong here";
  if (header.find("..") != std::string::npos || header.find('/') == std::string::npos) {
    return "include \"" + header + "\" is not written from the root";
  }
  if (header.starts_with("tests/")) return "the program must not include its tests";
  return IsInOrder(path, header) ? "" : path.substr(0, path.rfind('/')) + "/ must not include " + header;
}

/// The stderr_tails about one file's text. `path` is relative to the root, with forward slashes.
std::vector<std::string> Violations(const std::string& path, const std::string& text) {
  static const std::regex include_line(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<std::string> stderr_tails;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_search(line, match, include_line)) continue;
    const std::string stderr_tail = StderrTail(path, match[2], match[1] == "\"");
    if (stderr_tail.empty()) continue;
    stderr_tails.push_back(path + ":" + std::to_string(number) + ": " + stderr_tail);
  }
  return stderr_tails;
}

bool IsSource(const fs::path& path) {
  const auto extension = path.extension();
  return extension == ".h" || extension == ".cc" || extension == ".c";
}

TEST(Architecture, EveryIncludeIsOneThatIsAllowed) {
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

/// What is wrong with one include line in the file `path`.
std::string FaultOf(const std::string& path, const std::string& include) {
  const auto violations = Violations(path, "\n#include " + include + "\n");
  return violations.empty() ? "" : violations.front();
}

TEST(Architecture, ComplainsOfAFolderAboveInTheSameModule) {
  EXPECT_EQ(FaultOf("sim/render/a.cc", "\"sim/scene/scene.h\""), "");
  EXPECT_EQ(FaultOf("sim/scene/a.cc", "\"sim/render/renderer.h\""),
            "sim/scene/a.cc:2: sim/scene/ must not include sim/render/renderer.h");
  EXPECT_NE(FaultOf("scenarios/sweeper/plan/a.h", "\"scenarios/sweeper/run/process_pool.h\""), "");
}

TEST(Architecture, ComplainsOfAnIncludeThatIsNotWrittenFromTheRoot) {
  EXPECT_NE(FaultOf("sim/a.cc", "\"../estimator/estimator.h\""), "");
  EXPECT_NE(FaultOf("sim/a.cc", "\"world.h\""), "");
  EXPECT_NE(FaultOf("sim/a.cc", "<estimator/estimator.h>"), "");
}

TEST(Architecture, KeepsTheTestsOutOfTheProgram) {
  EXPECT_NE(FaultOf("scenarios/cli/a.cc", "\"tests/support/rooms.h\""), "");
  EXPECT_NE(FaultOf("models/a.cc", "<tests/support/rooms.h>"), "");
}

TEST(Architecture, AllowsEachLibraryOnlyWhereItBelongs) {
  for (const std::string folder : {"models", "controller", "estimator", "sim", "scenarios/runner"}) {
    EXPECT_EQ(FaultOf(folder + "/a.h", "<Eigen/Core>"), "");
    EXPECT_EQ(FaultOf(folder + "/a.h", "<string_view>"), "");
    EXPECT_NE(FaultOf(folder + "/a.h", "<boost/optional.hpp>"), "");
  }
  EXPECT_EQ(FaultOf("estimator/pad/edges.cc", "<opencv2/imgproc.hpp>"), "");
  EXPECT_NE(FaultOf("estimator/pad/edges.h", "<opencv2/imgproc.hpp>"), "");
  EXPECT_NE(FaultOf("controller/a.cc", "<opencv2/core.hpp>"), "");
  EXPECT_NE(FaultOf("controller/a.cc", "<fmt/format.h>"), "");
  EXPECT_NE(FaultOf("models/a.cc", "<unistd.h>"), "");
  EXPECT_EQ(FaultOf("sim/a.cc", "<mujoco/mujoco.h>"), "");
  EXPECT_EQ(FaultOf("scenarios/datasets/flight_bag.cc", "<rosbag/bag.h>"), "");
  EXPECT_NE(FaultOf("scenarios/datasets/flight_bag.h", "<rosbag/bag.h>"), "");
  EXPECT_NE(FaultOf("scenarios/datasets/footage.cc", "<sensor_msgs/Image.h>"), "");
  EXPECT_EQ(FaultOf("controller/a.cc", "<mujoco/mujoco.h>"),
            "controller/a.cc:2: <mujoco/mujoco.h> does not belong here");
}

}  // namespace
