// Compares the lists of keys and metrics in docs/scenarios.md with the program. To update the lists:
//   TOUCHDOWN_WRITE_DOCS=1 build/release/tests/scenarios/report/report_tests --gtest_filter=Docs.*
#include "scenarios/report/reference_markdown.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace touchdown::report {
namespace {

const std::string kDoc = std::string(TOUCHDOWN_SOURCE_DIR) + "/docs/scenarios.md";

std::string ReadDoc() {
  std::ifstream stream(kDoc);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void ExpectInDoc(const std::string& name, const std::string& table) {
  const std::string begin = "<!-- " + name + ": begin -->\n", end = "<!-- " + name + ": end -->";
  std::string doc = ReadDoc();
  const std::size_t from = doc.find(begin), to = doc.find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  if (std::getenv("TOUCHDOWN_WRITE_DOCS") != nullptr) {
    doc.replace(from + begin.size(), to - from - begin.size(), table);
    std::ofstream(kDoc) << doc;
  } else {
    EXPECT_EQ(doc.substr(from + begin.size(), to - from - begin.size()), table);
  }
}

TEST(Docs, ListAllMetrics) { ExpectInDoc("metrics", MetricsMarkdown()); }

TEST(Docs, ListAllKeys) { ExpectInDoc("keys", KeysMarkdown()); }

}  // namespace
}  // namespace touchdown::report
