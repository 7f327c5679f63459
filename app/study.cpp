// caustics study: error against time over many settings.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "app/json.hpp"
#include "app/output/display_pair.hpp"
#include "app/output/image_file.hpp"
#include "app/output/report_folder.hpp"
#include "app/output/stats.hpp"
#include "app/shell/atomic_file.hpp"
#include "app/shell/interrupt.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/progress.hpp"
#include "app/shell/terminal.hpp"
#include "app/shell/version.hpp"
#include "app/study_render.hpp"
#include "app/study_request.hpp"
#include "app/study_text.hpp"
#include "app/study_truth.hpp"
#include "lab/study/difference_picture.hpp"
#include "lab/study/effect_rows.hpp"
#include "lab/study/fingerprint.hpp"
#include "lab/study/report_page.hpp"
#include "lab/study/sentence.hpp"
#include "lab/study/study_plot.hpp"
#include "lab/study/sweep_settings.hpp"
#include "pipeline/gpu/device.hpp"

namespace caustics::app {

namespace fs = std::filesystem;
using namespace study;

namespace {

constexpr double kBetweenStudySaves = 2000.0;  // milliseconds

// A row that is to be there.
struct Job {
  Point point;
  Backend backend = Backend::Software;
  std::string device;
  Settings settings;
  double work = 0.0;  // about in proportion to its time

  // What it leaves out, or null.
  const Omission* without(const std::vector<Knob>& knobs) const {
    const bool whole = knobs.front().key != kWithout || point.values.front() == kNothing;
    return whole ? nullptr : &omission(point.values.front());
  }
  // As --stats writes them, and what tells rows of the same settings apart.
  Json settings_of_row(const std::vector<Knob>& knobs) const {
    Json json = settings_json(settings);
    if (const Omission* left_out = without(knobs)) json[kWithout] = left_out->name;
    return json;
  }
};

void refuse_too_many(const StudyRequest& request, const std::vector<Knob>& knobs) {
  const std::size_t most = kMostRuns / request.backends.size();
  // The count is exact for a product; one key at a time repeats points, which expand() leaves out.
  if (count_points(knobs, request.cross, 8 * kMostRuns) <= most) return;
  std::string number = "more than " + grouped(8 * kMostRuns);
  if (const std::size_t count = count_points(knobs, request.cross, 8 * kMostRuns); count <= 8 * kMostRuns) {
    const std::size_t runs = expand(knobs, request.cross).size() * request.backends.size();
    if (runs <= kMostRuns) return;
    number = grouped(runs);
  }
  throw Error(ExitCode::WrongUsage, "this study would be " + number + " runs, at most " + grouped(kMostRuns) +
                                        " are allowed; vary fewer keys or values" +
                                        (request.cross ? ", or leave out --cross" : ""));
}

double work_of(const Settings& s) {
  const auto square = [](int side) { return static_cast<double>(side) * static_cast<double>(side); };
  return square(s.grid) + square(s.map) + static_cast<double>(s.width) * static_cast<double>(s.height);
}

std::string finest_text(const Settings& s) {
  return "this program's own finest setting (grid " + std::to_string(s.grid) + ", map " +
         std::to_string(s.map) + ", estimator " + std::string(name_of(s.estimator)) + ", splat " +
         std::string(name_of(s.splat)) + ", on the software device)";
}

// Also after an interruption, so that what is done stays.
void put(const fs::path& path, const std::string& text) {
  PendingFile file(path);
  file.write_all(text.data(), text.size());
  file.move_into_place();
}

Json print_of(const fs::path& file) { return file.empty() ? Json() : fingerprint(file); }

class StudyRun {
 public:
  explicit StudyRun(StudyRequest request) : request_(std::move(request)), progress_(request_.quiet) {}

  void run() {
    prepare();
    try {
      do_all();
    } catch (...) {
      progress_.clear();
      leave_what_is_done();
      throw;
    }
    write_all();
    progress_.clear();
    std::fputs(report_text(study_).c_str(), stdout);
    if (!request_.quiet) say_done();
  }

 private:
  void prepare() {
    study_.knobs = knobs_of(request_);
    study_.cross = request_.cross;
    refuse_too_many(request_, study_.knobs);
    finest_ = finest_settings(request_.frame.settings, study_.knobs);
    plan_jobs();
    study_.width = request_.frame.settings.width;
    study_.height = request_.frame.settings.height;
    if (request_.traced.wanted) trace();
    describe();
    if (!request_.truth.empty()) use(read_truth(request_.truth, study_.width, study_.height, request_.mask));
    make_folder();
    if (request_.resume) read_earlier();
  }

  // From here on what is traced is a file like any other. Rows that are to be kept need the truth that they
  // were measured against.
  void trace() {
    make_folder();
    const fs::path file = request_.folder / "truth.exr";
    require_writable(file);
    FrameRequest frame = request_.frame;
    frame.settings.wavelengths = finest_.wavelengths;
    const TraceFrom from = !request_.resume                                      ? TraceFrom::Nothing
                           : fs::is_regular_file(request_.folder / "study.json") ? TraceFrom::Finished
                                                                                 : TraceFrom::State;
    try {
      read_mask(request_.mask, study_.width, study_.height);
      say_traced(trace_truth(
          frame, request_.traced, file, from, [&](const std::string& step) { progress_.show(step); },
          [&](const std::string& line) { progress_.clear(), note(line); }));
    } catch (...) {
      progress_.clear();
      leave_what_is_done();
      if (fs::is_regular_file(file.string() + ".state"))
        note(one_line(file.string()) + " holds what is traced; --resume goes on");
      throw;
    }
    request_.truth = file;
  }

  void say_traced(const TracedLight& light) {
    progress_.clear();
    for (const std::string& each : light.notes) note("the truth: " + each);
    if (light.good) return;
    const bool is_small = light.error <= request_.traced.error;
    note("the truth's relative error is " + significant(100.0 * light.error, 3) + "% after " +
         std::to_string(light.batches) + " batches, " +
         (is_small ? "of which an estimate needs four"
                   : "not the " + significant(100.0 * request_.traced.error, 3) + "% of --truth-error") +
         "; --truth-seconds gives it longer");
  }

  void plan_jobs() {
    const Settings& base = request_.frame.settings;
    for (const Backend backend : request_.backends) {
      BackendRequest device = request_.frame.backend;
      device.backend = backend;
      devices_.push_back(make_device(device)->description());
    }
    for (const Point& point : expand(study_.knobs, request_.cross)) {
      const Settings settings = settings_at(base, study_.knobs, point);
      for (std::size_t b = 0; b < request_.backends.size(); ++b)
        jobs_.push_back({point, request_.backends[b], devices_[b], settings, work_of(settings)});
    }
    study_.planned = jobs_.size();
  }

  void describe() {
    const FrameRequest& frame = request_.frame;
    study_.scene = frame.scene.filename().string();
    study_.program = version_line();
    study_.command = request_.command;
    study_.own_limit = request_.truth.empty();
    study_.truth = study_.own_limit ? finest_text(finest_) : one_line(request_.truth.string());
    // One after the other, because any of the files may be missing: an exception out of the middle of one
    // expression with choices destroys what is not there yet (g++ 12).
    Json truth = Json::object();
    if (study_.own_limit) {
      truth["finest"] = settings_json(finest_);
    } else {
      truth["file"] = print_of(request_.truth);
    }
    Json& identity = study_.identity;
    identity["program"] = study_.program;
    identity["scene"] = scene_fingerprint(frame.scene);
    identity["environment"] = print_of(frame.environment.value_or(fs::path()));
    identity["animation"] = frame.animation;
    identity["seconds"] = frame.seconds.value_or(0.0);
    identity["threads"] = frame.backend.threads;
    identity["truth"] = truth;
    identity["mask"] = print_of(request_.mask);
  }

  bool would_replace(const fs::path& path) const {
    if (request_.resume) return false;  // it is called a study's
    const fs::path name = path.filename();
    std::error_code error;
    if (name == "img") return !fs::is_empty(path, error);
    if (name == "truth.exr") return request_.traced.wanted;
    return std::find(std::begin(kStudyFiles), std::end(kStudyFiles), name) != std::end(kStudyFiles);
  }

  void make_folder() {
    if (has_folder_) return;
    made_folder_ = make_report_folder(request_.folder, "study.json",
                                      [&](const fs::path& path) { return would_replace(path); });
    has_folder_ = true;
    std::error_code error;
    fs::create_directories(request_.folder / "img", error);
    require_writable(request_.folder / "img" / "truth.png");
    for (const char* file : kStudyFiles) require_writable(request_.folder / file);
  }

  void read_earlier() {
    std::ifstream in(request_.folder / "study.json", std::ios::binary);
    if (!in) return note("there is no study.json to resume: all rows are run");
    std::stringstream text;
    text << in.rdbuf();
    std::optional<EarlierStudy> earlier = read_study(text.str());
    if (!earlier) return note("study.json cannot be read: all rows are run");
    if (earlier->identity != study_.identity)
      return note("study.json is of another scene, truth, mask, moment or program: all rows are run");
    earlier_ = std::move(earlier);
    study_.white = earlier_->white;
  }

  // An earlier row for a job, picture and all.
  const StudyRow* earlier_row(const Job& job) const {
    if (!earlier_) return nullptr;
    std::error_code error;
    for (const StudyRow& row : earlier_->rows) {
      if (row.backend == name_of(job.backend) && row.device == job.device && row.repeat == request_.repeat &&
          row.settings == job.settings_of_row(study_.knobs) && row.problem.empty() &&
          fs::is_regular_file(request_.folder / row.picture, error))
        return &row;
    }
    return nullptr;
  }

  void do_all() {
    slots_.resize(jobs_.size());
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const StudyRow* row = earlier_row(jobs_[i]);
      if (!row) {
        left_ += jobs_[i].work;
        continue;
      }
      slots_[i] = *row;
      slots_[i]->point = jobs_[i].point;
      ++reused_;
    }
    gather();
    for (std::size_t i = 0; i < jobs_.size(); ++i)
      if (!slots_[i]) do_one(i);
    if (reused_ < jobs_.size()) {
      time_again();
    } else {
      study_.drifts = earlier_->drifts;
    }
  }

  // The first row of each backend, which stands at the head of jobs_.
  void time_again() {
    for (std::size_t b = 0; b < request_.backends.size(); ++b) {
      if (!slots_[b] || !slots_[b]->problem.empty()) continue;
      const Rendered rendered = render(jobs_[b], "the first row again (" + slots_[b]->backend + "): ");
      study_.drifts.push_back({slots_[b]->backend, slots_[b]->caustic.median, rendered.times.caustic.median});
    }
  }

  Rendered render(const Job& job, const std::string& head) {
    FrameRequest frame = request_.frame;
    frame.settings = job.settings;
    frame.backend.backend = job.backend;
    return render_setting(
        frame, request_.repeat, [&](const std::string& step) { progress_.show(head + step); },
        job.without(study_.knobs));
  }

  void do_one(std::size_t i) {
    const Job& job = jobs_[i];
    if (!truth_) draw_truth();
    if (!shown_) {
      show_truth();
      shown_ = Stopwatch();
    }
    head_ = head_text(job, done_ > 0.0 ? shown_->milliseconds() / done_ * left_ : 0.0);
    slots_[i] = row_of(job);
    done_ += job.work;
    left_ -= job.work;
    gather();
    save_now_and_then();
  }

  // What is done, in the order of the jobs.
  void gather() {
    study_.rows.clear();
    for (const std::optional<StudyRow>& slot : slots_)
      if (slot) study_.rows.push_back(*slot);
    judge(study_);
  }

  void use(Truth truth) {
    truth_ = std::move(truth);
    study_.noise = truth_->noise;
    study_.white = truth_->white;
  }

  void draw_truth() {
    FrameRequest frame = request_.frame;
    frame.settings = finest_;
    frame.backend.backend = Backend::Software;
    const Rendered rendered =
        render_setting(frame, 0, [&](const std::string& step) { progress_.show("the truth: " + step); });
    use(make_truth(rendered.caustic, read_mask(request_.mask, study_.width, study_.height), study_.scene));
  }

  void show_truth() {
    const Image small = small_picture(truth_->caustic);
    if (const DisplayPair pair = display_pair(small, small); pair.impossible.empty())
      write_png(request_.folder / "img" / "truth.png", pair.b);
  }

  StudyRow row_of(const Job& job) {
    StudyRow row{.point = job.point,
                 .backend = name_of(job.backend),
                 .device = job.device,
                 .settings = job.settings_of_row(study_.knobs),
                 .repeat = request_.repeat};
    try {
      measure(job, row);
    } catch (const Error& error) {
      // One setting that cannot be (too large, a numeric fault) is no reason to lose the others.
      if (error.code() != ExitCode::WrongUsage && error.code() != ExitCode::NumericFault) throw;
      row.problem = one_line(error.what());
    }
    return row;
  }

  void measure(const Job& job, StudyRow& row) {
    const Rendered rendered = render(job, head_);
    row.texture_bytes = rendered.texture_bytes;
    row.frame = rendered.times.frame;
    row.caustic = rendered.times.caustic;
    row.passes = rendered.times.passes;
    progress_.show(head_ + "measuring");
    row.figures = figures_against(*truth_, rendered.caustic);
    const std::string picture = "img/" + point_file(study_.knobs, job.point) + "_" + row.backend + ".png";
    write_png(request_.folder / picture,
              difference_picture(rendered.caustic, truth_->caustic, truth_->white));
    row.picture = picture;
  }

  // "row 12 of 17, 34 s left: grid 256, map 128 (software): "
  std::string head_text(const Job& job, double left) const {
    std::string text =
        "row " + std::to_string(study_.rows.size() + 1) + " of " + std::to_string(jobs_.size());
    if (left > 0.0) text += ", " + duration_text(left) + " left";
    return text + ": " + point_text(study_.knobs, job.point) + " (" + name_of(job.backend) + "): ";
  }

  // So that not even the machine's end costs more than the last seconds.
  void save_now_and_then() {
    if (saved_.milliseconds() < kBetweenStudySaves) return;
    put(request_.folder / "study.json", json_text(study_json(study_)));
    saved_ = Stopwatch();
  }

  void write_all() {
    put(request_.folder / "study.json", json_text(study_json(study_)));
    put(request_.folder / "study.csv", study_csv(study_));
    if (request_.effects) put(request_.folder / "effects.csv", effects_csv(study_));
    put(request_.folder / "report.html", report_page(study_, request_.folder));
    if (const std::string svg = plot_file(study_); !svg.empty()) put(request_.folder / "error_time.svg", svg);
  }

  void leave_what_is_done() {
    if (study_.rows.empty()) {
      std::error_code error;  // folders with anything in them stay
      fs::remove(request_.folder / "img", error);
      if (made_folder_) fs::remove(request_.folder, error);
      return;
    }
    write_all();
    note(std::to_string(study_.rows.size()) + " of " + std::to_string(jobs_.size()) + " rows are in " +
         one_line(request_.folder.string()) + "; --resume goes on");
  }

  void note(const std::string& line) const {
    if (!request_.quiet) std::fprintf(stderr, "note: %s\n", line.c_str());
  }

  void say_done() const {
    std::fprintf(stderr, "%s: %zu rows", one_line((request_.folder / "report.html").string()).c_str(),
                 study_.rows.size());
    if (reused_ > 0) std::fprintf(stderr, ", %zu of them from before", reused_);
    std::string devices;
    for (const std::string& device : devices_) devices += (devices.empty() ? "" : " and ") + one_line(device);
    std::fprintf(stderr, ", in %s on %s\n", duration_text(total_.milliseconds()).c_str(), devices.c_str());
  }

  StudyRequest request_;
  Progress progress_;
  Study study_;
  Settings finest_;
  std::vector<std::string> devices_;  // by request_.backends
  std::vector<Job> jobs_;
  std::optional<EarlierStudy> earlier_;
  std::optional<Truth> truth_;
  std::vector<std::optional<StudyRow>> slots_;  // by jobs_
  bool has_folder_ = false, made_folder_ = false;
  std::size_t reused_ = 0;
  std::string head_;                // of the progress line
  double done_ = 0.0, left_ = 0.0;  // work
  std::optional<Stopwatch> shown_;  // since the truth is there
  Stopwatch total_, saved_;
};

}  // namespace

ExitCode run_study(const Arguments& arguments) {
  StudyRequest request;
  if (!parse_study(arguments, request)) return ExitCode::Done;
  StudyRun(std::move(request)).run();
  return ExitCode::Done;
}

}  // namespace caustics::app
