#include "app/shell/child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "pipeline/gpu/error.hpp"

extern char** environ;

namespace caustics::app {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void cannot_start(const std::string& program, int error) {
  throw Error(ExitCode::CannotWrite, program + ": cannot start: " + std::strerror(error));
}

// What is set up in the child before it becomes the other program.
class SpawnSetup {
 public:
  SpawnSetup(int input, int complaints) {
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, complaints, STDERR_FILENO);
    posix_spawnattr_init(&attributes);
    // This program ignores some signals, which a child would inherit; and a group of its own keeps the
    // terminal's Ctrl-C away from it.
    sigset_t usual;
    sigemptyset(&usual);
    for (const int signal : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM}) sigaddset(&usual, signal);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;

  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
};

}  // namespace

fs::path find_program(const std::string& name) {
  const char* variable = std::getenv("PATH");
  const std::string list = variable ? variable : "/usr/local/bin:/usr/bin:/bin";
  for (std::size_t start = 0; start <= list.size();) {
    const std::size_t end = std::min(list.find(':', start), list.size());
    fs::path file = fs::path(list.substr(start, end - start)) / name;
    std::error_code error;
    if (end > start && fs::is_regular_file(file, error) && access(file.c_str(), X_OK) == 0) return file;
    start = end + 1;
  }
  return {};
}

ChildProcess::ChildProcess(const std::vector<std::string>& arguments)
    : complaints_(std::tmpfile(), std::fclose) {
  int ends[2];
  if (!complaints_ || pipe2(ends, O_CLOEXEC) != 0) cannot_start(arguments[0], errno);
  std::vector<char*> list;
  list.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) list.push_back(const_cast<char*>(argument.c_str()));
  list.push_back(nullptr);
  const SpawnSetup setup(ends[0], fileno(complaints_.get()));
  const int error =
      posix_spawn(&process_, arguments[0].c_str(), &setup.files, &setup.attributes, list.data(), environ);
  close(ends[0]);
  input_ = ends[1];
  if (error == 0) return;
  close(input_);
  cannot_start(arguments[0], error);
}

ChildProcess::~ChildProcess() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    finish();
  }
}

bool ChildProcess::write_all(const void* data, std::size_t size) {
  auto at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(input_, at, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

bool ChildProcess::finish() {
  if (input_ >= 0) close(std::exchange(input_, -1));
  if (process_ > 0) {
    while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
  }
  return WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
}

std::string ChildProcess::complaint() const {
  std::string last, line;
  std::FILE* const said = complaints_.get();
  std::rewind(said);
  for (int c = std::fgetc(said); c != EOF; c = std::fgetc(said)) {
    if (c != '\n') {
      if (line.size() < 400) line += static_cast<char>(c);
      continue;
    }
    if (!line.empty()) last = std::exchange(line, "");
  }
  if (!line.empty()) last = line;
  if (!last.empty()) return last;
  if (WIFSIGNALED(status_)) return "ended by signal " + std::to_string(WTERMSIG(status_));
  return "ended with code " + std::to_string(WEXITSTATUS(status_));
}

}  // namespace caustics::app
