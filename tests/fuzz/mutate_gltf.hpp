// Mutations that know what a glTF file is made of, so that most of them get past the JSON parser.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace caustics::fuzz {

// A .glb taken apart; of a .gltf, or of anything else, `json` is all of it.
struct Parts {
  std::string json, bin;
  bool glb = false;
};
Parts parts_of(const std::string& bytes);
// With lengths and padding put right.
std::string joined(const Parts& parts);

// Replaces one number of the text by a hard one (0, -1, 1e38, ...), by another of its numbers, or by one near
// it.
void change_number(std::string& json, unsigned seed);
// Takes out, doubles or swaps with another one value of the text, between brackets or commas.
void change_value(std::string& json, unsigned seed);
// Replaces one aligned four-byte word by a hard float or a small index.
void change_word(std::string& bin, unsigned seed);

}  // namespace caustics::fuzz
