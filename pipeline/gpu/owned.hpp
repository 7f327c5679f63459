// What a device has made and somebody owns: released at the end of its owner's life, also where the owner's
// construction fails halfway.
#pragma once
#include <utility>

#include "pipeline/gpu/pass_run.hpp"

namespace caustics {

class Device;

// Id is TextureId or MeshId. The device must outlive it.
template <class Id>
class Owned {
 public:
  Owned() = default;
  Owned(Device& device, Id id) : device_(&device), id_(id) {}
  Owned(Owned&& other) noexcept : device_(other.device_), id_(std::exchange(other.id_, Id::None)) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(id_, other.id_);
    return *this;
  }
  ~Owned();

  Id id() const { return id_; }

 private:
  Device* device_ = nullptr;
  Id id_ = Id::None;
};

using OwnedTexture = Owned<TextureId>;
using OwnedMesh = Owned<MeshId>;

}  // namespace caustics
