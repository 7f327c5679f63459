#include "app/shell/run_program.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <new>

#include "app/shell/interrupt.hpp"
#include "app/shell/terminal.hpp"

namespace caustics::app {

namespace {

int fail(ExitCode code, const std::string& line) {
  // An interruption ends with the signal's own code, whatever it broke off.
  if (const ExitCode signal = interruption(); signal != ExitCode::Done) {
    complain("interrupted; no incomplete file is left");
    return static_cast<int>(signal);
  }
  complain(line);
  return static_cast<int>(code);
}

// Has whoever read from our pipe had enough? `head` does so, and nobody wants to hear of it.
bool reader_has_gone() {
  pollfd out{STDOUT_FILENO, POLLOUT, 0};
  return poll(&out, 1, 0) > 0 && (out.revents & POLLERR) != 0;
}

}  // namespace

int report_errors(const std::function<ExitCode()>& work) {
  try {
    return static_cast<int>(work());
  } catch (const Error& error) {
    return fail(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::WrongUsage,
                "out of memory: choose a smaller -r, --grid or --map, or a smaller scene");
  } catch (const std::exception& error) {
    return fail(ExitCode::InternalError, std::string("internal error: ") + error.what());
  } catch (...) {
    return fail(ExitCode::InternalError, "internal error of an unknown kind");
  }
}

int run_program(int count, char** values, ExitCode (*work)(const Arguments& arguments)) {
  watch_for_interruption();
  const int code =
      report_errors([&] { return work(Arguments(values + std::min(count, 1), values + count)); });
  // Standard output may be a full disk or a closed pipe; then what was printed did not arrive.
  const bool answered =
      code == static_cast<int>(ExitCode::Done) || code == static_cast<int>(ExitCode::AnswerIsNo);
  if ((std::fflush(stdout) != 0 || std::ferror(stdout) != 0) && answered) {
    if (!reader_has_gone()) complain("standard output cannot be written");
    return static_cast<int>(ExitCode::CannotWrite);
  }
  return code;
}

}  // namespace caustics::app
