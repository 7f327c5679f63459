// A program that this one feeds through a pipe: started without a shell.
#pragma once
#include <sys/types.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace caustics::app {

// Where PATH has a program of this name; empty: nowhere.
std::filesystem::path find_program(const std::string& name);

class ChildProcess {
 public:
  // Starts it; arguments[0] is its file. Its standard output is dropped, what it complains about is
  // kept. Ctrl-C in the terminal reaches this program alone. Throws Error (CannotWrite).
  explicit ChildProcess(const std::vector<std::string>& arguments);
  // Ends it at once where it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Into its standard input; false when it does not read any more.
  bool write_all(const void* data, std::size_t size);
  // Closes its input and waits for its end; true where it reports success.
  bool finish();
  // The last line of its complaints, or how it ended; after finish().
  std::string complaint() const;

 private:
  pid_t process_ = -1;
  int input_ = -1;  // the end that this program writes to
  int status_ = 0;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> complaints_;
};

}  // namespace caustics::app
