// Included before every source that Emscripten compiles: what its libc++ lacks of C++20, version 13 most of
// it, later ones less. The conversions of numbers serve options and messages; no scene and no image passes
// through them.
#pragma once
#include <bit>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>

namespace std {

#if !defined(__cpp_lib_bit_cast)
template <class To, class From>
constexpr To bit_cast(const From& from) {
  return __builtin_bit_cast(To, from);
}
#endif

#if !defined(__cpp_lib_smart_ptr_for_overwrite)
template <class Array>
unique_ptr<Array> make_unique_for_overwrite(size_t count) {
  return unique_ptr<Array>(new remove_extent_t<Array>[count]);
}
#endif

#if _LIBCPP_VERSION < 200000
// Of what from_chars takes, plain decimal numbers.
template <class Real, class = enable_if_t<is_floating_point_v<Real>>>
from_chars_result from_chars(const char* first, const char* last, Real& value) {
  const string text(first, last);
  if (text.empty() || !strchr("-.0123456789", text[0]) || text.find_first_of("xX") != string::npos) {
    return {first, errc::invalid_argument};
  }
  char* end = nullptr;
  const Real read =
      is_same_v<Real, float> ? strtof(text.c_str(), &end) : static_cast<Real>(strtod(text.c_str(), &end));
  if (end == text.c_str()) return {first, errc::invalid_argument};
  value = read;
  return {first + (end - text.c_str()), errc{}};
}
#endif

#if _LIBCPP_VERSION < 14000
inline to_chars_result to_chars(char* first, char* last, double value, chars_format, int digits) {
  const int length = snprintf(first, static_cast<size_t>(last - first), "%.*g", digits, value);
  return {first + length, errc{}};
}

// The shortest text that is read back as the same number.
inline to_chars_result to_chars(char* first, char* last, double value) {
  to_chars_result result{};
  for (int digits = 1; digits <= 17; ++digits) {
    result = to_chars(first, last, value, chars_format::general, digits);
    if (strtod(string(first, result.ptr).c_str(), nullptr) == value) break;
  }
  return result;
}
#endif

}  // namespace std
