// What happens before work on other threads starts, and what it leaves behind, as the thread sanitizer has to
// be told: it cannot see into a oneTBB that was built without it. Elsewhere nothing.
#pragma once

#if defined(__SANITIZE_THREAD__)
#define CAUSTICS_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CAUSTICS_THREAD_SANITIZER 1
#endif
#endif

namespace caustics {

#if CAUSTICS_THREAD_SANITIZER
extern "C" void __tsan_acquire(void*);
extern "C" void __tsan_release(void*);
inline void happens_before(void* tag) { __tsan_release(tag); }
inline void happens_after(void* tag) { __tsan_acquire(tag); }
#else
inline void happens_before(void*) {}
inline void happens_after(void*) {}
#endif

}  // namespace caustics
