#include "app/shell/own_process.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "app/shell/interrupt.hpp"
#include "app/shell/run_program.hpp"

namespace caustics::app {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void work_and_end(const std::function<Answer()>& work, std::FILE* answer) {
  setpgid(0, 0);  // the terminal's Ctrl-C reaches the program alone, which hands it on once
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  signal(SIGTTOU, SIG_IGN);  // it may write to the terminal all the same
  const int code = report_errors([&] {
    const Answer given = work();
    if (std::fputs(given.text.c_str(), answer) < 0 || std::fflush(answer) != 0)
      throw Error(ExitCode::CannotWrite, "a temporary file cannot be written");
    return given.code;
  });
  std::exit(code);
}

// Hands an interruption on, once.
int status_of(pid_t process) {
  bool told = false;
  for (int status = 0;;) {
    const pid_t ended = waitpid(process, &status, WNOHANG);
    if (ended == process) return status;
    if (ended < 0 && errno != EINTR) return -1;
    if (interruption() != ExitCode::Done && !told) {
      kill(process, interruption() == ExitCode::Terminated ? SIGTERM : SIGINT);
      told = true;
    }
    usleep(20000);
  }
}

std::string contents(std::FILE* file) {
  std::string text;
  char part[4096];
  std::rewind(file);
  while (const std::size_t size = std::fread(part, 1, sizeof part, file)) text.append(part, size);
  return text;
}

}  // namespace

Answer in_own_process(const std::function<Answer()>& work) {
  const File file(std::tmpfile(), std::fclose);
  if (!file) throw Error(ExitCode::CannotWrite, std::string("no temporary file: ") + std::strerror(errno));
  // What is buffered would be written twice.
  std::fflush(stdout);
  std::fflush(stderr);
  const pid_t process = fork();
  if (process < 0)
    throw Error(ExitCode::CannotWrite, std::string("no further process: ") + std::strerror(errno));
  if (process == 0) work_and_end(work, file.get());
  const int status = status_of(process);
  if (!WIFEXITED(status))
    throw Error(ExitCode::InternalError, "a measuring process ended by signal " +
                                             std::to_string(WIFSIGNALED(status) ? WTERMSIG(status) : 0));
  return {static_cast<ExitCode>(WEXITSTATUS(status)), contents(file.get())};
}

}  // namespace caustics::app
