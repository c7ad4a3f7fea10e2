#include "scenarios/cli/progress.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace touchdown::cli {
namespace {

constexpr double kIntervalOnTerminal_s = 0.2;
constexpr double kInterval_s = 5.0;
constexpr const char* kClearLine = "\r\033[K";

/// Remaining time as text, such as ", 3 min 20 s left", extrapolated from the fraction of the work that was done in
/// `elapsed_s`. Empty while that fraction or time is too small.
std::string RemainingTime(double done, double left, double elapsed_s) {
  constexpr double kMinFraction = 0.01, kMinElapsed_s = 1.0;
  if (done < kMinFraction || elapsed_s < kMinElapsed_s) return "";
  const int left_s = static_cast<int>(std::lround(elapsed_s * left / done));
  constexpr int kMinute_s = 60;
  if (left_s < 2 * kMinute_s) return fmt::format(", {} s left", left_s);
  return fmt::format(", {} min {} s left", left_s / kMinute_s, left_s % kMinute_s);
}

}  // namespace

Progress::Progress(bool quiet) : quiet_(quiet), on_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (on_terminal_ && shown_) std::fputs(kClearLine, stderr);
}

bool Progress::IsDue() const {
  if (quiet_) return false;
  if (!on_terminal_) return since_shown_.seconds() > kInterval_s;
  return !shown_ || since_shown_.seconds() > kIntervalOnTerminal_s;
}

void Progress::Update(double fraction, const std::string& text) {
  if (quiet_) return;
  constexpr double kPercent = 100.0;
  const std::string line =
      fmt::format("{:3.0f} %  {}{}", kPercent * fraction, text,
                  RemainingTime(fraction - initial_fraction_, 1.0 - fraction, since_start_.seconds()));
  if (on_terminal_) {
    std::fprintf(stderr, "%s%s", kClearLine, line.c_str());
    std::fflush(stderr);
  } else {
    spdlog::info("{}", line);
  }
  shown_ = true;
  since_shown_ = util::Stopwatch();
}

}  // namespace touchdown::cli
