// One run for the page: everything that its passes leave, taken while the frame is drawn.
#pragma once
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/flux.hpp"
#include "app/frame.hpp"
#include "app/inspect/blobs.hpp"
#include "app/probe/before_pass.hpp"

namespace caustics::app {

struct RecordingLimits {
  std::size_t texels = std::size_t{1} << 20;     // of an attachment; larger ones are left out
  std::size_t fragments = std::size_t{2} << 20;  // of a pass whose history is kept
  std::size_t triangles = 200'000;               // of all meshes that sections show
  // Of attachments of the branches of all lights, in the page, and as many of their histories: later branches
  // of a light are left out, but not what its caustic maps come to.
  std::size_t branch_bytes = std::size_t{5} << 20;
};

class RunRecorder {
 public:
  // `name`: how the page calls the run. All must outlive it.
  RunRecorder(const std::string& name, RenderedFrame& frame, const RecordingLimits& limits, Blobs& blobs);
  RunRecorder(const RunRecorder&) = delete;
  RunRecorder& operator=(const RunRecorder&) = delete;
  ~RunRecorder();

  // Draws the frame and takes what it leaves; `after` as RenderedFrame::run has it.
  void draw(const AfterPass& after);
  // The run as the page reads it.
  nlohmann::ordered_json& json() { return *run_; }

 private:
  using Json = nlohmann::ordered_json;

  // "": it is shown.
  std::string why_left_out(const PlannedPass& pass, std::size_t texels) const;
  bool is_full(const PlannedPass& pass, const std::map<int, std::size_t>& bytes) const;
  bool finishes_map(const PlannedPass& pass, const PlannedTexture& texture) const;
  void look(const PlannedPass& pass, const PassResult& result);
  std::vector<int> add_attachments(const PlannedPass& pass, std::size_t pass_index);
  Json attachment(const PlannedPass& pass, std::size_t pass_index, const PlannedTexture& texture,
                  const std::string& name, const std::string& meaning, const Image& image);
  Json pass_record(const PlannedPass& pass, const PassResult& result,
                   const std::vector<int>& attachments) const;
  void add_history(const PlannedPass& pass, std::size_t pass_index, const PassResult& result,
                   const std::vector<int>& attachments);
  std::string why_no_history(const PlannedPass& pass, const PassResult& result) const;
  void fill_history(const PlannedPass& pass, const std::vector<int>& attachments, Json& history);
  void add_pixels(const PlannedPass& pass);
  Json lights();
  Json light(int number);
  Json branches_of(int number);
  Json maps_of(int number);
  Json meshes();
  void leave_out(const std::string& sentence);

  RenderedFrame& frame_;
  RecordingLimits limits_;
  Blobs& blobs_;
  LedgerReader ledgers_;
  TargetsBefore before_;                                              // of the pass that runs next
  std::map<std::string, std::unique_ptr<Json>> by_hash_;              // arrays of equal images
  std::map<int, std::unique_ptr<Json>> pixels_;                       // by light
  std::map<int, std::size_t> branch_attachments_, branch_histories_;  // bytes, by light
  std::unique_ptr<Json> run_;
};

}  // namespace caustics::app
