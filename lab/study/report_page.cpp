#include "lab/study/report_page.hpp"

#include <algorithm>

#include "lab/study/difference_picture.hpp"
#include "lab/study/effect_rows.hpp"
#include "lab/study/html.hpp"
#include "lab/study/sentence.hpp"
#include "lab/study/study_plot.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::study {

namespace {

// Colours keep a contrast of 3 and more on their background (WCAG 1.4.11); every group has a shape too.
constexpr char kStyle[] = R"(<style>
:root { color-scheme: light dark; --paper: #fff; --ink: #1b1b1b; --soft: #d8d8d8; --front: #1b1b1b;
  --lit: #f0f4e4;
  --g0: #0063a6; --g1: #b4460f; --g2: #117a55; --g3: #a03c84; --g4: #8a6500; --g5: #2b7aa8; --g6: #b3261e;
  --g7: #55555a; }
@media (prefers-color-scheme: dark) { :root { --paper: #161618; --ink: #ececec; --soft: #3f3f44;
  --front: #ececec;
  --lit: #2c3220; --g0: #63b3ed; --g1: #ff9a5c; --g2: #4fd1a1; --g3: #e58fce; --g4: #e3b93c; --g5: #8ad4f5;
  --g6: #ff8a80;
  --g7: #b9b9c0; } }
body { background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; max-width: 70rem;
  margin: 2rem auto;
  padding: 0 1rem; }
h1, h2 { line-height: 1.2; } h2 { margin-top: 2.5rem; }
svg { width: 100%; height: auto; } svg text { fill: var(--ink); font: 13px system-ui, sans-serif; }
.gridline { stroke: var(--soft); } .leader { stroke: var(--ink); stroke-width: .6; }
.floor { stroke: var(--ink); stroke-dasharray: 2 4; } .front { stroke: var(--front); fill: none;
  stroke-width: 1.6; }
.dashed { stroke-dasharray: 7 5; } .mark, .spread { stroke: var(--c); fill: var(--c); stroke-width: 2; }
.spread { stroke-width: 1; } .hollow { fill: var(--paper); }
.g0 { --c: var(--g0); } .g1 { --c: var(--g1); } .g2 { --c: var(--g2); } .g3 { --c: var(--g3); }
  .g4 { --c: var(--g4); }
.g5 { --c: var(--g5); } .g6 { --c: var(--g6); } .g7 { --c: var(--g7); }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .2rem .6rem; border-bottom: 1px solid var(--soft); text-align: right; white-space: nowrap; }
th { vertical-align: bottom; } .left { text-align: left; } tr.best td, tr.best th { background: var(--lit); }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: 1rem; }
figure { margin: 0; } figure img { width: 100%; image-rendering: pixelated; background: #000; }
  figcaption { font-size: .85rem; }
code { overflow-wrap: anywhere; }
</style>
)";

constexpr char kPlotLegend[] =
    "relative L1: the share of the light that is missing or in the wrong place. relMSE 1, 4, 16: relative "
    "squared error "
    "in boxes of so many pixels; where it falls steeply from 1 to 16, light is a little shifted or noisy, "
    "where it stays, "
    "whole regions have another amount. Flux: all light over all light of the truth. FLIP: the mean of what "
    "an eye sees "
    "that flips between both pictures, 0 to 1. ms frame: all passes of a picture. ms caustic: those that the "
    "caustic maps "
    "depend on, the maps included.";

std::string cell(const std::string& text, const char* kind = "") {
  return "<td" + std::string(kind) + ">" + escaped(text) + "</td>";
}
std::string left(const std::string& text) { return cell(text, " class=\"left\""); }
std::string head(const std::string& text, const char* more = "") {
  return "<th scope=\"col\"" + std::string(more) + ">" + escaped(text) + "</th>";
}
std::string section(const std::string& title) { return "<h2>" + escaped(title) + "</h2>\n"; }
std::string paragraph(const std::string& text) { return "<p>" + escaped(text) + "</p>\n"; }

std::string remarks(const StudyRow& row) {
  std::string text = row.on_front ? "front" : "";
  if (row.reference_limited) text += (text.empty() ? "" : ", ") + std::string("reference-limited");
  if (!row.problem.empty()) text = "not measured: " + row.problem;
  return text;
}

std::string row_heads(const Study& study) {
  std::string html = "<tr>" + head("backend", " class=\"left\"");
  for (const Knob& knob : study.knobs) html += head(knob.key);
  for (const char* name : {"relative L1", "relMSE 1", "relMSE 4", "relMSE 16", "flux", "FLIP", "ms frame",
                           "ms caustic", "textures"})
    html += head(name);
  return html + head("", " class=\"left\"") + "</tr>\n";
}

std::string table_row(const StudyRow& row) {
  const Figures& f = row.figures;
  std::string html = std::string("<tr") + (row.on_front ? " class=\"best\"" : "") + ">" + left(row.backend);
  for (const std::string& value : row.point.values) html += cell(value);
  for (const auto& figure : {f.relative_l1, f.relative_mse_1, f.relative_mse_4, f.relative_mse_16})
    html += cell(figure_text(figure));
  html += cell(ratio_text(f.flux_ratio)) + cell(figure_text(f.flip_mean));
  const bool timed = row.problem.empty();
  for (const Times* times : {&row.frame, &row.caustic})
    html += cell(timed ? short_number(times->median) : "n/a");
  html += cell(timed ? bytes_text(static_cast<double>(row.texture_bytes)) : "n/a");
  return html + left(remarks(row)) + "</tr>\n";
}

std::string all_rows(const Study& study) {
  std::string html = "<div class=\"wide\"><table>\n<thead>" + row_heads(study) + "</thead>\n<tbody>\n";
  for (const StudyRow& row : study.rows) html += table_row(row);
  return html + "</tbody></table></div>\n" + paragraph(kPlotLegend);
}

std::string front_rows(const Study& study) {
  std::string html = "<div class=\"wide\"><table>\n<thead>" + row_heads(study) + "</thead>\n<tbody>\n";
  for (const std::string& backend : backends_of(study))
    for (const StudyRow* row : front_of(study, backend)) html += table_row(*row);
  return html + "</tbody></table></div>\n";
}

// Passes of all rows, in the order in which they first occur.
std::vector<std::string> pass_names(const Study& study) {
  std::vector<std::string> names;
  for (const bool caustic : {true, false})
    for (const StudyRow& row : study.rows)
      for (const PassTime& pass : row.passes)
        if (pass.caustic == caustic && std::find(names.begin(), names.end(), pass.name) == names.end())
          names.push_back(pass.name);
  return names;
}

const PassTime* pass_of(const StudyRow& row, const std::string& name) {
  const auto found = std::find_if(row.passes.begin(), row.passes.end(),
                                  [&](const PassTime& pass) { return pass.name == name; });
  return found == row.passes.end() ? nullptr : &*found;
}

std::string pass_table(const Study& study) {
  const std::vector<std::string> names = pass_names(study);
  std::string html =
      "<div class=\"wide\"><table>\n<thead><tr>" + head("row", " class=\"left\"") + head("backend");
  for (const std::string& name : names) html += head(name);
  html += "</tr></thead>\n<tbody>\n";
  for (const StudyRow& row : study.rows) {
    html += "<tr>" + left(point_text(study.knobs, row.point)) + cell(row.backend);
    for (const std::string& name : names) {
      const PassTime* pass = pass_of(row, name);
      html += cell(pass ? short_number(pass->median) + (pass->caustic ? " *" : "") : "");
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n" +
         paragraph(
             "Milliseconds a frame, the median, of all runs of a pass together (for each light, sample and "
             "branch). "
             "* counts as caustic.");
}

std::string picture(const std::filesystem::path& folder, const std::string& file, bool inlined,
                    const std::string& description, const std::string& caption) {
  const std::string inside = inlined ? png_address(folder / file) : "";
  return "<figure><img loading=\"lazy\" alt=\"" + escaped(description) + "\" src=\"" +
         (inside.empty() ? escaped(file) : inside) + "\"/><figcaption>" + escaped(caption) +
         "</figcaption></figure>\n";
}

std::string pictures(const Study& study, const std::filesystem::path& folder) {
  const bool inlined = study.rows.size() <= kMostInlined;
  std::string html =
      paragraph("Orange: more light than the truth; blue: less; black: the same. Full colour is " +
                short_number(study.white) +
                " lux and more, which only a hundredth of the truth's lit pixels exceeds; two thirds of it a "
                "tenth of that, one third "
                "a hundredth, black a thousandth and less. Of each pixel the channel that differs most; "
                "larger pictures are averaged to " +
                std::to_string(kPictureSide) + " pixels a side.");
  html +=
      "<div class=\"pictures\">\n" +
      picture(folder, "img/truth.png", inlined, "the truth's caustic, tone-mapped", "the truth, tone-mapped");
  for (const StudyRow& row : study.rows) {
    if (row.picture.empty()) continue;
    const std::string name = point_text(study.knobs, row.point) + " (" + row.backend + ")";
    html += picture(folder, row.picture, inlined, "difference to the truth of " + name,
                    name + ": relative L1 " + figure_text(row.figures.relative_l1) + ", flux " +
                        ratio_text(row.figures.flux_ratio));
  }
  return html + "</div>\n";
}

// Nothing of a study of settings.
std::string effect_table(const Study& study) {
  const std::vector<EffectRow> rows = effect_rows(study);
  if (rows.empty()) return {};
  std::string html = section("What each effect brings") + "<div class=\"wide\"><table>\n<thead><tr>" +
                     head("effect", " class=\"left\"") + head("backend");
  for (const char* name : {"error with", "error without", "ms with", "ms without"}) html += head(name);
  html += "</tr></thead>\n<tbody>\n";
  for (const EffectRow& row : rows)
    html += "<tr>" + left(row.effect) + cell(row.backend) + cell(figure_text(row.with->figures.relative_l1)) +
            cell(figure_text(row.without->figures.relative_l1)) + cell(short_number(row.with->frame.median)) +
            cell(short_number(row.without->frame.median)) + "</tr>\n";
  return html + "</tbody></table></div>\n" +
         paragraph("Errors are relative L1, times those of all passes of a picture.");
}

std::string base_text(const Study& study) {
  std::string text;
  for (const Knob& knob : study.knobs) text += (text.empty() ? "" : ", ") + knob.key + " " + knob.base;
  return text;
}

std::string introduction(const Study& study) {
  std::string html = "<h1>Error against time: " + escaped(study.scene) + "</h1>\n<p><strong>" +
                     escaped(truth_text(study)) + "</strong></p>\n<p>" + std::to_string(study.width) + " x " +
                     std::to_string(study.height) + " pixels. Base: " + escaped(base_text(study)) +
                     "; rows are named by what differs from it. <code>" + escaped(study.command) +
                     "</code></p>\n";
  if (!study.complete())
    html += paragraph("Not complete: " + std::to_string(study.rows.size()) + " of " +
                      std::to_string(study.planned) + " rows are here; --resume goes on.");
  std::vector<std::string> devices;
  for (const StudyRow& row : study.rows)
    if (std::find(devices.begin(), devices.end(), row.device) == devices.end()) devices.push_back(row.device);
  for (const std::string& device : devices) html += paragraph("Times of: " + device);
  return html;
}

std::string sentence_list(const Study& study) {
  std::string html = "<ul>\n";
  for (const std::string& sentence : sentences_of(study)) html += "<li>" + escaped(sentence) + "</li>\n";
  html += "</ul>\n";
  for (const Drift& drift : study.drifts) html += paragraph(drift_text(study, drift));
  return html +
         paragraph(
             "Error is relative L1, time that of the caustic passes; the other keys stand at their base.");
}

}  // namespace

std::string report_page(const Study& study, const std::filesystem::path& folder) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>Study of " +
      escaped(study.scene) + "</title>\n" + kStyle + "</head>\n<body>\n<main>\n";
  html += introduction(study);
  html += effect_table(study);
  html += section("Error and time") + draw(plot_of(study));
  html += section("What nothing beats in both error and time") + front_rows(study);
  html += section("What each step costs and brings") + sentence_list(study);
  html += section("All rows") + all_rows(study);
  html += section("Where the time goes") + pass_table(study);
  html += section("Where the light is wrong") + pictures(study, folder);
  return html + "<p>" + escaped(study.program) + "</p>\n</main>\n</body>\n</html>\n";
}

}  // namespace caustics::study
