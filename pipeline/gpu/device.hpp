// The Device: what executes pass definitions. The software rasterizer and the OpenGL backend implement
// it; nothing above this line knows which one runs.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "pipeline/gpu/image_view.hpp"
#include "pipeline/gpu/pass_run.hpp"

namespace caustics {

// What a device has made since it was made itself, and how often texels were read from it. A frame loop
// that is steady adds nothing but what it asks to read.
struct DeviceObjects {
  std::uint64_t programs = 0, buffers = 0, textures = 0, vertex_layouts = 0, framebuffers = 0;
  std::uint64_t read_backs = 0;
  bool operator==(const DeviceObjects&) const = default;
};

class Device {
 public:
  virtual ~Device() = default;
  // A name for people: "software, 16 lanes (AVX-512), 2 threads".
  virtual std::string description() const = 0;
  // Widest and highest texture.
  virtual int max_texture_size() const = 0;

  // A texture of undefined contents. Width and height are 1..max_texture_size(), else Error (WrongUsage).
  virtual TextureId create_texture(Format format, int width, int height) = 0;
  // A texture holding the image.
  virtual TextureId upload(const Image& image) = 0;
  // Likewise, to be read only, of an image that stays as it is until the texture is destroyed: a device whose
  // textures lie in this memory makes no copy of it.
  virtual TextureId share(const Image& image) { return upload(image); }
  virtual void destroy(TextureId texture) = 0;
  virtual MeshId create_mesh(const MeshData& mesh) = 0;
  // Other contents for a mesh; layout and numbers of vertices and indices must stay as they are, else
  // Error (InternalError). Makes no new object.
  virtual void update(MeshId mesh, const MeshData& data) = 0;
  virtual void destroy(MeshId mesh) = 0;

  // Validates (pipeline/gpu/validate.hpp) and executes. A target may not be read by the same run.
  virtual PassResult run(const PassRun& run) = 0;
  // Returns once everything that was asked for is done.
  virtual void finish() = 0;
  virtual Image read_back(TextureId texture) = 0;
  // Likewise, to look at until the texture is drawn into or destroyed: where its texels lie, if they are in
  // this memory.
  virtual ImageView look_at(TextureId texture) { return read_back(texture); }
  // What a texture is, for validation and tools.
  virtual ImageShape shape(TextureId texture) const = 0;
  virtual const MeshData::Attribute* find_attribute(MeshId mesh, std::string_view name) const = 0;
  virtual DeviceObjects made() const = 0;
};

}  // namespace caustics
