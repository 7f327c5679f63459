// Put into the planted copy of the sources (plant.py), never into the product: which fault runs, and which
// places of faults a test has reached.
#pragma once
#include <string>
#include <string_view>

// The number of the fault that the variable CAUSTICS_FAULT names; 0 without one.
extern "C" int caustics_fault;
// A byte for each place: whether it was reached. Two places may share one; the tests of both are tried for
// both.
extern "C" unsigned char* caustics_reached;

constexpr int kFaultPlaces = 1 << 16;

// Written once, or all threads would write to the same lines of memory in the innermost loops.
inline bool fault_reached(int number) {
  unsigned char& mark = caustics_reached[number % kFaultPlaces];
  if (mark == 0) mark = 1;
  return caustics_fault == number;
}

#define FAULT(number) fault_reached(number)

// The same choice for OpenGL's texts, and for the page's script.
inline std::string fault_text() {
  return "#define FAULT(number) (number == " + std::to_string(caustics_fault) + ")\n";
}
std::string fault_script();

// A value in a sentence, printed wrong: another first digit, or letters in another order.
inline std::string altered(std::string_view text) {
  std::string other(text);
  const std::size_t digit = other.find_first_of("0123456789");
  if (digit == std::string::npos) return "?" + std::string(other.rbegin(), other.rend());
  other[digit] = static_cast<char>('0' + (other[digit] - '0' + 1) % 10);
  return other;
}
inline std::string altered(char letter) { return letter == '?' ? "!" : "?"; }
