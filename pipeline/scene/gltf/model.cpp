#include "pipeline/scene/gltf/model.hpp"

#include <charconv>
#include <new>

namespace caustics::gltf {

namespace {

constexpr const char* kKept[] = {"asset", "bufferViews", "accessors", "meshes", "nodes", "scenes", "scene"};
// In place of a buffer's URI: a name that only the callbacks below understand.
const std::string kBufferName = "caustics-buffer-";

// Members that nobody reads through the model.
constexpr const char* kDropped[] = {"extensions", "extras", "targets", "weights", "min", "max"};

void drop_unused(Json& value) {
  if (value.is_object()) {
    for (const char* key : kDropped) value.erase(key);
  }
  if (value.is_structured()) {
    for (Json& inner : value) drop_unused(inner);
  }
}

std::string slim_text(const Document& document, const std::vector<Bytes>& buffers) {
  Json slim = Json::object();
  for (const char* key : kKept) {
    if (document.json.contains(key)) slim[key] = document.json[key];
  }
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    slim["buffers"].push_back({{"byteLength", buffers[i].size()}, {"uri", kBufferName + std::to_string(i)}});
  }
  if (slim.contains("nodes")) {
    for (Json& node : slim["nodes"]) {
      node.erase("camera");  // cameras and skins are not handed on
      node.erase("skin");
    }
  }
  drop_unused(slim);
  return slim.dump();
}

// The buffer that a name of slim_text stands for, or null.
Bytes* buffer_named(const std::string& path, void* user_data) {
  auto& buffers = *static_cast<std::vector<Bytes>*>(user_data);
  const std::size_t at = path.rfind(kBufferName);
  if (at == std::string::npos) return nullptr;
  std::size_t index = 0;
  const char* digits = path.data() + at + kBufferName.size();
  if (std::from_chars(digits, path.data() + path.size(), index).ec != std::errc{}) return nullptr;
  return index < buffers.size() ? &buffers[index] : nullptr;
}

// tinygltf asks for the size since 2.9; older versions have no such member.
template <typename Callbacks>
void set_file_size(Callbacks& callbacks) {
  if constexpr (requires { callbacks.GetFileSizeInBytes; }) {
    callbacks.GetFileSizeInBytes = [](std::size_t* size, std::string*, const std::string& path,
                                      void* user_data) {
      const Bytes* buffer = buffer_named(path, user_data);
      if (buffer) *size = buffer->size();
      return buffer != nullptr;
    };
  }
}

tinygltf::FsCallbacks callbacks_for(std::vector<Bytes>& buffers) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = [](const std::string& path, void* user_data) {
    return buffer_named(path, user_data) != nullptr;
  };
  callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
  callbacks.ReadWholeFile = [](Bytes* out, std::string*, const std::string& path, void* user_data) {
    Bytes* buffer = buffer_named(path, user_data);
    if (buffer) *out = std::move(*buffer);
    return buffer != nullptr;
  };
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const Bytes&, void*) { return false; };
  set_file_size(callbacks);
  callbacks.user_data = &buffers;
  return callbacks;
}

}  // namespace

tinygltf::Model build_model(Context& context, const Document& document, std::vector<Bytes> buffers) {
  const std::string text = slim_text(document, buffers);
  tinygltf::Model model;
  tinygltf::TinyGLTF reader;
  std::string error, warning;
  reader.SetFsCallbacks(callbacks_for(buffers));
  if (!reader.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                  static_cast<unsigned int>(text.size()), "")) {
    // tinygltf catches what is thrown while it parses, and keeps the name.
    if (error.rfind("std::bad_alloc", 0) == 0) throw std::bad_alloc();
    context.fail("", "tinygltf: " + error, "export the file again");
  }
  return model;
}

}  // namespace caustics::gltf
