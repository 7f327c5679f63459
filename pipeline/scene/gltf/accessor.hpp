// Reads the elements of an accessor: strides, component types, normalised integers, sparse
// overrides. Source: glTF 2.0 sections 3.6.2 and 5.1. The model must have passed check_structure.
#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/scene/gltf/context.hpp"
#include "pipeline/scene/gltf/model.hpp"

namespace caustics::gltf {

class Accessor {
 public:
  // Fails when a sparse index is out of order or out of range.
  Accessor(const Context& context, const Model& model, int index);

  std::size_t size() const { return layout_->count; }
  int components() const { return layout_->components; }
  int component_type() const { return layout_->component_type; }
  bool is_float() const { return component_type() == kFloat; }
  bool normalized() const { return layout_->normalized; }
  std::string path() const { return "accessors[" + std::to_string(index_) + "]"; }

  // Component c of element i; normalised integers as -1..1 or 0..1.
  double value(std::size_t i, int c) const;
  // The element of a SCALAR accessor of unsigned integers.
  std::uint32_t unsigned_value(std::size_t i) const;

 private:
  void read_sparse(const Context& context, const Model& model);
  const std::uint8_t* element(std::size_t i) const;  // null: zeros

  const AccessorLayout* layout_;
  int index_;
  std::size_t component_size_;
  std::size_t stride_;
  const std::uint8_t* data_ = nullptr;         // null: all zeros
  std::vector<std::uint32_t> sparse_indices_;  // ascending
  const std::uint8_t* sparse_values_ = nullptr;
};

}  // namespace caustics::gltf
