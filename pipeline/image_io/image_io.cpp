#include "pipeline/image_io/image_io.hpp"

#include <dlfcn.h>

#include "pipeline/gpu/error.hpp"
#include "pipeline/image_io/openimageio/module.hpp"

namespace caustics {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> module_paths() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  std::vector<fs::path> paths;
  if (!error) {
    paths.push_back(folder / kImageIoModule);
    paths.push_back(folder.parent_path() / CAUSTICS_MODULE_FOLDER / kImageIoModule);
  }
  paths.push_back(fs::path(CAUSTICS_INSTALL_PREFIX) / CAUSTICS_MODULE_FOLDER / kImageIoModule);
  paths.push_back(fs::path(CAUSTICS_BUILD_FOLDER) / kImageIoModule);
  return paths;
}

bool is_loaded = false;

const ImageIo& load() {
  std::string why = "it is not installed";
  for (const fs::path& path : module_paths()) {
    std::error_code error;
    if (!fs::exists(path, error)) continue;
    // Never closed: OpenImageIO's threads and tables live until the process ends.
    void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* functions = module ? dlsym(module, kImageIoFunctions) : nullptr;
    if (functions) {
      is_loaded = true;
      return reinterpret_cast<const ImageIo& (*)()>(functions)();
    }
    if (const char* reason = dlerror()) why = reason;
  }
  throw Error(ExitCode::BackendUnavailable,
              std::string("images need ") + kImageIoModule + " and OpenImageIO: " + why);
}

}  // namespace

bool is_image_io_loaded() { return is_loaded; }

const ImageIo& image_io() {
  static const ImageIo& loaded = load();
  return loaded;
}

}  // namespace caustics
