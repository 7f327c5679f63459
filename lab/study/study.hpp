// A whole study as its outputs tell it.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lab/study/row.hpp"

namespace caustics::study {

// The first row of a backend, timed once more after all others: what the machine itself changed meanwhile.
struct Drift {
  std::string backend;
  double before = 0.0, after = 0.0;  // milliseconds of the caustic passes
};

struct Study {
  std::vector<Knob> knobs;
  bool cross = false;
  std::string program;         // and its version
  std::string scene, command;  // the file's name; what was typed
  int width = 0, height = 0;
  // What everything was measured against and drawn from: two studies with the same have comparable rows.
  nlohmann::ordered_json identity;
  std::string truth;            // in words
  bool own_limit = false;       // the truth is this program's own, no independent one
  std::optional<double> noise;  // of the truth, relative (Truth::noise)
  double white = 0.0;           // lux: full colour of the difference pictures
  std::size_t planned = 0;      // rows of the whole study
  std::vector<StudyRow> rows;   // those that are done
  std::vector<Drift> drifts;    // of the backends, once all rows are there

  bool complete() const { return rows.size() == planned; }
};

// Fills in StudyRow::on_front and ::reference_limited.
void judge(Study& study);
// The rows on a backend's front, from the quickest to the most accurate.
std::vector<const StudyRow*> front_of(const Study& study, const std::string& backend);
// In the order of the rows.
std::vector<std::string> backends_of(const Study& study);
// All steps whose rows are there, backend by backend.
std::vector<std::string> sentences_of(const Study& study);
// One sentence.
std::string drift_text(const Study& study, const Drift& drift);
// "what limits the truth", one sentence that stands in every output.
std::string truth_text(const Study& study);

nlohmann::ordered_json study_json(const Study& study);
std::string study_csv(const Study& study);
// What was read back from an earlier study.json: its identity and those of its rows that are whole.
struct EarlierStudy {
  nlohmann::ordered_json identity;
  double white = 0.0;
  std::vector<StudyRow> rows;  // without point
  std::vector<Drift> drifts;
};
// None where the text is no study of this format.
std::optional<EarlierStudy> read_study(const std::string& text);

}  // namespace caustics::study
