#include "scenarios/util/program_digest.h"

#include <fstream>
#include <iterator>

#include "scenarios/util/sha256.h"

namespace touchdown::util {

const std::string& ProgramDigest() {
  static const std::string digest = [] {
    std::ifstream stream("/proc/self/exe", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    return Sha256({&bytes});
  }();
  return digest;
}

}  // namespace touchdown::util
