#pragma once

#include <functional>
#include <string>

#include "mote/options/description.hpp"

namespace YAML {
class Emitter;
}

namespace mote {

/// Writes described values as YAML, every default included; numbers round-trip exactly.
class Writer final : public Description {
 public:
  explicit Writer(YAML::Emitter& out) : out_(out) {}

  void number(const Key& key, double& value, Range range) override;
  void number(const Key& key, std::optional<double>& value, Range range) override;
  void count(const Key& key, std::int64_t& value, Range range) override;
  void count(const Key& key, std::optional<std::int64_t>& value, Range range) override;
  void flag(const Key& key, bool& value) override;
  void text(const Key& key, std::string& value) override;
  void numbers(const Key& key, std::vector<double>& values) override;
  void expression(const Key& key, std::string& value, std::string_view variables) override;
  void choice(const Key& key, std::string& value, const Choices& choices) override;
  void variant(const Key& key, std::string& value, const Choices& choices,
               const std::function<void(const std::string&)>& rest) override;
  void section(const Key& key, const std::function<void()>& body) override;
  void list(const Key& key, std::size_t& count,
            const std::function<void(std::size_t)>& body) override;
  void expressions(const Key& key, std::vector<std::string>& values) override;
  void words(const Key& key, std::vector<std::string>& values, const Choices& choices) override;
  void constants(const Key& key, std::vector<std::pair<std::string, double>>& values) override;
  void paths(const Key& key, std::vector<PathValues>& paths, Values values) override;

 private:
  void entry(const std::string& key, const std::string& word);

  YAML::Emitter& out_;
};

/// A file that `describe_all` describes, as YAML with every default.
std::string yaml_of(const std::function<void(Description&)>& describe_all);

}  // namespace mote
