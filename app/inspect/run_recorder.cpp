#include "app/inspect/run_recorder.hpp"

#include <algorithm>
#include <cmath>

#include "app/inspect/channel_meanings.hpp"
#include "app/inspect/fragment_table.hpp"
#include "app/inspect/pixel_table.hpp"
#include "app/inspect/record_parts.hpp"
#include "app/json.hpp"
#include "app/output/attachment_kind.hpp"
#include "app/output/light_groups.hpp"
#include "app/output/stats.hpp"
#include "app/plan_report.hpp"
#include "app/probe/pixel_light.hpp"
#include "app/texture_label.hpp"
#include "passes/registry.hpp"
#include "pipeline/gpu/device.hpp"

namespace caustics::app {

namespace {

constexpr char kFull[] = "earlier branches of its light fill the page";

DrawSet draws_of(const PlannedPass& pass) {
  return pass_registry()[static_cast<std::size_t>(pass.pass)].draws;
}

std::vector<float> triple(const glm::dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// As bytes 0..255, of a picture for screens.
std::vector<std::uint8_t> display_bytes(const Image& image) {
  std::vector<std::uint8_t> bytes;
  for (const float value : image.values)
    bytes.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f)));
  return bytes;
}

// A flux whose unit is the light's, and nothing else that its meaning names.
bool is_flux_of_light(const ChannelMeaning& channel) {
  return channel.unit.empty() && channel.meaning.find("flux") != std::string::npos &&
         channel.meaning.find("in that of") == std::string::npos;
}

std::string flux_unit_word(const Scene& scene, int light) {
  if (light < 0) return {};
  const bool parallel = scene.lights[static_cast<std::size_t>(light)].type == LightType::Directional;
  return parallel ? "square metres" : "steradians";
}

}  // namespace

RunRecorder::RunRecorder(const std::string& name, RenderedFrame& frame, const RecordingLimits& limits,
                         Blobs& blobs)
    : frame_(frame), limits_(limits), blobs_(blobs), run_(std::make_unique<Json>()) {
  *run_ = {{"name", name},
           {"scene", frame.scene().file},
           {"device", frame.device().description()},
           {"settings", settings_json(frame.settings())},
           {"notes", frame.scene().notes},
           {"effects", Json::array()},
           {"passes", Json::array()},
           {"skipped", Json::array()},
           {"attachments", Json::array()},
           {"histories", Json::array()},
           {"lights", Json::array()},
           {"meshes", Json::array()},
           {"sweeps", Json::array()},
           {"left_out", Json::array()}};
  for (const NamedEffect& named : named_effects()) {
    const Effect& effect = frame.effects().*named.effect;
    (*run_)["effects"].push_back(
        {{"name", named.name}, {"active", effect.active}, {"reason", effect.reason}});
  }
  for (const SkippedPass& pass : frame.plan().skipped)
    (*run_)["skipped"].push_back({{"pass", pass.name}, {"reason", pass.reason}});
}

RunRecorder::~RunRecorder() = default;

void RunRecorder::leave_out(const std::string& sentence) { (*run_)["left_out"].push_back(sentence); }

void RunRecorder::draw(const AfterPass& after) {
  frame_.run([&](const PlannedPass& pass, const PassResult& result, std::size_t done, std::size_t total) {
    ledgers_.look(frame_, pass);
    look(pass, result);
    before_ = done < total ? targets_before(frame_, frame_.plan().passes[done]) : TargetsBefore{};
    return !after || after(pass, result, done, total);
  });
  (*run_)["lights"] = lights();
  (*run_)["meshes"] = meshes();
}

void RunRecorder::look(const PlannedPass& pass, const PassResult& result) {
  const std::size_t index = (*run_)["passes"].size(), before = blobs_.bytes();
  const std::vector<int> attachments = add_attachments(pass, index);
  const std::size_t between = blobs_.bytes();
  (*run_)["passes"].push_back(pass_record(pass, result, attachments));
  if (draws_of(pass) != DrawSet::FullScreen) add_history(pass, index, result, attachments);
  if (pass.branch >= 0) {
    branch_attachments_[pass.light] += between - before;
    branch_histories_[pass.light] += blobs_.bytes() - between;
  }
  if (shades_picture(pass) && is_first_sample(frame_.scene(), pass.light)) add_pixels(pass);
}

// Their numbers by the definition's writes, the depth's last; -1 where nobody needs one.
std::vector<int> RunRecorder::add_attachments(const PlannedPass& pass, std::size_t pass_index) {
  std::vector<int> numbers;
  Json& list = (*run_)["attachments"];
  const auto take = [&](int texture, const std::string& name, const std::string& meaning) {
    numbers.push_back(texture < 0 ? -1 : static_cast<int>(list.size()));
    if (texture < 0) return;
    const PlannedTexture& planned = frame_.plan().textures[static_cast<std::size_t>(texture)];
    list.push_back(attachment(pass, pass_index, planned, name, meaning, frame_.read(texture)));
  };
  for (std::size_t i = 0; i < pass.writes.size(); ++i)
    take(pass.writes[i], pass.definition->writes[i].name, pass.definition->writes[i].meaning);
  if (pass.depth >= 0) take(pass.depth, pass.definition->depth->name, pass.definition->depth->meaning);
  return numbers;
}

Json RunRecorder::pass_record(const PlannedPass& pass, const PassResult& result,
                              const std::vector<int>& attachments) const {
  const PassRun prepared = frame_.prepare(pass);
  Json reads = Json::array(), writes = Json::array(), draws = Json::array();
  for (const int read : pass.reads)
    if (read >= 0) reads.push_back(frame_.plan().textures[static_cast<std::size_t>(read)].name);
  for (const int attachment : attachments)
    if (attachment >= 0) writes.push_back(attachment);
  for (const Draw& draw : prepared.draws) {
    const Mesh* mesh = mesh_of(frame_, draw);
    Json drawn = {{"mesh", Json()}, {"material", Json()}};
    if (mesh) drawn["mesh"] = mesh->name;
    if (mesh) drawn["material"] = frame_.scene().materials[static_cast<std::size_t>(mesh->material)].name;
    draws.push_back(std::move(drawn));
  }
  Json record = counters_json(PassReport{pass.label, result});
  record["label"] = pass.label;
  record["name"] = pass.definition->name;
  record["purpose"] = pass.definition->purpose;
  record["reason"] = pass.reason;
  record["light"] = pass.light < 0 ? Json() : Json(pass.light);
  record["reads"] = reads;
  record["writes"] = writes;
  record["state"] = state_json(*pass.definition);
  record["uniforms"] = uniforms_json(*pass.definition, prepared);
  record["draws"] = draws;
  return record;
}

std::string RunRecorder::why_left_out(const PlannedPass& pass, std::size_t texels) const {
  if (pass.light >= 0 && !is_first_sample(frame_.scene(), pass.light))
    return "of a light with a size the page shows the first sample";
  if (texels > limits_.texels) return std::to_string(texels) + " texels are more than the page holds";
  return {};
}

bool RunRecorder::is_full(const PlannedPass& pass, const std::map<int, std::size_t>& bytes) const {
  const auto found = bytes.find(pass.light);
  if (pass.branch < 0 || found == bytes.end()) return false;
  const Scene& scene = frame_.scene();
  const std::size_t lights = std::max(scene.sources.size(), std::size_t{1});
  return found->second > limits_.branch_bytes / lights;
}

bool RunRecorder::finishes_map(const PlannedPass& pass, const PlannedTexture& texture) const {
  const FramePlan& plan = frame_.plan();
  const int map = plan.find(texture.name);
  if (!texture.name.starts_with(kCausticMap)) return false;
  const auto last = std::find_if(plan.passes.rbegin(), plan.passes.rend(), [&](const PlannedPass& other) {
    return std::find(other.writes.begin(), other.writes.end(), map) != other.writes.end();
  });
  return last != plan.passes.rend() && last->label == pass.label;
}

Json RunRecorder::attachment(const PlannedPass& pass, std::size_t pass_index, const PlannedTexture& texture,
                             const std::string& name, const std::string& meaning, const Image& image) {
  Json channels = Json::array(), codes, data, left_out;
  for (const ChannelMeaning& c : channel_meanings(meaning, image.channels()))
    channels.push_back({{"name", c.name},
                        {"meaning", c.meaning},
                        {"unit", is_flux_of_light(c) ? flux_unit_word(frame_.scene(), pass.light) : c.unit}});
  const int status = status_channel_of(meaning);
  if (status >= 0) codes = {{std::to_string(status), status_names()}};
  const AttachmentKind kind = kind_of(image.shape.format, meaning);
  const std::string hash = sha256(image), label = texture_label(texture, frame_.scene());
  const auto texels = static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height());
  std::unique_ptr<Json>& known = by_hash_[hash];
  std::string why = known ? "" : why_left_out(pass, texels);
  if (!known && why.empty() && is_full(pass, branch_attachments_) && !finishes_map(pass, texture))
    why = kFull;
  if (!why.empty()) {
    left_out = why + "; caustics render --dump writes it";
    leave_out(pass.label + " " + label + ": " + left_out.get<std::string>());
  } else {
    if (!known)
      known = std::make_unique<Json>(kind == AttachmentKind::Display && image.shape.format == Format::RGBA8
                                         ? blobs_.add(std::span<const std::uint8_t>(display_bytes(image)))
                                         : blobs_.add_floats(image.values, image.channels()));
    data = *known;
  }
  return {{"id", (*run_)["attachments"].size()},
          {"pass", pass_index},
          {"texture", texture.name},
          {"label", label},
          {"name", name},
          {"format", format_name(texture.format)},
          {"width", image.width()},
          {"height", image.height()},
          {"meaning", meaning},
          {"kind", status >= 0 ? "status" : std::string(name_of(kind))},
          {"channels", channels},
          {"codes", codes},
          {"sha256", hash},
          {"data", data},
          {"left_out", left_out}};
}

void RunRecorder::add_history(const PlannedPass& pass, std::size_t pass_index, const PassResult& result,
                              const std::vector<int>& attachments) {
  const DrawSet set = draws_of(pass);
  Json history;
  history["pass"] = pass_index;
  history["width"] = pass.width;
  history["height"] = pass.height;
  history["vertices_of"] = set == DrawSet::GridCells      ? Json("cell")
                           : set == DrawSet::GridVertices ? Json("vertex")
                                                          : Json();
  history["branch"] = pass.branch < 0 ? Json() : Json(pass.branch);
  history["cascade"] = pass.drawn_for->window == MapWindow::Cascade;
  for (const char* name : {"start", "draw", "primitive", "outcome", "depth"}) history[name] = Json();
  history["values"] = history["before"] = Json::object();
  history["left_out"] = Json();
  if (const std::string why = why_no_history(pass, result); !why.empty()) {
    history["left_out"] = why + "; caustics probe SCENE --history '" + pass.label + ":X,Y' tells one texel's";
    leave_out("history of " + pass.label + ": " + why + "; caustics probe SCENE --history tells a texel's");
  } else if (!result.left_out) {
    fill_history(pass, attachments, history);
  }
  (*run_)["histories"].push_back(std::move(history));
}

std::string RunRecorder::why_no_history(const PlannedPass& pass, const PassResult& result) const {
  if (!frame_.device().description().starts_with("software"))
    return "only the software device tells what happened to a texel";
  std::string why =
      why_left_out(pass, static_cast<std::size_t>(pass.width) * static_cast<std::size_t>(pass.height));
  if (why.empty() && result.fragments > limits_.fragments)
    why = std::to_string(result.fragments) + " fragments are more than the page holds";
  if (why.empty() && is_full(pass, branch_histories_)) why = kFull;
  return why;
}

void RunRecorder::fill_history(const PlannedPass& pass, const std::vector<int>& attachments, Json& history) {
  std::vector<bool> wanted;
  wanted.reserve(attachments.size());
  for (const int attachment : attachments) wanted.push_back(attachment >= 0);
  const FragmentTable table = fragment_table(frame_, pass, before_, wanted);
  history["start"] = blobs_.add(std::span<const std::uint32_t>(table.start));
  history["draw"] = blobs_.add(std::span<const std::uint16_t>(table.draw));
  history["primitive"] = blobs_.add(std::span<const std::uint32_t>(table.primitive));
  history["outcome"] = blobs_.add(std::span<const std::uint8_t>(table.outcome));
  if (pass.depth >= 0) history["depth"] = blobs_.add_floats(table.depth);
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    if (!wanted[i]) continue;
    const std::string id = std::to_string(attachments[i]);
    const ColorWrite& write = pass.definition->writes[i];
    const int channels = channel_count(write.format);
    history["values"][id] = blobs_.add_floats(table.values[i], channels);
    const bool kept = i < before_.colors.size() && !before_.colors[i].values.empty();
    history["before"][id] =
        kept ? blobs_.add_floats(before_.colors[i].values, channels)
             : Json(std::vector<float>(write.clear.begin(), write.clear.begin() + channels));
  }
}

void RunRecorder::add_pixels(const PlannedPass& pass) {
  const PixelTable table = pixel_table(frame_, pass);
  const auto irradiance = [&](const std::vector<float>& values) {
    return values.empty() ? Json() : blobs_.add_floats(values, 4);
  };
  pixels_[pass.light] =
      std::make_unique<Json>(Json{{"width", table.width},
                                  {"height", table.height},
                                  {"start", blobs_.add(std::span<const std::uint32_t>(table.start))},
                                  {"samples", blobs_.add(std::span<const std::uint8_t>(table.samples))},
                                  {"map", blobs_.add(std::span<const std::uint8_t>(table.map))},
                                  {"fetches", blobs_.add_floats(table.fetches, 4)},
                                  {"direct", irradiance(table.direct)},
                                  {"caustic", irradiance(table.caustic)}});
}

Json RunRecorder::lights() {
  Json list = Json::array();
  for (std::size_t i = 0; i < frame_.scene().lights.size(); ++i) list.push_back(light(static_cast<int>(i)));
  for (const LightLedger& entry : ledgers_.ledgers()) {
    // Of a light with a size all its samples' sum: told with the first.
    const std::vector<int> samples = samples_of(frame_.scene(), entry.light);
    if (samples.empty()) continue;
    Json& first = list[static_cast<std::size_t>(samples.front())];
    first["ledger"] = ledger_accounts(entry.ledger);
    first["estimated_error"] = error_json(entry.error);
  }
  return list;
}

// By wavelength, and by what glass mirrors.
Json RunRecorder::branches_of(int number) {
  std::map<int, Json> branches;
  Json entry, exit;
  for (const Json& a : (*run_)["attachments"]) {
    const auto pass = a["pass"].get<std::size_t>();
    if ((*run_)["passes"][pass]["light"] != Json(number)) continue;
    if (a["name"] == "caster_position" && entry.is_null()) entry = a["id"];
    if (a["name"] == "caster_exit_position" && exit.is_null()) exit = a["id"];
    if (a["name"] != kLanding) continue;
    const int branch = std::max(0, frame_.plan().passes[pass].branch);
    Json& json = branches[branch];
    if (json.is_null()) {
      json["name"] = frame_.effects().branches[static_cast<std::size_t>(branch)].name;
      json["landing"] = Json::array();
    }
    json["landing"].push_back(a["id"]);
  }
  Json list = Json::array();
  for (auto& [branch, json] : branches) {
    json["entry"] = entry;
    json["exit"] = exit;
    list.push_back(json);
  }
  return list;
}

// In the order of kCausticMaps.
Json RunRecorder::maps_of(int number) {
  Json maps = Json::array();
  for (const char* map : {"caustic_map", kCascadeMap, "caustic_map.far"}) {
    Json last, histories = Json::array();
    for (const Json& a : (*run_)["attachments"]) {
      if (a["texture"] != light_texture(map, number)) continue;
      last = a["id"];
      for (std::size_t h = 0; h < (*run_)["histories"].size(); ++h)
        if ((*run_)["histories"][h]["pass"] == a["pass"]) histories.push_back(h);
    }
    maps.push_back({{"attachment", last}, {"histories", histories}});
  }
  return maps;
}

Json RunRecorder::light(int number) {
  const Light& light = frame_.scene().lights[static_cast<std::size_t>(number)];
  const bool directional = light.type == LightType::Directional;
  const auto pixels = pixels_.find(number);
  Json json;
  json["index"] = number;
  json["name"] = light.name;
  json["type"] = name_of(light.type);
  json["intensity"] = light.intensity;
  json["unit"] = intensity_unit(light);
  json["color"] = triple(light.color);
  json["position"] = directional ? Json() : Json(triple(light.position));
  json["direction"] = light.type == LightType::Point ? Json() : Json(triple(light.direction));
  json["flux_unit"] = flux_unit(light);
  json["ledger"] = json["estimated_error"] = json["paths"] = Json();
  json["grid"] = frame_.grid_of(number);
  json["branches"] = branches_of(number);
  json["maps"] = maps_of(number);
  json["pixels"] = pixels == pixels_.end() ? Json() : *pixels->second;
  return json;
}

Json RunRecorder::meshes() {
  Json list = Json::array();
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < frame_.scene().meshes.size(); ++i) {
    const Mesh& mesh = frame_.scene().meshes[i];
    Json positions, indices;
    if (triangles + mesh.indices.size() / 3 <= limits_.triangles) {
      triangles += mesh.indices.size() / 3;
      std::vector<float> values;
      for (const Vertex& v : mesh.vertices)
        values.insert(values.end(), {v.position.x, v.position.y, v.position.z});
      positions = blobs_.add_floats(values);
      indices = blobs_.add(std::span<const std::uint32_t>(mesh.indices));
    } else {
      leave_out("mesh '" + mesh.name + "': sections do not show it, they hold " +
                std::to_string(limits_.triangles) + " triangles at most");
    }
    list.push_back({{"name", mesh.name},
                    {"material", frame_.scene().materials[static_cast<std::size_t>(mesh.material)].name},
                    {"role", std::string(name_of(frame_.effects().surfaces[i].role))},
                    {"positions", positions},
                    {"indices", indices}});
  }
  return list;
}

}  // namespace caustics::app
