// Checks the documents for links to missing files and for placeholders.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> Documents() {
  const fs::path root = TOUCHDOWN_SOURCE_DIR;
  std::vector<fs::path> documents{root / "README.md", root / "CONTRIBUTING.md", root / "CHANGELOG.md"};
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") documents.push_back(entry.path());
  }
  return documents;
}

std::string TextOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Documents, LinkToExistingFiles) {
  const std::regex link(R"(\]\(([^)#:]+)(#[^)]*)?\))");
  for (const fs::path& document : Documents()) {
    const std::string text = TextOf(document);
    ASSERT_FALSE(text.empty()) << document;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), link); match != std::sregex_iterator(); ++match) {
      const fs::path target = document.parent_path() / (*match)[1].str();
      EXPECT_TRUE(fs::exists(target)) << document << " links to " << (*match)[1];
    }
  }
}

TEST(Documents, ContainNoPlaceholders) {
  const std::regex placeholder(R"(@[A-Z]+@|\bTODO\b|\bTBD\b)");
  for (const fs::path& document : Documents())
    EXPECT_FALSE(std::regex_search(TextOf(document), placeholder)) << document;
}

}  // namespace
