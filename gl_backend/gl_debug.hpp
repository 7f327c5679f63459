// Faults that OpenGL reports, as Errors.
#pragma once
#include <string>

namespace caustics::gl {

// Notices faults in the current context, which must outlive it. With `messages` it also collects the driver's
// debug messages of type error or of high severity, which then come while the faulty call runs.
class DebugLog {
 public:
  explicit DebugLog(bool messages);
  ~DebugLog();
  DebugLog(const DebugLog&) = delete;
  DebugLog& operator=(const DebugLog&) = delete;
  // Called by the driver.
  void add(const char* message);
  // Throws what has gone wrong since the last call, `what` in front ("pass 'caustic_map'"): Error
  // (BackendUnavailable) for a lost context and for memory that has run out, else (InternalError).
  void check(const std::string& what);
  // Drops what has been collected, where the caller reports the fault itself; but a lost context and memory
  // that has run out, which are the reason then, it throws as check() does.
  void forget(const std::string& what);
  // Drops everything, after calls whose failure takes nothing from anyone: an object that is not deleted.
  void drop();

 private:
  bool messages_;
  std::string first_;
};

}  // namespace caustics::gl
