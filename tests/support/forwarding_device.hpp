// A device that hands every call to another: the base of devices that do one thing differently.
#pragma once
#include <memory>
#include <string>

#include "raster/software_device.hpp"

namespace caustics::test {

class ForwardingDevice : public Device {
 public:
  explicit ForwardingDevice(std::unique_ptr<Device> device = make_software_device())
      : device_(std::move(device)) {}
  std::string description() const override { return "forwarding"; }
  int max_texture_size() const override { return device_->max_texture_size(); }
  TextureId create_texture(Format format, int width, int height) override {
    return device_->create_texture(format, width, height);
  }
  TextureId upload(const Image& image) override { return device_->upload(image); }
  void destroy(TextureId texture) override { device_->destroy(texture); }
  MeshId create_mesh(const MeshData& mesh) override { return device_->create_mesh(mesh); }
  void update(MeshId mesh, const MeshData& data) override { device_->update(mesh, data); }
  void destroy(MeshId mesh) override { device_->destroy(mesh); }
  PassResult run(const PassRun& run) override { return device_->run(run); }
  void finish() override { device_->finish(); }
  Image read_back(TextureId texture) override { return device_->read_back(texture); }
  DeviceObjects made() const override { return device_->made(); }
  ImageShape shape(TextureId texture) const override { return device_->shape(texture); }
  const MeshData::Attribute* find_attribute(MeshId mesh, std::string_view name) const override {
    return device_->find_attribute(mesh, name);
  }

 private:
  std::unique_ptr<Device> device_;
};

}  // namespace caustics::test
