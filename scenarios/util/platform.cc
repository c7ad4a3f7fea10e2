#include "scenarios/util/platform.h"

#include <gnu/libc-version.h>
#include <sys/utsname.h>

#include <opencv2/core/version.hpp>

namespace touchdown::util {
namespace {

/// Supported instruction sets, on which the code that llvmpipe, OpenCV and libm select depends.
std::string CpuFlags() {
  std::string flags;
#if defined(__x86_64__)
  __builtin_cpu_init();
  const auto add = [&flags](bool has, const char* name) {
    if (has) flags += (flags.empty() ? "" : " ") + std::string(name);
  };
  add(__builtin_cpu_supports("sse4.2"), "sse4.2");
  add(__builtin_cpu_supports("avx"), "avx");
  add(__builtin_cpu_supports("avx2"), "avx2");
  add(__builtin_cpu_supports("fma"), "fma");
  add(__builtin_cpu_supports("avx512f"), "avx512f");
  add(__builtin_cpu_supports("avx512bw"), "avx512bw");
  add(__builtin_cpu_supports("avx512dq"), "avx512dq");
  add(__builtin_cpu_supports("avx512vl"), "avx512vl");
#endif
  return flags;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> PlatformFacts() {
  utsname system{};
  uname(&system);
  return {{"machine", system.machine},
          {"cpu_flags", CpuFlags()},
          {"compiler", "gcc " __VERSION__},
          {"libc", gnu_get_libc_version()},
          {"opencv", CV_VERSION}};
}

std::string HostName() {
  utsname system{};
  uname(&system);
  return system.nodename;
}

}  // namespace touchdown::util
