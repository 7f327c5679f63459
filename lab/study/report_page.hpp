// report.html: one page with nothing from elsewhere, readable in light and dark.
#pragma once
#include <filesystem>
#include <string>

#include "lab/study/study.hpp"

namespace caustics::study {

// Pictures of up to this many rows stand inside the page, those of more beside it in img/.
inline constexpr std::size_t kMostInlined = 200;

// `folder` has the pictures.
std::string report_page(const Study& study, const std::filesystem::path& folder);

}  // namespace caustics::study
