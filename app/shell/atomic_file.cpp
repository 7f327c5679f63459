#include "app/shell/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "app/shell/interrupt.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void cannot_write(const fs::path& path, const std::string& why) {
  throw Error(ExitCode::CannotWrite, path.string() + ": cannot write: " + why);
}

std::string last_error() { return std::strerror(errno); }

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// Paths without links stay as they were typed, for messages.
fs::path target_of(const fs::path& path) {
  std::error_code error;
  return fs::is_symlink(path, error) ? followed(path) : path;
}

void write_to_standard_output(const void* data, std::size_t size) {
  if (std::fwrite(data, 1, size, stdout) != size || std::fflush(stdout) != 0)
    throw Error(ExitCode::CannotWrite, "standard output cannot be written");
}

// Only plain files are replaced: not a folder, nor a device or a pipe.
void require_replaceable(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::directory) cannot_write(path, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    cannot_write(path, "it is not a plain file");
  }
  if (!fs::exists(folder_of(path), error)) {
    cannot_write(path, "there is no folder '" + folder_of(path).string() + "'");
  }
}

}  // namespace

PendingFile::PendingFile(const fs::path& path) : target_(target_of(path)) {
  require_replaceable(target_);
  for (int attempt = 0; attempt < 100 && descriptor_ < 0; ++attempt) {
    name_ = (folder_of(target_) /
             (".caustics-" + std::to_string(getpid()) + "-" + std::to_string(attempt) + ".tmp"))
                .string();
    descriptor_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) break;
  }
  if (descriptor_ < 0) cannot_write(target_, last_error());
  register_temporary(name_);
}

PendingFile::~PendingFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!moved_) unlink(name_.c_str());
  release_temporary(name_);
}

void PendingFile::write_all(const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(descriptor_, data, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) cannot_write(target_, last_error());
    data += written;
    size -= static_cast<std::size_t>(written);
  }
}

// The folder is flushed so that the rename stays.
void PendingFile::move_into_place() {
  if (fsync(descriptor_) != 0) cannot_write(target_, last_error());
  if (close(std::exchange(descriptor_, -1)) != 0) cannot_write(target_, last_error());
  if (rename(name_.c_str(), target_.c_str()) != 0) cannot_write(target_, last_error());
  moved_ = true;
  const int folder = open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder >= 0) {
    fsync(folder);
    close(folder);
  }
}

void require_writable(const fs::path& path) { const PendingFile probe(path); }

void require_output(RunFiles& files, const fs::path& path, const std::string& option, Content content) {
  files.writes(path, option);
  if (!is_standard_output(path)) return require_writable(path);
  if (content == Content::Binary && is_terminal(stdout))
    throw Error(ExitCode::WrongUsage,
                option + " -: standard output is a terminal; send it on, as in ... " + option + " - > FILE");
}

void refuse_standard_output(const fs::path& path, const std::string& option, const std::string& why) {
  if (is_standard_output(path))
    throw Error(ExitCode::WrongUsage, option + " cannot be -, standard output: " + why);
}

void write_atomically(const fs::path& path, const void* data, std::size_t size) {
  if (is_standard_output(path)) return write_to_standard_output(data, size);
  PendingFile file(path);
  file.write_all(static_cast<const char*>(data), size);
  stop_if_interrupted();
  file.move_into_place();
}

void write_atomically(const fs::path& path, std::string_view text) {
  write_atomically(path, text.data(), text.size());
}

}  // namespace caustics::app
