#include "scenarios/util/program_digest.h"

#include "scenarios/util/file.h"
#include "scenarios/util/sha256.h"

namespace touchdown::util {

const std::string& ProgramDigest() {
  static const std::string digest = Sha256(ReadTextFile("/proc/self/exe"));
  return digest;
}

}  // namespace touchdown::util
