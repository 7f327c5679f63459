#include "pipeline/gpu/image.hpp"

#include <cmath>
#include <limits>

#include "pipeline/gpu/sha256.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

std::string digest(const std::string& message) {
  Sha256 hash;
  hash.add(message.data(), message.size());
  return hash.hexadecimal();
}

}  // namespace

TEST_CASE("sha256: the examples of FIPS 180-4 and of its longer message") {
  CHECK(digest("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(digest("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(digest(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("image: a digest tells formats, sizes and every bit apart") {
  Image a(Format::RGBA32F, 2, 1), b(Format::RGBA32F, 1, 2), c(Format::RGBA16F, 2, 1);
  Image negative_zero = a;
  negative_zero.values[3] = -0.0f;
  CHECK(sha256(a) == sha256(Image(Format::RGBA32F, 2, 1)));
  CHECK(sha256(a) != sha256(b));
  CHECK(sha256(a) != sha256(c));
  CHECK(sha256(a) != sha256(negative_zero));
  // The lowest bit counts, and so do the first texels of an image that is hashed in several pieces.
  Image low_bit = a;
  low_bit.values[7] = std::numeric_limits<float>::denorm_min();
  CHECK(sha256(a) != sha256(low_bit));
  for (const Format format : {Format::R32F, Format::RGBA16F}) {
    Image long_image(format, 200, 200);
    const std::string of_long = sha256(long_image);
    long_image.values[0] = 1.0f;
    CHECK(sha256(long_image) != of_long);
  }
}

TEST_CASE("image: NaN and infinity are counted") {
  Image image(Format::R32F, 3, 1);
  CHECK(count_non_finite(image) == 0);
  image.values[0] = std::nanf("");
  image.values[2] = -INFINITY;
  CHECK(count_non_finite(image) == 2);
}
