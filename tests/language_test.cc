// Checks that code and documents do not contain the words to avoid of docs/glossary.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = TOUCHDOWN_SOURCE_DIR;

std::string ContentOf(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Pattern of whole words from the left column of the table "Words to avoid". "..." matches part of a line.
std::regex WordsToAvoid(const std::string& glossary) {
  static const std::regex row(R"(\n\| ([^|]+) \| [^|]+ \|)"), separator(R"(,\s*)"), gap(R"( \.\.\. )");
  const std::string table = glossary.substr(glossary.find("## Words to avoid"));
  std::string pattern;
  for (auto match = std::sregex_iterator(table.begin(), table.end(), row); match != std::sregex_iterator(); ++match) {
    const std::string cell = (*match)[1];
    if (cell == "do not write" || cell == "---") continue;
    const std::string words = std::regex_replace(cell, separator, "|");
    pattern += (pattern.empty() ? "" : "|") + std::regex_replace(words, gap, "[^.]{0,40} ");
  }
  return std::regex("\\b(" + pattern + ")\\b", std::regex::icase | std::regex::optimize);
}

/// First match of each line, as "LINE: WORD".
std::vector<std::string> Findings(const std::regex& words, const std::string& text) {
  std::vector<std::string> findings;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_search(line, match, words)) findings.push_back(std::to_string(number) + ": " + match.str());
  }
  return findings;
}

/// Headers, sources, scripts and documents, relative to the root, without generated ones.
std::vector<std::string> Files() {
  static const std::set<std::string> endings{".h", ".cc", ".md", ".py", ".js", ".mjs"};
  std::vector<std::string> files{"README.md", "CHANGELOG.md", "CONTRIBUTING.md"};
  for (const std::string folder : {"models", "sim", "estimator", "controller", "scenarios", "tests", "docs"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      const std::string file = fs::relative(entry.path(), kRoot).generic_string();
      const bool is_generated = file.starts_with("scenarios/report/web/dist/") || file.starts_with("docs/paper/");
      if (!is_generated && endings.contains(entry.path().extension().string())) files.push_back(file);
    }
  }
  return files;
}

/// Files that may contain such words. No file may be added.
std::set<std::string> Exceptions() {
  std::istringstream lines(ContentOf(kRoot / "tests" / "language_exceptions.txt"));
  return {std::istream_iterator<std::string>(lines), {}};
}

TEST(Language, ContainsNoWordsToAvoid) {
  const std::regex words = WordsToAvoid(ContentOf(kRoot / "docs" / "glossary.md"));
  std::set<std::string> exceptions = Exceptions();
  for (const std::string& file : Files()) {
    if (file == "docs/glossary.md") continue;
    const std::vector<std::string> findings = Findings(words, ContentOf(kRoot / file));
    if (exceptions.erase(file) == 0) {
      EXPECT_THAT(findings, testing::IsEmpty()) << file;
    } else {
      EXPECT_THAT(findings, testing::Not(testing::IsEmpty()))
          << file << " has none of the words: remove it from tests/language_exceptions.txt";
    }
  }
  EXPECT_THAT(exceptions, testing::IsEmpty()) << "no such files: remove them from tests/language_exceptions.txt";
}

TEST(Language, FindsWholeWordsAndGaps) {
  const std::regex words = WordsToAvoid(
      "## Words to avoid\n\n| do not write | write |\n| --- | --- |\n| foo, bar | x |\n| go ... on | y |\n");
  EXPECT_THAT(Findings(words, "Foo\nfood\na bar\ngo on\ngo for it on\ngo. on\n"),
              testing::ElementsAre("1: Foo", "3: bar", "4: go on", "5: go for it on"));
}

}  // namespace
