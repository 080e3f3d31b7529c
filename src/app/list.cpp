#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "mote/app/commands.hpp"
#include "mote/app/shared_folder.hpp"
#include "mote/particles/lattice.hpp"
#include "mote/stationary/stationary_file.hpp"

namespace mote {
namespace {

namespace fs = std::filesystem;

Choices operators(const Catalogue& catalogue) {
  Choices choices;
  for (const OperatorEntry& entry : catalogue.operators)
    choices.push_back({entry.name(), entry.summary});
  return choices;
}

/// The meshes of a line, and what studies have in every dimension.
Choices layouts(const Catalogue& catalogue) {
  Choices choices = choices_of(catalogue.layouts);
  for (const Choice& lattice : lattice_layouts()) choices.push_back(lattice);
  return choices;
}

/// Those that move, and those without time.
Choices models(const Catalogue& catalogue) {
  Choices choices = choices_of(catalogue.models);
  choices.insert(choices.end(), stationary_models.begin(), stationary_models.end());
  return choices;
}

/// The scenarios that came with mote, `topic/case`, each with its first comment.
Choices scenarios() {
  Choices choices;
  const fs::path root = shared_folder() / "scenarios";
  if (!fs::exists(root)) return choices;
  for (const auto& entry :
       fs::recursive_directory_iterator(root, fs::directory_options::follow_directory_symlink)) {
    if (entry.path().extension() != ".yaml") continue;
    std::string comment;
    std::getline(std::ifstream(entry.path()) >> std::ws, comment);
    const auto text = comment.find_first_not_of("# ");
    choices.push_back(
        {fs::relative(entry.path(), root).replace_extension().string(),
         comment.starts_with('#') && text != std::string::npos ? comment.substr(text) : ""});
  }
  std::ranges::sort(choices, {}, &Choice::name);
  return choices;
}

using Lister = Choices (*)(const Catalogue&);
const std::map<std::string, Lister> listers{
    {"kernels", [](const Catalogue& c) { return choices_of(c.kernels); }},
    {"operators", operators},
    {"models", models},
    {"integrators", [](const Catalogue& c) { return choices_of(c.integrators); }},
    {"layouts", layouts},
    {"exact", [](const Catalogue& c) { return choices_of(c.exact_solutions); }},
    {"scenarios", [](const Catalogue&) { return scenarios(); }}};

}  // namespace

std::vector<std::string> listable() {
  std::vector<std::string> names;
  for (const auto& [name, lister] : listers) names.push_back(name);
  return names;
}

int list(const Catalogue& catalogue, const std::string& what) {
  const Choices choices = listers.at(what)(catalogue);
  std::size_t width = 0;
  for (const Choice& choice : choices) width = std::max(width, choice.name.size());
  for (const Choice& choice : choices)
    fmt::print("{:<{}}  {}\n", choice.name, width, choice.summary);
  return 0;
}

}  // namespace mote
