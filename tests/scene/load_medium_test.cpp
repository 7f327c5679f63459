// A medium in the scene's extras.
#include "tests/scene/gltf_builder.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A triangle in a scene with these extras.
std::string in(const std::string& extras) {
  std::string text = triangle().json();
  const std::string before = R"("scenes":[{)";
  return text.replace(text.find(before), before.size(), before + R"("extras":)" + extras + ",");
}

std::string medium(const std::string& members) { return in(R"({"medium":{)" + members + "}}"); }

}  // namespace

TEST_CASE("A scene's extras can fill it with a medium") {
  const Medium haze =
      load_text(medium(R"("scattering":[0.1,0.2,0.3],"absorption":0.5,"anisotropy":-0.4)")).medium;
  CHECK(haze.scattering == glm::vec3(0.1f, 0.2f, 0.3f));
  CHECK(haze.absorption == glm::vec3(0.5f));
  CHECK(haze.anisotropy == -0.4f);
  CHECK(haze.present());
}

TEST_CASE("Without coefficients above 0 the air is clear, and other extras say nothing") {
  CHECK_FALSE(load(triangle()).medium.present());
  CHECK_FALSE(load_text(medium("")).medium.present());
  CHECK_FALSE(load_text(medium(R"("scattering":0,"anisotropy":0.5)")).medium.present());
  CHECK_FALSE(load_text(in(R"("haze")")).medium.present());
  CHECK_FALSE(load_text(in(R"([1,2])")).medium.present());
}

TEST_CASE("A medium that is none is refused with its place") {
  CHECK(contains(refusal(in(R"({"medium":3})")), "scenes[0].extras.medium"));
  CHECK(contains(refusal(medium(R"("scattering":-1)")), "medium.scattering"));
  CHECK(contains(refusal(medium(R"("scattering":[1,2])")), "medium.scattering"));
  CHECK(contains(refusal(medium(R"("scattering":"thick")")), "medium.scattering"));
  CHECK(contains(refusal(medium(R"("absorption":[0,0,2000])")), "medium.absorption"));
  CHECK(contains(refusal(medium(R"("absorption":1e400)")), "scene.gltf"));
  CHECK(contains(refusal(medium(R"("scattering":1,"anisotropy":1)")), "medium.anisotropy"));
}
