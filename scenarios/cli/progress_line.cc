#include "scenarios/cli/progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace touchdown::scenarios {
namespace {

constexpr double kInterval_s = 0.2;
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

ProgressLine::ProgressLine() : on_terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs(kClearLine, stderr);
}

bool ProgressLine::IsDue() const { return on_terminal_ && (!shown_ || since_shown_.seconds() > kInterval_s); }

void ProgressLine::Show(const std::string& text) {
  std::fprintf(stderr, "%s%s", kClearLine, text.c_str());
  std::fflush(stderr);
  shown_ = true;
  since_shown_ = Stopwatch();
}

}  // namespace touchdown::scenarios
