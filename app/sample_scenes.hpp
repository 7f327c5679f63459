// The scenes that come with the program.
#pragma once
#include <string>
#include <vector>

namespace caustics::app {

// All .glb and .gltf files of the folder `scenes` beside or above the program (a build of the
// sources), or of share/caustics/scenes (an installed program), in the order of their names. Throws
// Error (BadInput) when there are none.
std::vector<std::string> sample_scenes();

}  // namespace caustics::app
