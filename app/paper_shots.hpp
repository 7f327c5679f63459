// The paper's shots, rendered by this program into a folder.
#pragma once
#include <filesystem>
#include <map>

#include "lab/paper/shots.hpp"

namespace caustics::app {

class RenderedShots : public paper::Shots {
 public:
  explicit RenderedShots(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // Renders unless that is done. Throws Error as `render` does.
  void take(const paper::Shot& shot);
  // "caustics render scenes/glass_sphere.glb --grid 64 -o sphere.png", as a person would type it.
  std::string command(const std::string& name) const { return commands_.at(name); }

  const nlohmann::ordered_json& stats(const std::string& name) const override { return stats_.at(name); }
  bool taken(const std::string& name) const override { return !stats_.at(name).is_null(); }
  paper::Texels attachment(const std::string& name, const std::string& attachment) const override;
  paper::FloorLayer layer(const std::string& name, const std::string& layer) const override;
  void draw_side_by_side(const std::vector<std::string>& tested, const std::string& truth,
                         const std::string& layer, const std::string& name) const override;

 private:
  void render(const paper::Shot& shot);
  void trace(const paper::Shot& shot);
  std::filesystem::path file(const std::string& name, const std::string& extension) const;

  std::filesystem::path folder_;
  std::map<std::string, nlohmann::ordered_json> stats_;
  std::map<std::string, std::string> commands_;
};

}  // namespace caustics::app
