// caustics paper: every effect of Shah, Konttinen and Pattanaik (2007) made again, with its check.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "app/json.hpp"
#include "app/output/report_folder.hpp"
#include "app/output/stats.hpp"
#include "app/paper_shots.hpp"
#include "app/shell/atomic_file.hpp"
#include "app/shell/interrupt.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/progress.hpp"
#include "app/shell/terminal.hpp"
#include "app/shell/version.hpp"
#include "lab/paper/row.hpp"
#include "pipeline/settings/nearest.hpp"

namespace caustics::app {

namespace fs = std::filesystem;
using paper::Row;
using paper::Shot;

namespace {

constexpr char kReport[] = "paper.json";

struct PaperRequest {
  std::string folder = "paper";
  std::vector<std::string> rows;  // ids, or one of the numbers in them; empty: all
};

struct Done {
  Row row;
  paper::Finding finding;
};

// Does a row's id, "5, 31, 32", hold this number?
bool is_called(const std::string& id, const std::string& wanted) {
  return id == wanted || (", " + id + ", ").find(", " + wanted + ", ") != std::string::npos;
}

bool parse(const Arguments& arguments, PaperRequest& request) {
  Parser parser("paper",
                "Makes the effects of the paper again: pictures, statistics and a report, paper.md and\n"
                "paper.json. Each row is checked; exit code 1 when one does not hold.",
                "  caustics paper -o paper\n"
                "  caustics paper -o paper --row 9 --row 10\n");
  parser.group("Output");
  parser.option("-o,--output", "DIR", {"folder of the report; made where it is missing", "", "paper"},
                [&](const std::string& folder) { request.folder = folder; });
  parser.repeated("--row", "ID", {"this row only; may stand several times", "", "all"},
                  [&](const std::string& id) { request.rows.push_back(id); });
  return parser.parse(arguments);
}

std::vector<Row> wanted_rows(const PaperRequest& request) {
  std::vector<Row> rows = paper::paper_rows();
  std::vector<std::string> ids;
  ids.reserve(rows.size());
  for (const Row& row : rows) ids.push_back(row.id);
  for (const std::string& id : request.rows)
    if (std::none_of(ids.begin(), ids.end(), [&](const std::string& each) { return is_called(each, id); }))
      throw Error(ExitCode::WrongUsage, "there is no row " + in_quotes(id) + suggestion(id, ids));
  if (!request.rows.empty())
    std::erase_if(rows, [&](const Row& row) {
      return std::none_of(request.rows.begin(), request.rows.end(),
                          [&](const std::string& wanted) { return is_called(row.id, wanted); });
    });
  return rows;
}

std::string markdown(const std::vector<Done>& done, const RenderedShots& shots) {
  std::string text = "# The paper's effects, made again\n\n" + version_line() +
                     ", `caustics paper`. Times are of this machine.\n\n"
                     "| row | what | expected | found | |\n|---|---|---|---|---|\n";
  for (const Done& d : done)
    text += "| " + d.row.id + " | " + d.row.thing + " | " + d.row.expected + " | " + d.finding.figure +
            " | " + (d.finding.holds ? "holds" : "**does not hold**") + " |\n";
  for (const Done& d : done) {
    text += "\n## " + d.row.id + ": " + d.row.thing + "\n\n";
    for (const Shot& shot : d.row.shots) text += "    " + shots.command(shot.name) + "\n";
    if (!d.row.picture.empty()) text += "\n![" + d.row.thing + "](" + d.row.picture + ".png)\n";
  }
  return text;
}

std::string json(const std::vector<Done>& done, const RenderedShots& shots) {
  Json document = {{"format", 1}, {"program", version_line()}};
  document["rows"] = Json::array();
  for (const Done& d : done) {
    Json commands = Json::array();
    for (const Shot& shot : d.row.shots) commands.push_back(shots.command(shot.name));
    document["rows"].push_back({{"row", d.row.id},
                                {"thing", d.row.thing},
                                {"expected", d.row.expected},
                                {"found", d.finding.figure},
                                {"holds", d.finding.holds},
                                {"commands", commands}});
  }
  return json_text(document);
}

}  // namespace

ExitCode run_paper(const Arguments& arguments) {
  PaperRequest request;
  if (!parse(arguments, request)) return ExitCode::Done;
  const std::vector<Row> rows = wanted_rows(request);
  const fs::path folder = request.folder;
  refuse_standard_output(folder, "-o", "the report is a folder of files");
  make_report_folder(folder, kReport, [](const fs::path&) { return true; });
  require_writable(folder / "paper.md");
  RenderedShots shots(folder);
  std::vector<Done> done;
  write_atomically(folder / kReport, json(done, shots));  // the folder is the report's, finished or not
  Stopwatch watch;
  for (const Row& row : rows) {
    for (const Shot& shot : row.shots) {
      stop_if_interrupted();
      shots.take(shot);
    }
    done.push_back({row, row.check(shots)});
    const std::string left =
        duration_text(watch.milliseconds() / double(done.size()) * double(rows.size() - done.size()));
    std::printf("%-5s %-4s %s: %s (%s)\n", done.back().finding.holds ? "holds" : "FAILS", row.id.c_str(),
                row.thing.c_str(), done.back().finding.figure.c_str(),
                done.size() < rows.size() ? (left + " left").c_str() : "done");
    std::fflush(stdout);
  }
  write_atomically(folder / "paper.md", markdown(done, shots));
  write_atomically(folder / kReport, json(done, shots));
  const auto fails = std::count_if(done.begin(), done.end(), [](const Done& d) { return !d.finding.holds; });
  std::printf("%zu %s, %td %s not hold; %s\n", done.size(), done.size() == 1 ? "row" : "rows", fails,
              fails == 1 ? "does" : "do", one_line((folder / "paper.md").string()).c_str());
  return fails == 0 ? ExitCode::Done : ExitCode::AnswerIsNo;
}

}  // namespace caustics::app
