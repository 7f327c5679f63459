#include "app/shell/interrupt.hpp"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>

namespace caustics::app {

namespace {

// Paths in plain memory, because a signal handler may call little more than unlink and _exit.
struct Temporary {
  volatile std::sig_atomic_t used = 0;
  char path[4096] = {};
};
std::array<Temporary, 16> temporaries;

extern "C" void on_signal(int signal) {
  if (interruption() == ExitCode::Done) return ask_to_stop(static_cast<ExitCode>(128 + signal));
  for (const Temporary& temporary : temporaries) {
    if (temporary.used) unlink(temporary.path);
  }
  _exit(128 + signal);
}

void catch_signal(int signal) {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void watch_for_interruption() {
  catch_signal(SIGINT);
  catch_signal(SIGTERM);
  // A reader that goes away, and a file beyond the allowed size, show up as errors of write
  // instead.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void register_temporary(const std::string& path) {
  for (Temporary& temporary : temporaries) {
    if (temporary.used || path.size() >= sizeof temporary.path) continue;
    std::memcpy(temporary.path, path.c_str(), path.size() + 1);
    temporary.used = 1;
    return;
  }
}

void release_temporary(const std::string& path) {
  for (Temporary& temporary : temporaries) {
    if (temporary.used && path == temporary.path) temporary.used = 0;
  }
}

}  // namespace caustics::app
