#include "scenarios/flight/platform.h"

#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <openssl/evp.h>
#include <sys/utsname.h>

#include <array>
#include <memory>
#include <opencv2/core/version.hpp>
#include <stdexcept>

namespace touchdown::scenarios {
namespace {

/// The instruction sets among which llvmpipe, OpenCV and libm choose their code.
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

std::string Sha256(const std::vector<const std::string*>& texts) {
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  bool good = context != nullptr && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
  for (const std::string* text : texts) good = good && EVP_DigestUpdate(context.get(), text->data(), text->size()) == 1;
  good = good && EVP_DigestFinal_ex(context.get(), digest.data(), &size) == 1;
  if (!good) throw std::runtime_error("OpenSSL cannot compute SHA-256");
  std::string hex;
  for (unsigned int i = 0; i < size; ++i) hex += fmt::format("{:02x}", digest[i]);
  return hex;
}

}  // namespace touchdown::scenarios
