// The page itself: its frame, styles and scripts, which are part of the program, around a recording.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/inspect/blobs.hpp"

namespace caustics::app {

// A whole HTML document that fetches nothing. Whatever names the recording holds, they stay text.
std::string inspect_page(const std::string& title, const nlohmann::ordered_json& recording,
                         const Blobs& blobs);

// Texts of app/inspect/page/, put into the program when it is built (app/inspect/room.cmake).
extern const char* const kPageFrame;
extern const char* const kPageStyle;
extern const char* const kPageScript;

}  // namespace caustics::app
