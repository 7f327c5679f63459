#include "app/shell/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "app/shell/interrupt.hpp"
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

// What a link points to, as far as it can be followed.
fs::path followed(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? path : target;
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

PendingFile::PendingFile(const fs::path& path) : target_(followed(path)) {
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

void write_atomically(const fs::path& path, const void* data, std::size_t size) {
  PendingFile file(path);
  file.write_all(static_cast<const char*>(data), size);
  stop_if_interrupted();
  file.move_into_place();
}

void write_atomically(const fs::path& path, std::string_view text) {
  write_atomically(path, text.data(), text.size());
}

}  // namespace caustics::app
