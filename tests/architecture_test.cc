// The house's rule of layers, read from every #include: siblings never include each other, the ground floor includes
// nobody, and each library is used only where it belongs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
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

/// Of the project's folders: whose headers a folder's files may include. Within scenarios/, a command stands on studies
/// and reports, and these on the flight.
const std::map<std::string, std::set<std::string>>& MayInclude() {
  static const std::map<std::string, std::set<std::string>> folders = [] {
    const std::set<std::string> below_scenarios = {"sim", "estimator", "controller", "models"};
    const auto with_those_below = [&](std::set<std::string> parts) {
      parts.insert(below_scenarios.begin(), below_scenarios.end());
      return parts;
    };
    return std::map<std::string, std::set<std::string>>{
        {"models", {"models"}},
        {"sim", {"sim", "models"}},
        {"estimator", {"estimator", "models"}},
        {"controller", {"controller", "models"}},
        {"scenarios/flight", with_those_below({"scenarios/flight"})},
        {"scenarios/footage", with_those_below({"scenarios/footage", "scenarios/flight"})},
        {"scenarios/report", with_those_below({"scenarios/report", "scenarios/footage", "scenarios/flight"})},
        {"scenarios/study", with_those_below({"scenarios/study", "scenarios/flight"})},
        {"scenarios/sweep",
         with_those_below({"scenarios/sweep", "scenarios/study", "scenarios/report", "scenarios/flight"})},
        {"scenarios/paper",
         with_those_below({"scenarios/paper", "scenarios/study", "scenarios/report", "scenarios/flight"})},
        {"scenarios/cli", with_those_below({"scenarios/cli", "scenarios/sweep", "scenarios/paper", "scenarios/study",
                                            "scenarios/report", "scenarios/footage", "scenarios/flight"})},
    };
  }();
  return folders;
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
      {std::regex("scenarios/report/.*\\.cc"), std::regex("(cairo|kainjow)/.*")},
      {std::regex("scenarios/(paper/paper|sweep/sweep)_report\\.cc"), std::regex("kainjow/.*")},
      {std::regex("scenarios/paper/april_tag\\.cc"), std::regex("apriltag/.*")},
      {std::regex("scenarios/sweep/sweep_store\\.cc"), std::regex("(SQLiteCpp/.*|sqlite3\\.h)")},
      {std::regex("scenarios/study/statistics\\.cc"), std::regex("boost/math/.*")},
      {std::regex("scenarios/report/video_.*\\.cc"), std::regex("lib(av[a-z]+|swscale)/.*")},
      {std::regex("scenarios/footage/(flight_bag\\.cc|bag_file\\.cc|bag_messages\\.h)"),
       std::regex("(rosbag|ros|(std|sensor|geometry|tf2)_msgs|boost|console_bridge)/.*")},
      {std::regex("scenarios/.*"), std::regex("((sys|gnu)/)?[a-z-]+\\.h")},  // The operating system's.
  };
  return rules;
}

/// "sim" of a path in sim/; of one in scenarios/ the part as well, "scenarios/flight".
std::string FolderOf(const std::string& path) {
  const std::size_t end = path.find('/');
  const std::string folder = path.substr(0, end);
  return folder == "scenarios" ? path.substr(0, path.find('/', end + 1)) : folder;
}

bool IsLibraryAllowed(const std::string& path, const std::string& header) {
  return std::any_of(LibraryRules().begin(), LibraryRules().end(), [&](const LibraryRule& rule) {
    return std::regex_match(path, rule.path) && std::regex_match(header, rule.header);
  });
}

/// The complaint about one include; empty when there is none.
std::string Complaint(const std::string& path, const std::string& header, bool quoted) {
  if (!quoted) return IsLibraryAllowed(path, header) ? "" : "<" + header + "> does not belong here";
  if (header.find("..") != std::string::npos || header.find('/') == std::string::npos) {
    return "include \"" + header + "\" is not written from the root";
  }
  const std::string folder = FolderOf(path), target = FolderOf(header);
  return MayInclude().at(folder).contains(target) ? "" : folder + "/ must not include " + target + "/";
}

/// The complaints about one file's text. `path` is relative to the root, with forward slashes.
std::vector<std::string> Violations(const std::string& path, const std::string& text) {
  static const std::regex include_line(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<std::string> complaints;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_search(line, match, include_line)) continue;
    const std::string complaint = Complaint(path, match[2], match[1] == "\"");
    if (complaint.empty()) continue;
    complaints.push_back(path + ":" + std::to_string(number) + ": " + complaint);
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
  for (const auto& [folder, unused] : MayInclude()) {
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

TEST(Architecture, EveryFolderOfScenariosHasItsPlace) {
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(TOUCHDOWN_SOURCE_DIR) / "scenarios")) {
    if (!entry.is_regular_file() || !IsSource(entry.path())) continue;
    const std::string path = fs::relative(entry.path(), TOUCHDOWN_SOURCE_DIR).generic_string();
    EXPECT_TRUE(MayInclude().contains(FolderOf(path))) << path;
  }
}

/// What is wrong with one include line in the file `path`.
std::string FaultOf(const std::string& path, const std::string& include) {
  const auto violations = Violations(path, "\n#include " + include + "\n");
  return violations.empty() ? "" : violations.front();
}

TEST(Architecture, ComplainsOfASiblingAndAnUpperFloor) {
  EXPECT_EQ(FaultOf("estimator/a.cc", "\"sim/world.h\""), "estimator/a.cc:2: estimator/ must not include sim/");
  EXPECT_EQ(FaultOf("models/a.h", "\"scenarios/flight/metrics.h\""),
            "models/a.h:2: models/ must not include scenarios/flight/");
  EXPECT_NE(FaultOf("sim/a.cc", "\"../estimator/estimator.h\""), "");
  EXPECT_NE(FaultOf("sim/a.cc", "\"world.h\""), "");
  EXPECT_NE(FaultOf("sim/a.cc", "<estimator/estimator.h>"), "");
  EXPECT_EQ(FaultOf("scenarios/flight/a.cc", "\"sim/world.h\""), "");
}

TEST(Architecture, KeepsTheTestsOutOfTheProgram) {
  for (const std::string folder : {"models", "sim", "estimator", "controller", "scenarios/flight", "scenarios/cli"}) {
    EXPECT_NE(FaultOf(folder + "/a.cc", "\"tests/support/rooms.h\""), "");
    EXPECT_NE(FaultOf(folder + "/a.cc", "<tests/support/rooms.h>"), "");
  }
}

TEST(Architecture, LayersTheScenariosFromTheCommandsDownToTheFlight) {
  EXPECT_EQ(FaultOf("scenarios/cli/a.cc", "\"scenarios/study/a.h\""), "");
  EXPECT_EQ(FaultOf("scenarios/cli/a.cc", "\"scenarios/report/a.h\""), "");
  EXPECT_EQ(FaultOf("scenarios/study/a.cc", "\"scenarios/flight/a.h\""), "");
  EXPECT_EQ(FaultOf("scenarios/report/a.cc", "\"scenarios/flight/a.h\""), "");
  EXPECT_NE(FaultOf("scenarios/report/a.cc", "\"scenarios/study/a.h\""), "");
  EXPECT_NE(FaultOf("scenarios/study/a.cc", "\"scenarios/cli/a.h\""), "");
  for (const std::string part : {"cli", "report", "study"}) {
    EXPECT_NE(FaultOf("scenarios/flight/a.cc", "\"scenarios/" + part + "/a.h\""), "");
  }
}

TEST(Architecture, AllowsEachLibraryOnlyWhereItBelongs) {
  for (const std::string folder : {"models", "controller", "estimator", "sim", "scenarios/flight"}) {
    EXPECT_EQ(FaultOf(folder + "/a.h", "<Eigen/Core>"), "");
    EXPECT_EQ(FaultOf(folder + "/a.h", "<string_view>"), "");
    EXPECT_NE(FaultOf(folder + "/a.h", "<boost/optional.hpp>"), "");
  }
  EXPECT_EQ(FaultOf("estimator/paper/edges.cc", "<opencv2/imgproc.hpp>"), "");
  EXPECT_NE(FaultOf("estimator/paper/edges.h", "<opencv2/imgproc.hpp>"), "");
  EXPECT_NE(FaultOf("controller/a.cc", "<opencv2/core.hpp>"), "");
  EXPECT_NE(FaultOf("controller/a.cc", "<fmt/format.h>"), "");
  EXPECT_NE(FaultOf("models/a.cc", "<unistd.h>"), "");
  EXPECT_EQ(FaultOf("sim/a.cc", "<mujoco/mujoco.h>"), "");
  EXPECT_EQ(FaultOf("scenarios/footage/flight_bag.cc", "<rosbag/bag.h>"), "");
  EXPECT_NE(FaultOf("scenarios/footage/flight_bag.h", "<rosbag/bag.h>"), "");
  EXPECT_NE(FaultOf("scenarios/footage/footage.cc", "<sensor_msgs/Image.h>"), "");
  EXPECT_EQ(FaultOf("controller/a.cc", "<mujoco/mujoco.h>"),
            "controller/a.cc:2: <mujoco/mujoco.h> does not belong here");
}

}  // namespace
