#include "mote/scenario/document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "mote/scenario/located_error.hpp"

namespace mote {
namespace {

using Place = std::function<Origin(const YAML::Mark&)>;

Value convert(const YAML::Node& node, const Place& place);

void convert_section(const YAML::Node& node, const Place& place, Value& value) {
  value.kind = Value::Kind::section;
  for (const auto& entry : node) {
    const Origin origin = place(entry.first.Mark());
    if (!entry.first.IsScalar()) throw LocatedError(origin.text, "a key must be a single word");
    const std::string key = entry.first.Scalar();
    if (value.find(key) != nullptr)
      throw LocatedError(origin.text, fmt::format("the key '{}' is given twice", key));
    value.entries.push_back({key, origin, convert(entry.second, place)});
  }
}

Value convert(const YAML::Node& node, const Place& place) {
  Value value;
  value.origin = place(node.Mark());
  if (node.IsScalar()) {
    value.kind = Value::Kind::word;
    value.word = node.Scalar();
    value.quoted = node.Tag() == "!";
  } else if (node.IsSequence()) {
    value.kind = Value::Kind::list;
    for (const auto& item : node) value.list.push_back(convert(item, place));
  } else if (node.IsMap()) {
    convert_section(node, place, value);
  }
  return value;
}

/// Parses one YAML document, turning the library's exceptions into ours.
Value parse(const std::string& text, const Place& place) {
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAll(text);
    if (documents.size() > 1)
      throw LocatedError(place(documents[1].Mark()).text,
                         "a second YAML document begins here; one file is one scenario");
    return documents.empty() ? Value{} : convert(documents.front(), place);
  } catch (const YAML::Exception& error) {
    throw LocatedError(place(error.mark).text, "this is not YAML: " + error.msg);
  }
}

std::string contents(const std::string& path) {
  if (std::filesystem::is_directory(path)) throw LocatedError(path, "this is a folder, not a file");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) {
    // An empty file sets the fail bit too, and is told apart by its size.
    std::error_code ignored;
    if (!file.is_open() || std::filesystem::file_size(path, ignored) > 0)
      throw LocatedError(path, "cannot read this file");
  }
  return text.str();
}

}  // namespace

const Value* Value::find(const std::string& key) const {
  const auto found = std::ranges::find(entries, key, &Entry::key);
  return found == entries.end() ? nullptr : &found->value;
}

Document Document::from_file(const std::string& path) {
  Document document;
  document.root_ = parse(contents(path), [&](const YAML::Mark& mark) {
    return mark.is_null() ? Origin{path}
                          : Origin{fmt::format("{}:{}:{}", path, mark.line + 1, mark.column + 1)};
  });
  if (document.root_.kind == Value::Kind::empty) throw LocatedError(path, "this file is empty");
  if (document.root_.kind != Value::Kind::section)
    throw LocatedError(document.root_.origin.text,
                       "a scenario is a section of keys (`name: value`), this is not");
  document.root_.origin = {path};
  return document;
}

void Document::set(const std::string& assignment) {
  const Origin origin{"--set " + assignment};
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    throw LocatedError(origin.text, "this must have the form key.path=value");
  Value* value = &root_;
  std::istringstream path(assignment.substr(0, equals));
  for (std::string key; std::getline(path, key, '.');) {
    if (value->kind == Value::Kind::word) value->short_form = value->word;
    if (value->kind == Value::Kind::list)
      throw LocatedError(origin.text, "a list is set as a whole, as in domain.upper=[2]");
    value->kind = Value::Kind::section;
    auto found = std::ranges::find(value->entries, key, &Value::Entry::key);
    if (found == value->entries.end()) {
      value->entries.push_back({key, origin, Value{.origin = origin}});
      found = std::prev(value->entries.end());
    }
    value = &found->value;
  }
  *value = parse(assignment.substr(equals + 1), [&](const YAML::Mark&) { return origin; });
  value->origin = origin;
}

std::string Document::locate(const std::string& path) const {
  const Value* value = &root_;
  std::istringstream keys(path);
  for (std::string key; std::getline(keys, key, '.');) {
    const Value* next = value->find(key);
    if (next == nullptr) break;
    value = next;
  }
  return value->origin.text;
}

}  // namespace mote
