#include "scenarios/cli/progress_line.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstdio>

namespace touchdown::scenarios {
namespace {

constexpr double kIntervalOnTerminal_s = 0.2;
constexpr double kInterval_s = 5.0;
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

ProgressLine::ProgressLine() : on_terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (on_terminal_ && shown_) std::fputs(kClearLine, stderr);
}

bool ProgressLine::IsDue() const {
  if (!on_terminal_) return since_shown_.seconds() > kInterval_s;
  return !shown_ || since_shown_.seconds() > kIntervalOnTerminal_s;
}

void ProgressLine::Show(const std::string& text) {
  if (on_terminal_) {
    std::fprintf(stderr, "%s%s", kClearLine, text.c_str());
    std::fflush(stderr);
  } else {
    spdlog::info("{}", text);
  }
  shown_ = true;
  since_shown_ = Stopwatch();
}

}  // namespace touchdown::scenarios
