#include "app/shell/standard_input.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "app/shell/interrupt.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

std::vector<std::uint8_t> read_all(std::uint64_t most) {
  if (is_terminal(stdin))
    throw Error(ExitCode::WrongUsage,
                "the scene - is read from standard input, which is a terminal: send a .glb file into it");
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 1 << 16> piece;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  while (bytes.size() <= most) {
    // Waited for here: a signal ends poll(), but not read().
    const bool signalled = poll(&input, 1, -1) < 0 && errno == EINTR;
    stop_if_interrupted();
    if (signalled) continue;
    const ssize_t count = ::read(STDIN_FILENO, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      throw Error(ExitCode::BadInput, std::string("standard input cannot be read: ") + std::strerror(errno));
    if (count == 0) break;
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + count);
  }
  return bytes;
}

}  // namespace

std::shared_ptr<const std::vector<std::uint8_t>> standard_input(std::uint64_t most) {
  static const auto bytes = std::make_shared<const std::vector<std::uint8_t>>(read_all(most));
  return bytes;
}

}  // namespace caustics::app
