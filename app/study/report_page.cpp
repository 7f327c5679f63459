#include "app/study/report_page.hpp"
namespace caustics::app {
std::string report_page(const Study&, const std::filesystem::path&) { return ""; }
}  // namespace caustics::app
