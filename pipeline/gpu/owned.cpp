#include "pipeline/gpu/owned.hpp"

#include "pipeline/gpu/device.hpp"

namespace caustics {

template <class Id>
Owned<Id>::~Owned() {
  if (id_ != Id::None) device_->destroy(id_);
}

template class Owned<TextureId>;
template class Owned<MeshId>;

}  // namespace caustics
