#include "mote/scenario/document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <sstream>

#include "mote/scenario/located_error.hpp"

namespace mote {
namespace {

using Place = std::function<Origin(const YAML::Mark&)>;

/// Turns the nodes of yaml-cpp into our values and refuses what a scenario has no use for: tags,
/// keys given twice, values nested without end or too many of them (aliases can do both).
class Converter {
 public:
  explicit Converter(const Place& place) : place_(place) {}

  Value convert(const YAML::Node& node) {
    Value value;
    value.origin = place_(node.Mark());
    if (++values_ > most_values) throw LocatedError(value.origin.text, "there are too many values");
    if (depth_ > deepest) throw LocatedError(value.origin.text, nested_too_deep);
    if (!node.Tag().empty() && node.Tag() != "?" && node.Tag() != "!")
      throw LocatedError(value.origin.text,
                         fmt::format("the tag '{}' has no meaning in a scenario", node.Tag()));
    ++depth_;
    if (node.IsScalar()) {
      value.kind = Value::Kind::word;
      value.word = node.Scalar();
    } else if (node.IsSequence()) {
      value.kind = Value::Kind::list;
      for (const auto& item : node) value.list.push_back(convert(item));
    } else if (node.IsMap()) {
      convert_section(node, value);
    }
    --depth_;
    return value;
  }

  static constexpr const char* nested_too_deep =
      "values are nested too deep here, or an alias refers to itself";

 private:
  static constexpr int most_values = 1'000'000, deepest = 50;

  void convert_section(const YAML::Node& node, Value& value) {
    value.kind = Value::Kind::section;
    for (const auto& entry : node) {
      const Origin origin = place_(entry.first.Mark());
      if (!entry.first.IsScalar()) throw LocatedError(origin.text, "a key must be a single word");
      const std::string key = entry.first.Scalar();
      if (value.find(key) != nullptr)
        throw LocatedError(origin.text, fmt::format("the key '{}' is given twice", key));
      value.entries.push_back({key, origin, convert(entry.second)});
      // The parser puts a missing value where the next line begins; the user misses it here.
      const bool elsewhere = entry.second.Mark().line != entry.first.Mark().line;
      if (entry.second.IsNull() && elsewhere) value.entries.back().value.origin = origin;
    }
  }

  const Place& place_;
  int values_ = 0, depth_ = 0;
};

/// Where a tab indents a line, which YAML forbids and its parser explains badly.
std::optional<YAML::Mark> indenting_tab(const std::string& text) {
  YAML::Mark mark;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line); ++mark.line) {
    const auto first = line.find_first_not_of(' ');
    if (first == std::string::npos || line[first] != '\t') continue;
    mark.column = static_cast<int>(first);
    return mark;
  }
  return std::nullopt;
}

/// Refuses a second document. It must be met while the first is read: behind `[a], [b]` the parser
/// finds documents without end.
class OneDocument final : public YAML::EventHandler {
 public:
  explicit OneDocument(const Place& place) : place_(place) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ > 0)
      throw LocatedError(place_(mark).text,
                         "a second YAML document begins here; one file is one scenario");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

 private:
  const Place& place_;
  int documents_ = 0;
};

void refuse_second_document(const std::string& text, const Place& place) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  OneDocument handler(place);
  while (parser.HandleNextDocument(handler)) {
  }
}

/// Parses one YAML document, turning the library's exceptions into ours.
Value parse(const std::string& text, const Place& place) {
  try {
    refuse_second_document(text, place);
    const YAML::Node node = YAML::Load(text);
    return node.IsDefined() ? Converter(place).convert(node) : Value{};
  } catch (const YAML::DeepRecursion& error) {
    throw LocatedError(place(error.mark).text, Converter::nested_too_deep);
  } catch (const YAML::Exception& error) {
    if (const auto tab = indenting_tab(text))
      throw LocatedError(place(*tab).text, "a tab indents this line; YAML indents by spaces");
    throw LocatedError(place(error.mark).text, "this is not YAML: " + error.msg);
  }
}

bool has_sections(const Value& list) {
  return std::ranges::any_of(list.list,
                             [](const Value& item) { return item.kind == Value::Kind::section; });
}

void emit(YAML::Emitter& out, const Value& value) {
  switch (value.kind) {
    case Value::Kind::empty:
      out << YAML::Null;
      break;
    case Value::Kind::word:
      out << value.word;
      break;
    case Value::Kind::list:
      if (!has_sections(value)) out << YAML::Flow;
      out << YAML::BeginSeq;
      for (const Value& item : value.list) out << YAML::Flow, emit(out, item);
      out << YAML::EndSeq;
      break;
    case Value::Kind::section:
      out << YAML::BeginMap;
      for (const auto& entry : value.entries) {
        out << YAML::Key << entry.key << YAML::Value;
        emit(out, entry.value);
      }
      out << YAML::EndMap;
  }
}

std::string contents(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw LocatedError(path, "this is a folder, not a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw LocatedError(path, "cannot read this file; is there one?");
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

const Value* Value::find(const std::string& key) const {
  const auto found = std::ranges::find(entries, key, &Entry::key);
  return found == entries.end() ? nullptr : &found->value;
}

std::vector<std::string> keys_of(const std::string& path) {
  std::vector<std::string> keys;
  std::istringstream words(path);
  for (std::string key; std::getline(words, key, '.');) keys.push_back(key);
  return keys;
}

std::string flow_text(const Value& value) {
  YAML::Emitter out;
  out.SetSeqFormat(YAML::Flow);
  out.SetMapFormat(YAML::Flow);
  out << YAML::BeginSeq;  // a text with a comma needs quotes only inside of one
  emit(out, value);
  out << YAML::EndSeq;
  const std::string list = out.c_str();
  const auto first = list.find_first_not_of(' ', 1);
  return list.substr(first, list.size() - first - 1);
}

std::string block_text(const Value& value) {
  YAML::Emitter out;
  emit(out, value);
  return std::string(out.c_str()) + "\n";
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
  set(keys_of(assignment.substr(0, equals)), parsed(assignment.substr(equals + 1), origin), origin);
}

Value Document::parsed(const std::string& text, const Origin& origin) {
  Value value = parse(text, [&](const YAML::Mark&) { return origin; });
  value.origin = origin;
  return value;
}

void Document::set(const std::vector<std::string>& keys, Value given, const Origin& origin) {
  Value* value = &root_;
  for (const std::string& key : keys) {
    if (value->kind == Value::Kind::word) {
      value->short_form = value->word;
      value->origin = origin;
    }
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
  *value = std::move(given);
}

const Value* Document::find(const std::vector<std::string>& keys) const {
  const Value* value = &root_;
  for (const std::string& key : keys)
    if (value != nullptr) value = value->find(key);
  return value;
}

std::string Document::locate(const std::string& path) const {
  const Value* value = &root_;
  for (const std::string& key : keys_of(path)) {
    const Value* next = value->find(key);
    std::size_t item = 0;
    const auto parsed = std::from_chars(key.data(), key.data() + key.size(), item);
    if (parsed.ec == std::errc{} && item < value->list.size()) next = &value->list[item];
    if (next == nullptr) break;
    value = next;
  }
  return value->origin.text;
}

}  // namespace mote
