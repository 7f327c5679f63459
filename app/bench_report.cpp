#include "app/bench_report.hpp"

#include <algorithm>
#include <cmath>

#include "app/json.hpp"
#include "app/output/stats.hpp"
#include "app/shell/table.hpp"
#include "app/shell/terminal.hpp"
#include "lab/study/sentence.hpp"
#include "lab/study/times.hpp"

namespace caustics::app {

using study::short_number;
using study::Times;
using study::times_of;

namespace {

const char* name_of(Backend backend) { return backend == Backend::OpenGl ? "gl" : "software"; }

// Instances of a pass, or one of them, on one device.
struct PassSum {
  Costs costs;
  PassResult counts;
};

// Passes by name, in the order in which they first run, each with the places of its instances.
struct PassRow {
  std::string name;
  std::vector<std::size_t> instances;
  std::uint64_t bytes = 0, operations = 0;
  bool counts_samples = true;  // every instance does
};

std::vector<PassRow> rows_of(const BenchRun& run) {
  std::vector<PassRow> rows;
  for (std::size_t i = 0; i < run.passes.size(); ++i) {
    const BenchedPass& pass = run.passes[i];
    auto row = std::find_if(rows.begin(), rows.end(), [&](const PassRow& r) { return r.name == pass.name; });
    if (row == rows.end()) row = rows.insert(rows.end(), {.name = pass.name, .instances = {}});
    row->instances.push_back(i);
    row->bytes += pass.bytes;
    row->operations += pass.operations;
    row->counts_samples = row->counts_samples && pass.counts_samples;
  }
  return rows;
}

void add(std::vector<double>& sums, const std::vector<double>& values) {
  sums.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) sums[i] += values[i];
}

PassSum sum_of(const BenchedDevice& device, const std::vector<std::size_t>& instances) {
  PassSum sum;
  for (const std::size_t i : instances) {
    add(sum.costs.wall, device.passes[i].wall);
    add(sum.costs.processor, device.passes[i].processor);
    sum.counts.vertices += device.counts[i].vertices;
    sum.counts.primitives += device.counts[i].primitives;
    sum.counts.fragments += device.counts[i].fragments;
    sum.counts.samples_passed += device.counts[i].samples_passed;
  }
  return sum;
}

double share(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

// Of the wall time, the share that moving so many bytes would take at the memory's bandwidth, or so many
// operations at the arithmetic's peak: the larger.
double share_of_bound(const BenchRun& run, std::uint64_t bytes, std::uint64_t operations,
                      double milliseconds) {
  return 1e3 * std::max(share(static_cast<double>(bytes), run.bandwidth * milliseconds),
                        share(static_cast<double>(operations), run.peak * milliseconds));
}

// "12.3 M"
std::string operations_text(double operations) {
  return operations < 1e9 ? short_number(1e-6 * operations) + " M" : short_number(1e-9 * operations) + " G";
}

// "12.3 ±2%"
std::string spread_text(const Times& times) {
  return short_number(times.median) + " ±" +
         std::to_string(std::lround(100.0 * share(times.deviation, times.median))) + "%";
}

// The first device's times and, where there is another, its own and the ratio.
void add_times(std::vector<std::string>& cells, const std::vector<const Costs*>& costs) {
  for (const Costs* each : costs) {
    cells.push_back(spread_text(times_of(each->wall)));
    cells.push_back(short_number(times_of(each->processor).median));
  }
  if (costs.size() < 2) return;
  const double other = times_of(costs[1]->wall).median;
  cells.push_back(other > 0.0 ? significant(times_of(costs[0]->wall).median / other, 3) : "-");
}

std::vector<std::string> cells_of(const BenchRun& run, const PassRow& row) {
  std::vector<std::string> cells{row.name, std::to_string(row.instances.size())};
  std::vector<PassSum> sums;
  for (const BenchedDevice& device : run.devices) sums.push_back(sum_of(device, row.instances));
  std::vector<const Costs*> costs(sums.size());
  std::transform(sums.begin(), sums.end(), costs.begin(), [](const PassSum& sum) { return &sum.costs; });
  add_times(cells, costs);
  const PassResult& counts = sums.front().counts;
  const bool known = row.counts_samples && counts.fragments > 0;
  cells.push_back(grouped(counts.fragments));
  cells.push_back(known ? percent(share(static_cast<double>(counts.samples_passed),
                                        static_cast<double>(counts.fragments)))
                        : "-");
  cells.push_back(bytes_text(static_cast<double>(row.bytes)));
  cells.push_back(operations_text(static_cast<double>(row.operations)));
  cells.push_back(
      percent(share_of_bound(run, row.bytes, row.operations, times_of(costs.front()->wall).median)));
  return cells;
}

std::vector<std::string> total_cells(const BenchRun& run, const std::string& name,
                                     Costs BenchedDevice::*costs) {
  std::vector<std::string> cells{name, ""};
  std::vector<const Costs*> list;
  for (const BenchedDevice& device : run.devices) list.push_back(&(device.*costs));
  add_times(cells, list);
  return cells;
}

std::string table_text(const BenchRun& run) {
  Table table({false, true, true, true, true, true, true, true, true, true, true, true});
  std::vector<std::string> head{"pass", "instances"};
  for (const BenchedDevice& device : run.devices) {
    head.push_back(std::string(name_of(device.backend)) + " ms");
    head.emplace_back("cpu ms");
  }
  if (run.devices.size() > 1) head.emplace_back("ratio");
  for (const char* name : {"fragments", "useful", "bytes", "operations", "of bound"}) head.emplace_back(name);
  table.row(head);
  for (const PassRow& row : rows_of(run)) table.row(cells_of(run, row));
  table.row(total_cells(run, "all passes", &BenchedDevice::sums));
  table.row(total_cells(run, "frame", &BenchedDevice::frames));
  return table.text();
}

std::string digest_text(const BenchRun& run) {
  std::string text = grouped(run.attachments) + " attachments, " + run.digest;
  if (!run.fault.empty()) return text + "\n  DIFFERENT: " + run.fault;
  text += ", the same before and after";
  if (run.devices.size() < 2) return text;
  if (run.differing == 0) return text + " and on both backends";
  return text + "\n  " + grouped(run.differing) + " differ on gl, as drivers of the class '" + run.allowance +
         "' may; caustics parity judges how far";
}

Json times_json(const std::vector<double>& milliseconds) {
  const Times times = times_of(milliseconds);
  return {
      {"median", times.median}, {"least", times.least}, {"most", times.most}, {"deviation", times.deviation}};
}

Json costs_json(const Costs& costs) {
  return {{"milliseconds", times_json(costs.wall)}, {"processor_milliseconds", times_json(costs.processor)}};
}

Json pass_json(const BenchRun& run, std::size_t i) {
  const BenchedPass& pass = run.passes[i];
  Json json = {
      {"pass", pass.label}, {"name", pass.name}, {"bytes", pass.bytes}, {"operations", pass.operations}};
  for (const BenchedDevice& device : run.devices) {
    Json of_device = costs_json(device.passes[i]);
    const PassResult& counts = device.counts[i];
    of_device["vertices"] = counts.vertices;
    of_device["primitives"] = counts.primitives;
    of_device["fragments"] = counts.fragments;
    of_device["samples_passed"] = pass.counts_samples ? Json(counts.samples_passed) : Json();
    of_device["left_out"] = counts.left_out;
    of_device["share_of_bound"] =
        share_of_bound(run, pass.bytes, pass.operations, times_of(device.passes[i].wall).median);
    json[name_of(device.backend)] = of_device;
  }
  return json;
}

}  // namespace

std::string bench_text(const BenchRun& run) {
  const Settings& s = run.settings;
  std::string text = run.scene + ", " + std::to_string(s.width) + "x" + std::to_string(s.height) + ", grid " +
                     std::to_string(s.grid) + ", map " + std::to_string(s.map) + ", " +
                     std::to_string(run.threads) + (run.threads == 1 ? " thread, " : " threads, ") +
                     std::to_string(run.devices.front().frames.wall.size()) + " frames\n";
  Table devices({false, false});
  for (const BenchedDevice& device : run.devices)
    devices.row(
        {name_of(device.backend), device.description + ", prepared in " + duration_text(device.prepared)});
  text += devices.text() + "\n" + table_text(run) + "\n";
  text += "  memory: " + bytes_text(run.bandwidth) + "/s; peak " +
          bytes_text(static_cast<double>(run.peak_memory)) + "\n";
  text += "  arithmetic: " + operations_text(run.peak) + " operations/s\n";
  return text + "  digest: " + digest_text(run) + "\n";
}

Json bench_json(const BenchRun& run) {
  Json json = {{"threads", run.threads},
               {"settings", settings_json(run.settings)},
               {"frames", run.devices.front().frames.wall.size()},
               {"bandwidth_bytes_per_second", run.bandwidth},
               {"operations_per_second", run.peak},
               {"peak_memory_bytes", run.peak_memory},
               {"digest",
                {{"attachments", run.attachments},
                 {"sha256", run.digest},
                 {"differing", run.differing},
                 {"fault", run.fault.empty() ? Json() : Json(run.fault)}}},
               {"devices", Json::object()},
               {"passes", Json::array()}};
  for (const BenchedDevice& device : run.devices)
    json["devices"][name_of(device.backend)] = {{"description", device.description},
                                                {"prepare_milliseconds", device.prepared},
                                                {"all_passes", costs_json(device.sums)},
                                                {"frame", costs_json(device.frames)}};
  for (std::size_t i = 0; i < run.passes.size(); ++i) json["passes"].push_back(pass_json(run, i));
  return json;
}

}  // namespace caustics::app
