#include "mote/scenario/schema.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "mote/scenario/scenario.hpp"

namespace mote {
namespace {

using Json = nlohmann::ordered_json;

/// Collects described keys as a JSON Schema object. Numbers may be written as expressions.
class SchemaWriter final : public Description {
 public:
  explicit SchemaWriter(Json& object) : object_(&object) { open(); }

  bool wants_all_variants() const override { return true; }

  void number(const Key& key, double& value, Range range) override {
    add(key, numeric("number", range), Json(value));
  }
  void number(const Key& key, std::optional<double>& value, Range range) override {
    add(key, numeric("number", range), value ? Json(*value) : Json());
  }
  void count(const Key& key, std::int64_t& value, Range range) override {
    add(key, numeric("integer", range), Json(value));
  }
  void count(const Key& key, std::optional<std::int64_t>& value, Range range) override {
    add(key, numeric("integer", range), value ? Json(*value) : Json());
  }
  void flag(const Key& key, bool& value) override { add(key, {{"type", "boolean"}}, Json(value)); }
  void text(const Key& key, std::string& value) override {
    add(key, {{"type", "string"}, {"minLength", 1}}, Json(value));
  }
  void numbers(const Key& key, std::vector<double>&) override {
    add(key, {{"type", "array"}, {"items", numeric("number", {})}}, Json());
  }
  void expression(const Key& key, std::string& value, std::string_view) override {
    add(key, {{"type", {"number", "string"}}}, Json(value));
  }
  void choice(const Key& key, std::string& value, const Choices& choices) override {
    add(key, one_of(choices), Json(value));
  }

  void variant(const Key& key, std::string& value, const Choices& choices,
               const std::function<void(const std::string&)>& rest) override {
    choice(key, value, choices);
    Json* outer = object_;
    for (const Choice& choice : choices) {
      Json alternative;
      alternative["if"]["properties"] = {{key.name, exactly(choice.name)}};
      const bool holds_if_absent = choice.name == value;
      if (!holds_if_absent) alternative["if"]["required"] = {key.name};
      object_ = &alternative["then"];
      rest(choice.name);
      if (!alternative["then"].is_null()) (*outer)["allOf"].push_back(alternative);
    }
    object_ = outer;
    if (short_form_ != nullptr) *short_form_ = true;
  }

  void section(const Key& key, const std::function<void()>& body) override {
    add(key, section_of(body), Json());
  }

  void list(const Key& key, std::size_t&, const std::function<void(std::size_t)>& body) override {
    const auto describe_one = [&] { body(0); };
    add(key,
        {{"type", "array"},
         {"minItems", key.required ? 1 : 0},
         {"items", section_of(describe_one)}},
        Json());
  }
  void expressions(const Key& key, std::vector<std::string>&) override {
    add(key, {{"type", "array"}, {"items", {{"type", {"number", "string"}}}}}, Json());
  }
  void words(const Key& key, std::vector<std::string>& values, const Choices& choices) override {
    add(key, {{"type", "array"}, {"minItems", 1}, {"items", one_of(choices)}},
        values.empty() ? Json() : Json(values));
  }

  void constants(const Key& key, std::vector<std::pair<std::string, double>>&) override {
    add(key, {{"type", "object"}, {"additionalProperties", numeric("number", {})}}, Json());
  }
  void paths(const Key& key, std::vector<PathValues>&, Values values) override {
    const Json list = {{"type", "array"}, {"minItems", 1}};
    add(key,
        {{"type", "object"},
         {"additionalProperties", values == Values::several ? list : Json(true)}},
        Json());
  }

 private:
  /// The schema of a section, with the short form that a variant in it allows.
  Json section_of(const std::function<void()>& body) {
    Json* outer = object_;
    bool* outer_short_form = short_form_;
    bool has_short_form = false;
    Json nested;
    object_ = &nested;
    short_form_ = &has_short_form;
    open();
    body();
    object_ = outer;
    short_form_ = outer_short_form;
    if (has_short_form) nested = {{"anyOf", {{{"type", "string"}, {"minLength", 1}}, nested}}};
    return nested;
  }

  /// A word, and the number that it is where it is one.
  static Json exactly(const std::string& word) {
    const bool is_number =
        std::ranges::all_of(word, [](unsigned char c) { return std::isdigit(c); });
    if (is_number) return {{"enum", {word, std::stoi(word)}}};
    return {{"const", word}};
  }

  static Json one_of(const Choices& choices) {
    Json words = Json::array();
    for (const Choice& choice : choices) {
      words.push_back(exactly(choice.name));
      words.back()["description"] = choice.summary;
    }
    return {{"oneOf", words}};
  }

  void open() {
    (*object_)["type"] = "object";
    (*object_)["unevaluatedProperties"] = false;
  }

  void add(const Key& key, Json schema, const Json& default_value) {
    schema["description"] = key.summary;
    const bool has_default = !default_value.is_null() && default_value != Json("");
    if (has_default && !key.required) schema["default"] = default_value;
    (*object_)["properties"][key.name] = schema;
    if (key.required) (*object_)["required"].push_back(key.name);
  }

  static Json numeric(const char* type, const Range& range) {
    Json schema = {{"type", {type, "string"}}};
    if (std::isfinite(range.lower))
      schema[range.open ? "exclusiveMinimum" : "minimum"] = range.lower;
    if (std::isfinite(range.upper)) schema["maximum"] = range.upper;
    return schema;
  }

  Json* object_;
  bool* short_form_ = nullptr;  ///< set when the open section has a variant
};

}  // namespace

std::string schema_of(const std::string& title,
                      const std::function<void(Description&)>& describe_all) {
  Json schema;
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = title;
  SchemaWriter writer(schema);
  describe_all(writer);
  return schema.dump(2);
}

std::string scenario_schema(const Catalogue& catalogue) {
  return schema_of("mote scenario", [&](Description& description) {
    Scenario scenario;
    describe(description, scenario, catalogue);
    describe_comparison(description, scenario.compare);
    describe_record(description, scenario);
  });
}

}  // namespace mote
