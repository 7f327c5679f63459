#include "app/output/image_planes.hpp"

#include "app/shell/interrupt.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_image(const fs::path& path, const std::string& why) {
  throw Error(ExitCode::BadInput, path.string() + ": " + why);
}

}  // namespace

ImagePlanes read_planes(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) refuse_image(path, "no such file");
  if (!fs::is_regular_file(path, error)) refuse_image(path, "is not a plain file");
  ImagePlanes planes;
  const std::string problem = image_io().read_planes(path, stop_if_interrupted, planes);
  if (!problem.empty()) refuse_image(path, problem);
  return planes;
}

}  // namespace caustics::app
