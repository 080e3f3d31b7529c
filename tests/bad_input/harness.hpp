#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <map>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "support/program.hpp"

namespace mote::test {

/// A good scenario. A case of bad input changes a line or two of it, so lines keep their numbers.
inline constexpr std::array<std::string_view, 15> good_lines{
    /* 1 */ "name: base",
    /* 2 */ "dimension: 1",
    /* 3 */ "constants: {L: 4, G: 0.0015}",
    /* 4 */ "domain: {lower: [0], upper: [L]}",
    /* 5 */ "particles: {layout: regular, count: 41}",
    /* 6 */ "initial:",
    /* 7 */ "  density: \"1 + x/L\"",
    /* 8 */ "  velocity: \"0\"",
    /* 9 */ "model: {type: pressureless_gas, gravity: G}",
    /* 10 */ "operator: {family: sph, kernel: gauss, smoothing_length: 1.0}",
    /* 11 */ "time: {integrator: symplectic_euler, step: 0.01, end: 1}",
    /* 12 */ "output: {picture: false}",
    /* 13 */ "check:",
    /* 14 */ "  against: gravitating_sheets",
    /* 15 */ "  position: 0.01"};

/// These lines with some of them, counted from 1, replaced.
inline std::string with_edits(std::span<const std::string_view> good,
                              const std::map<int, std::string>& edits) {
  std::string text;
  for (int number = 1; number <= static_cast<int>(good.size()); ++number) {
    const auto edit = edits.find(number);
    text += edit != edits.end() ? edit->second : std::string(good[number - 1]);
    text += '\n';
  }
  return text;
}

/// The good scenario with some lines replaced.
inline std::string lines(const std::map<int, std::string>& edits) {
  return with_edits(good_lines, edits);
}

inline std::string line(int number, const std::string& text) { return lines({{number, text}}); }

/// A text whose `@`, if it has one, marks the place that the message must name.
struct Marked {
  std::string text;
  std::string place;  ///< `:line:column`, or nothing without a mark
};

inline Marked unmark(const std::string& marked) {
  const auto mark = marked.find('@');
  if (mark == std::string::npos) return {marked, ""};
  const std::string before = marked.substr(0, mark);
  const auto line = std::ranges::count(before, '\n') + 1;
  const auto column = mark - (before.rfind('\n') + 1) + 1;
  std::string place(1, ':');
  place += std::to_string(line) + ':' + std::to_string(column);
  return {before + marked.substr(mark + 1), place};
}

/// The answer that bad input must get.
struct Refusal {
  std::string beginning;  ///< with which standard error must begin: the place, or `mote: `
  std::string sentence;   ///< which it must contain
  int exit_code = 2;
};

/// Words that no message may have: leftovers of libraries and of our own making.
inline constexpr std::array<std::string_view, 10> unfit_words{
    "terminate called", "what()",       "-nan",      " at position ", "found at position",
    "at expression",    "character 0 ", "a against", "a integrator",  "a units"};

inline bool is_one_line(const std::string& errors) {
  const auto is_control = [](unsigned char c) { return std::iscntrl(c) != 0; };
  return errors.size() > 1 && errors.back() == '\n' &&
         std::ranges::count_if(errors, is_control) == 1;
}

/// What is wrong with an answer; empty if it is as it must be.
inline std::vector<std::string> faults(const Outcome& outcome, const Refusal& refusal) {
  std::vector<std::string> faults;
  const auto require = [&](bool holds, const std::string& fault) {
    if (!holds) faults.push_back(fault + "; standard error is:\n" + outcome.errors);
  };
  require(outcome.exit_code == refusal.exit_code,
          "the exit code is " + std::to_string(outcome.exit_code));
  require(outcome.errors.starts_with(refusal.beginning),
          "the message does not begin with '" + refusal.beginning + "'");
  require(outcome.errors.find(refusal.sentence) != std::string::npos,
          "the message does not say '" + refusal.sentence + "'");
  require(is_one_line(outcome.errors), "the message is not one line of plain text");
  for (const auto word : unfit_words)
    require(outcome.errors.find(word) == std::string::npos,
            "the message has the words '" + std::string(word) + "'");
  require(refusal.exit_code != 2 || outcome.output.empty(), "standard output is not empty");
  return faults;
}

/// Every file below a folder with its contents; folders end in `/`.
using Contents = std::map<std::string, std::string>;

inline Contents contents(const fs::path& folder) {
  Contents contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (entry.is_directory())
      contents[name + "/"];
    else
      contents[name] = read(entry.path());
  }
  return contents;
}

inline std::vector<std::string> changed(const Contents& before, const Contents& after) {
  std::vector<std::string> names;
  for (const auto& [name, text] : before)
    if (!after.contains(name) || after.at(name) != text) names.push_back(name);
  for (const auto& [name, text] : after)
    if (!before.contains(name)) names.push_back(name + " (new)");
  return names;
}

/// A folder in which mote runs; the scenario there is `scenario.yaml`.
class Workspace : public TemporaryFolder {
 public:
  explicit Workspace(const std::string& scenario = lines({})) {
    write(*this / "scenario.yaml", scenario);
  }

  Outcome mote(const std::vector<std::string>& arguments) const {
    std::vector<std::string> words{"-C", path().string(), MOTE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return Program(words, "/usr/bin/env").wait();
  }

  /// Runs mote, which must refuse and leave every file as it was.
  void expect_refusal(const std::vector<std::string>& arguments, const Refusal& refusal) const {
    const Contents before = contents(path());
    for (const auto& fault : faults(mote(arguments), refusal)) ADD_FAILURE() << fault;
    for (const auto& name : changed(before, contents(path()))) ADD_FAILURE() << "touched " << name;
  }
};

/// A bad scenario file: `text` has an `@` at the place that the message must name.
struct ScenarioCase {
  std::string label, text, sentence;

  friend std::ostream& operator<<(std::ostream& out, const ScenarioCase& c) {
    return out << c.label;
  }
};

/// Bad scenario files: run and check refuse them with the same message, and make no folder.
class BadScenario : public testing::TestWithParam<ScenarioCase> {
 protected:
  static void expect_refused() {
    const Marked marked = unmark(GetParam().text);
    const Workspace workspace(marked.text);
    const Refusal refusal{"scenario.yaml" + marked.place + ": ", GetParam().sentence};
    workspace.expect_refusal({"run", "scenario.yaml", "--out", "out"}, refusal);
    workspace.expect_refusal({"check", "scenario.yaml"}, refusal);
  }
};

/// A bad command. `prepare` changes the folder first.
struct CommandCase {
  std::string label;
  std::vector<std::string> arguments;
  std::string beginning, sentence;
  std::function<void(const Workspace&)> prepare = [](const Workspace&) {};

  friend std::ostream& operator<<(std::ostream& out, const CommandCase& c) {
    return out << c.label;
  }
};

inline constexpr auto by_label = [](const auto& info) { return info.param.label; };

/// The arguments of a run of the good scenario, and more.
inline std::vector<std::string> running(std::vector<std::string> more) {
  more.insert(more.begin(), {"run", "scenario.yaml"});
  return more;
}

/// The same with one `--set`, and an output folder.
inline std::vector<std::string> setting(const std::string& assignment) {
  return running({"--out", "out", "--set", assignment});
}

}  // namespace mote::test
