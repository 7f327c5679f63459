// caustics_digest: `caustics digest` without the rest of the program. It links neither OpenGL nor the tracer
// nor anything that writes images, so it is quick to build many times over, and for machines that lack those
// libraries.
#include "app/shell/run_program.hpp"

namespace {

// Takes what `caustics` takes, so that either can stand where the other is asked for.
caustics::ExitCode digest(const caustics::app::Arguments& arguments) {
  if (arguments.empty() || arguments.front() != "digest") {
    throw caustics::Error(caustics::ExitCode::WrongUsage, "this program has one command: digest");
  }
  return caustics::app::run_digest({arguments.begin() + 1, arguments.end()});
}

}  // namespace

int main(int count, char** values) { return caustics::app::run_program(count, values, digest); }
