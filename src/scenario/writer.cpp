#include "mote/scenario/writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

namespace mote {

void Writer::entry(const std::string& key, const std::string& word) {
  out_ << YAML::Key << key << YAML::Value << word;
}

void Writer::number(const Key& key, double& value, Range) {
  entry(key.name, fmt::format("{}", value));
}

void Writer::number(const Key& key, std::optional<double>& value, Range range) {
  if (value) number(key, *value, range);
}

void Writer::count(const Key& key, std::int64_t& value, Range) {
  entry(key.name, fmt::format("{}", value));
}

void Writer::count(const Key& key, std::optional<std::int64_t>& value, Range range) {
  if (value) count(key, *value, range);
}

void Writer::flag(const Key& key, bool& value) { entry(key.name, value ? "true" : "false"); }

void Writer::text(const Key& key, std::string& value) {
  if (value.empty()) return;  // as good as not given
  out_ << YAML::Key << key.name << YAML::Value << YAML::DoubleQuoted << value;
}

void Writer::numbers(const Key& key, std::vector<double>& values) {
  out_ << YAML::Key << key.name << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const double value : values) out_ << fmt::format("{}", value);
  out_ << YAML::EndSeq;
}

void Writer::expression(const Key& key, std::string& value, std::string_view) { text(key, value); }

void Writer::choice(const Key& key, std::string& value, const Choices&) {
  if (!value.empty()) entry(key.name, value);
}

void Writer::variant(const Key& key, std::string& value, const Choices& choices,
                     const std::function<void(const std::string&)>& rest) {
  choice(key, value, choices);
  rest(value);
}

void Writer::section(const Key& key, const std::function<void()>& body) {
  out_ << YAML::Key << key.name << YAML::Value << YAML::BeginMap;
  body();
  out_ << YAML::EndMap;
}

void Writer::list(const Key& key, std::size_t& count,
                  const std::function<void(std::size_t)>& body) {
  if (count == 0) return;
  out_ << YAML::Key << key.name << YAML::Value << YAML::BeginSeq;
  for (std::size_t k = 0; k < count; ++k) {
    out_ << YAML::BeginMap;
    body(k);
    out_ << YAML::EndMap;
  }
  out_ << YAML::EndSeq;
}

void Writer::expressions(const Key& key, std::vector<std::string>& values) {
  if (values.empty()) return;
  out_ << YAML::Key << key.name << YAML::Value << YAML::BeginSeq;
  for (const std::string& value : values) out_ << YAML::DoubleQuoted << value;
  out_ << YAML::EndSeq;
}

void Writer::words(const Key& key, std::vector<std::string>& values, const Choices&) {
  if (values.empty()) return;
  out_ << YAML::Key << key.name << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const std::string& value : values) out_ << value;
  out_ << YAML::EndSeq;
}

void Writer::constants(const Key& key, std::vector<std::pair<std::string, double>>& values) {
  if (values.empty()) return;
  section(key, [&] {
    for (auto& [name, value] : values) number({name, ""}, value, {});
  });
}

void Writer::paths(const Key& key, std::vector<PathValues>& paths, Values values) {
  if (paths.empty()) return;
  section(key, [&] {
    for (const auto& [path, texts] : paths) {
      const std::string list = fmt::format("[{}]", fmt::join(texts, ", "));
      const YAML::Node node = YAML::Load(values == Values::several ? list : texts.front());
      out_ << YAML::Key << path << YAML::Value << node;
    }
  });
}

std::string yaml_of(const std::function<void(Description&)>& describe_all) {
  YAML::Emitter out;
  out << YAML::BeginMap;
  Writer writer(out);
  describe_all(writer);
  out << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace mote
