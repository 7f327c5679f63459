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

const std::uint8_t* data_at(const Model& model, const ElementPlace& place) {
  const BufferView& view = model.views[static_cast<std::size_t>(place.view)];
  return model.buffers[view.buffer].data() + view.offset + place.offset;
}

std::uint32_t load_unsigned(const std::uint8_t* bytes, int type) {
  switch (type) {
    case kUnsignedByte:
      return *bytes;
    case kUnsignedShort:
      return load<std::uint16_t>(bytes);
    default:
      return load<std::uint32_t>(bytes);
  }
}

double load_number(const std::uint8_t* bytes, int type, bool normalized) {
  switch (type) {
    case kByte: {
      const double x = static_cast<std::int8_t>(*bytes);
      return normalized ? std::max(x / 127.0, -1.0) : x;
    }
    case kUnsignedByte:
      return normalized ? *bytes / 255.0 : *bytes;
    case kShort: {
      const double x = load<std::int16_t>(bytes);
      return normalized ? std::max(x / 32767.0, -1.0) : x;
    }
    case kUnsignedShort: {
      const double x = load<std::uint16_t>(bytes);
      return normalized ? x / 65535.0 : x;
    }
    case kUnsignedInt:
      return load<std::uint32_t>(bytes);
    default:
      return load<float>(bytes);
  }
}

}  // namespace

Accessor::Accessor(const Context& context, const Model& model, int index)
    : layout_(&model.accessors[static_cast<std::size_t>(index)]),
      index_(index),
      component_size_(component_bytes(layout_->component_type)),
      stride_(static_cast<std::size_t>(layout_->components) * component_size_) {
  if (layout_->place.view >= 0) {
    const BufferView& view = model.views[static_cast<std::size_t>(layout_->place.view)];
    if (view.stride != 0) stride_ = view.stride;
    data_ = data_at(model, layout_->place);
  }
  if (layout_->sparse.count > 0) read_sparse(context, model);
}

void Accessor::read_sparse(const Context& context, const Model& model) {
  const SparseElements& sparse = layout_->sparse;
  const std::uint8_t* indices = data_at(model, sparse.indices);
  const std::size_t size = component_bytes(sparse.index_type);
  for (std::size_t i = 0; i < sparse.count; ++i) {
    const std::uint32_t target = load_unsigned(indices + i * size, sparse.index_type);
    if (target >= layout_->count || (i > 0 && target <= sparse_indices_.back())) {
      context.fail(path() + ".sparse.indices",
                   "index " + std::to_string(i) + " is " + std::to_string(target) +
                       ": indices must increase and lie below " + std::to_string(layout_->count),
                   "export the file again");
    }
    sparse_indices_.push_back(target);
  }
  sparse_values_ = data_at(model, sparse.values);
}

const std::uint8_t* Accessor::element(std::size_t i) const {
  if (!sparse_indices_.empty()) {
    const auto at = std::lower_bound(sparse_indices_.begin(), sparse_indices_.end(), i);
    if (at != sparse_indices_.end() && *at == i) {
      const auto k = static_cast<std::size_t>(at - sparse_indices_.begin());
      return sparse_values_ + k * static_cast<std::size_t>(components()) * component_size_;
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
