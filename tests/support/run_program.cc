#include "tests/support/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>

namespace touchdown::tests {
namespace {

std::string ReadAndRemove(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(stream), {}};
  std::filesystem::remove(file);
  return content;
}

void InterruptWhenDue(pid_t child, const Interruption& interruption) {
  siginfo_t info{};
  const auto has_ended = [&] {
    return waitid(P_PID, child, &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid != 0;
  };
  while (!interruption.when()) {
    if (has_ended()) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(child, interruption.signal);
}

}  // namespace

ProgramRun RunProgram(const std::string& program, const std::vector<std::string>& arguments,
                      const std::filesystem::path& folder, const Interruption& interruption) {
  static int runs = 0;  // Several programs may run at the same time.
  const std::filesystem::path base =
      folder.parent_path() / (folder.filename().string() + ".captured_" + std::to_string(runs++));
  const std::string out_file = base.string() + "_out", err_file = base.string() + "_err";
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) {
    const int out = open(out_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    const int err = open(err_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (chdir(folder.c_str()) == 0 && dup2(out, STDOUT_FILENO) >= 0 && dup2(err, STDERR_FILENO) >= 0) {
      execv(program.c_str(), argv.data());
    }
    _exit(127);
  }
  if (interruption.signal != 0) InterruptWhenDue(child, interruption);
  int state = 0;
  waitpid(child, &state, 0);
  ProgramRun run;
  if (WIFEXITED(state)) run.status = WEXITSTATUS(state);
  run.out = ReadAndRemove(out_file);
  run.err = ReadAndRemove(err_file);
  return run;
}

}  // namespace touchdown::tests
