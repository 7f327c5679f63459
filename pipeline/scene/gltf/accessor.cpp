#include "pipeline/scene/gltf/accessor.hpp"

#include <algorithm>
#include <cstring>

namespace caustics::gltf {

namespace {

template <typename T>
T load(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

const std::uint8_t* view_data(const tinygltf::Model& model, int view, std::size_t offset) {
  const tinygltf::BufferView& v = model.bufferViews[static_cast<std::size_t>(view)];
  return model.buffers[static_cast<std::size_t>(v.buffer)].data.data() + v.byteOffset + offset;
}

std::uint32_t load_unsigned(const std::uint8_t* bytes, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *bytes;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(bytes);
    default:
      return load<std::uint32_t>(bytes);
  }
}

double load_number(const std::uint8_t* bytes, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const double x = static_cast<std::int8_t>(*bytes);
      return normalized ? std::max(x / 127.0, -1.0) : x;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return normalized ? *bytes / 255.0 : *bytes;
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      const double x = load<std::int16_t>(bytes);
      return normalized ? std::max(x / 32767.0, -1.0) : x;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
      const double x = load<std::uint16_t>(bytes);
      return normalized ? x / 65535.0 : x;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load<std::uint32_t>(bytes);
    default:
      return load<float>(bytes);
  }
}

}  // namespace

Accessor::Accessor(const Context& context, const tinygltf::Model& model, int index)
    : accessor_(&model.accessors[static_cast<std::size_t>(index)]), index_(index) {
  components_ = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor_->type));
  component_size_ = static_cast<std::size_t>(
      tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor_->componentType)));
  stride_ = static_cast<std::size_t>(components_) * component_size_;
  if (accessor_->bufferView >= 0) {
    const auto& view = model.bufferViews[static_cast<std::size_t>(accessor_->bufferView)];
    if (view.byteStride != 0) stride_ = view.byteStride;
    data_ = view_data(model, accessor_->bufferView, accessor_->byteOffset);
  }
  if (accessor_->sparse.isSparse) read_sparse(context, model);
}

void Accessor::read_sparse(const Context& context, const tinygltf::Model& model) {
  const auto& sparse = accessor_->sparse;
  const auto offset = static_cast<std::size_t>(sparse.indices.byteOffset);
  const std::uint8_t* indices = view_data(model, sparse.indices.bufferView, offset);
  const int type = sparse.indices.componentType;
  const auto size =
      static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
  for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
    const std::uint32_t target = load_unsigned(indices + i * size, type);
    if (target >= accessor_->count || (i > 0 && target <= sparse_indices_.back())) {
      context.fail(path() + ".sparse.indices",
                   "index " + std::to_string(i) + " is " + std::to_string(target) +
                       ": indices must increase and lie below " + std::to_string(accessor_->count),
                   "export the file again");
    }
    sparse_indices_.push_back(target);
  }
  sparse_values_ =
      view_data(model, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset));
}

const std::uint8_t* Accessor::element(std::size_t i) const {
  if (!sparse_indices_.empty()) {
    const auto at = std::lower_bound(sparse_indices_.begin(), sparse_indices_.end(), i);
    if (at != sparse_indices_.end() && *at == i) {
      const auto k = static_cast<std::size_t>(at - sparse_indices_.begin());
      return sparse_values_ + k * static_cast<std::size_t>(components_) * component_size_;
    }
  }
  return data_ ? data_ + i * stride_ : nullptr;
}

double Accessor::value(std::size_t i, int c) const {
  const std::uint8_t* bytes = element(i);
  if (!bytes) return 0.0;
  return load_number(bytes + static_cast<std::size_t>(c) * component_size_, component_type(), normalized());
}

std::uint32_t Accessor::unsigned_value(std::size_t i) const {
  const std::uint8_t* bytes = element(i);
  return bytes ? load_unsigned(bytes, component_type()) : 0;
}

}  // namespace caustics::gltf
