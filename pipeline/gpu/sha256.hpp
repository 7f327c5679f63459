// SHA-256 (FIPS 180-4), so that the core needs no library to name its images.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace caustics {

class Sha256 {
 public:
  void add(const void* data, std::size_t size);
  // Ends the message and returns its digest as 64 hexadecimal digits. Call once.
  std::string hexadecimal();

 private:
  void compress(const std::uint8_t* block);

  std::array<std::uint32_t, 8> state_{0x6a09e667u, 0xbb67ae85u, 0x3c6ef372u, 0xa54ff53au,
                                      0x510e527fu, 0x9b05688cu, 0x1f83d9abu, 0x5be0cd19u};
  std::array<std::uint8_t, 64> pending_{};
  std::size_t pending_size_ = 0;
  std::uint64_t total_bytes_ = 0;
};

}  // namespace caustics
