// Many pictures small on one, with a name under each.
#pragma once
#include <string>
#include <vector>

#include "pipeline/gpu/image.hpp"

namespace caustics::app {

class ContactSheet {
 public:
  // Pictures that a sheet has room for; those beyond are left out.
  static constexpr std::size_t kMost = 300;

  // The first three channels are display values. Both lines are cut to the picture's width.
  void add(const Image& picture, const std::string& line, const std::string& below);
  bool empty() const { return cells_.empty(); }
  Image picture() const;

 private:
  struct Cell {
    Image small;
    std::string line, below;
  };
  std::vector<Cell> cells_;
};

}  // namespace caustics::app
