// Containers and the files that a scene refers to.
#include <algorithm>

#include "pipeline/image_io/image_io.hpp"
#include "pipeline/scene/gltf/load_environment.hpp"
#include "tests/scene/gltf_builder.hpp"
#include "tests/support/skip.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

namespace fs = std::filesystem;

std::string binary_triangle() {
  const Gltf gltf = triangle();
  std::string json = gltf.json();
  const std::size_t begin = json.find(",\"uri\""), end = json.find('}', begin);
  return glb(json.erase(begin, end - begin), gltf.data);
}

// The message with which loading this file fails, or "loaded".
std::string outcome(const fs::path& path) {
  try {
    load_gltf(path);
    return "loaded";
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::BadInput);
    return error.what();
  }
}

std::string with_buffer(const Folder& folder, const std::string& uri) {
  Gltf gltf = triangle();
  gltf.uri = uri;
  return outcome(folder.write("scene.gltf", gltf.json()));
}

}  // namespace

TEST_CASE("A file that gives fewer bytes than its size is refused") {
  // Such files are there on Linux: the kernel's own say 4096 and hold a few.
  const fs::path short_file = "/sys/devices/system/cpu/possible";
  std::error_code ignored;
  if (!fs::is_regular_file(short_file, ignored) || fs::file_size(short_file, ignored) < 1000)
    skip("no " + short_file.string());
  CHECK(contains(outcome(short_file), "possible: cannot be read"));
}

TEST_CASE("A .glb is recognised by its content, whatever its name") {
  const Folder folder;
  CHECK(load_gltf(folder.write("scene.gltf", binary_triangle())).meshes.size() == 1);
  CHECK(load_gltf(folder.write("scene.glb", triangle().json())).meshes.size() == 1);
}

TEST_CASE("A damaged .glb is refused") {
  const Folder folder;
  const std::string good = binary_triangle();
  const std::string said = "the .glb header says " + std::to_string(good.size()) + " bytes, the file has 200";
  CHECK(contains(outcome(folder.write("a.glb", good.substr(0, 200))), said));
  CHECK(contains(outcome(folder.write("a.glb", good.substr(0, 12))), "too short"));
  std::string bad = good;
  bad[12] = bad[13] = bad[14] = bad[15] = '\xff';
  CHECK(contains(outcome(folder.write("a.glb", bad)), "GLB chunk 0: is longer than the file"));
  bad = good;
  bad[4] = 1;
  CHECK(contains(outcome(folder.write("a.glb", bad)), "version 1"));
  bad = good;
  bad[16] = 'X';
  CHECK(contains(outcome(folder.write("a.glb", bad)), "GLB chunk 0: must be the JSON"));
}

TEST_CASE("A buffer beside the file is read, also with a space in its name") {
  const Folder folder;
  folder.write("my data.bin", triangle().data + "padding");
  CHECK(with_buffer(folder, "my%20data.bin") == "loaded");
  CHECK(with_buffer(folder, "./my data.bin") == "loaded");
}

TEST_CASE("Buffers outside the file's folder are refused, however they are spelled") {
  const Folder outer;
  outer.write("secret.bin", triangle().data);
  const Folder folder;
  const std::string up = "../" + outer.path().filename().string() + "/secret.bin";
  CHECK(contains(with_buffer(folder, up), "buffers[0].uri: leaves"));
  CHECK(contains(with_buffer(folder, "%2e%2e" + up.substr(2)), "buffers[0].uri: leaves"));
  CHECK(contains(with_buffer(folder, "a/../" + up), "buffers[0].uri: leaves"));
  CHECK(contains(with_buffer(folder, (outer.path() / "secret.bin").string()), "buffers[0].uri: leaves"));
  CHECK(contains(with_buffer(folder, "file:///etc/passwd"), "buffers[0].uri: only data: URIs"));
  CHECK(contains(with_buffer(folder, "..%5csecret.bin"), "buffers[0].uri: holds"));
  CHECK(contains(with_buffer(folder, "a%00b"), "buffers[0].uri: holds a control character"));
  fs::create_symlink(outer.path() / "secret.bin", folder.path() / "link.bin");
  CHECK(contains(with_buffer(folder, "link.bin"), "buffers[0].uri: leaves the glTF file's folder by a link"));
}

TEST_CASE("Folders, missing files and broken data URIs are no buffers") {
  const Folder folder;
  fs::create_directory(folder.path() / "folder");
  CHECK(contains(with_buffer(folder, "folder"), "buffers[0].uri: is not a regular file"));
  CHECK(contains(with_buffer(folder, "none.bin"), "buffers[0].uri: file not found"));
  CHECK(contains(with_buffer(folder, "bad%2"), "buffers[0].uri: has a broken percent escape"));
  CHECK(contains(with_buffer(folder, "data:nothing"), "buffers[0].uri: is a data URI"));
  CHECK(contains(with_buffer(folder, std::string(5000, 'a')), "longer than 4096"));
}

TEST_CASE("A file that is missing or a folder is refused") {
  const Folder folder;
  CHECK(contains(outcome(folder.path() / "none.gltf"), "no such file"));
  CHECK(contains(outcome(folder.path()), "this is a folder with no glTF file"));
}

TEST_CASE("The budget of bytes holds for a file and its buffers together") {
  const Folder folder;
  LoadOptions options;
  options.max_bytes = 10;
  CHECK_THROWS_AS(load_gltf(folder.write("scene.gltf", triangle().json()), options), Error);
}

TEST_CASE("A Radiance image becomes an environment with its bottom row first") {
  const Folder folder;
  // Two texels, one above the other: red 1 on top, green 2 below (RGBE, not run-length coded).
  const std::string texels("\x80\x00\x00\x81\x00\x80\x00\x82", 8);
  const auto path = folder.write("sky.bin", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 1\n" + texels);
  const Environment environment = load_environment(path);
  REQUIRE(environment.image);
  CHECK(environment.image->shape == ImageShape{Format::RGBA32F, 1, 2});
  CHECK(environment.image->at(0, 1, 0) == Approx(1.0).margin(0.01));
  CHECK(environment.image->at(0, 0, 1) == Approx(2.0).margin(0.02));
  CHECK(environment.image->at(0, 0, 3) == 1.0f);
}

TEST_CASE("An environment wider than 8192 pixels is averaged down") {
  const Folder folder;
  std::string texels;  // red 1 and 2 in turn: 1.5 in the mean of every two
  for (int x = 0; x < 16384; x += 2) texels += std::string("\x80\x00\x00\x81\x80\x00\x00\x82", 8);
  const Environment environment = load_environment(
      folder.write("wide.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 16384\n" + texels));
  REQUIRE(environment.image);
  CHECK(environment.image->shape == ImageShape{Format::RGBA32F, 8192, 1});
  for (const int x : {0, 1, 8191}) CHECK(environment.image->at(x, 0, 0) == Approx(1.5).margin(0.02));
}

TEST_CASE("Other images are no environments") {
  const Folder folder;
  CHECK_THROWS_AS(load_environment(folder.write("a.hdr", "not an image")), Error);
  CHECK_THROWS_AS(load_environment(folder.write("a.hdr", "#?RADIANCE\n\n-Y 99999 +X 99999\n")), Error);
  CHECK_THROWS_AS(load_environment(folder.write("a.exr", "\x76\x2f\x31\x01 broken")), Error);
}

TEST_CASE("An environment with too long a side is refused with its width and height") {
  const Folder folder;
  std::vector<unsigned char> bytes;
  const ImageToEncode image{
      .width = 3, .height = 1, .channels = {"R", "G", "B"}, .row = [](int, float* values) {
        std::fill_n(values, 9, 1.0f);
      }};
  REQUIRE(image_io().encode(image, bytes) == "");
  const auto exr = folder.write("sky.exr", std::string(bytes.begin(), bytes.end()));
  const auto hdr = folder.write("sky.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 3\n");
  LoadOptions options;
  options.max_image_side = 2;
  const auto problem = [&](const fs::path& path) -> std::string {
    try {
      load_environment(path, options);
      return "loaded";
    } catch (const Error& error) {
      return error.what();
    }
  };
  CHECK(contains(problem(exr), "is 3x1, larger than 2 pixels a side"));
  CHECK(contains(problem(hdr), "is 3x1, larger than 2 pixels a side"));
}
