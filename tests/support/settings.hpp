#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "mote/options/description.hpp"

namespace mote::test {

/// Gives options the numbers and words of a table, as a scenario file would. A key that nobody
/// took is found by `unused`.
class Settings final : public Description {
 public:
  Settings& with(const std::string& key, double value) {
    numbers_[key] = value;
    return *this;
  }
  Settings& with(const std::string& key, const std::string& word) {
    words_[key] = word;
    return *this;
  }

  /// Applies the settings to `part` and throws std::logic_error if it did not take all of them.
  template <class Part>
  void apply_to(Part& part) {
    part.describe(*this);
    if (!numbers_.empty()) throw std::logic_error("no option " + numbers_.begin()->first);
    if (!words_.empty()) throw std::logic_error("no option " + words_.begin()->first);
  }

  void number(const Key& key, double& value, Range range) override {
    if (const auto node = numbers_.extract(key.name)) {
      if (!range.contains(node.mapped())) throw std::logic_error(key.name + " is out of range");
      value = node.mapped();
    }
  }
  void choice(const Key& key, std::string& value, const Choices&) override {
    if (auto node = words_.extract(key.name)) value = node.mapped();
  }

  void number(const Key&, std::optional<double>&, Range) override {}
  void count(const Key&, std::int64_t&, Range) override {}
  void count(const Key&, std::optional<std::int64_t>&, Range) override {}
  void flag(const Key&, bool&) override {}
  void text(const Key&, std::string&) override {}
  void numbers(const Key&, std::vector<double>&) override {}
  void expression(const Key&, std::string&, std::string_view) override {}
  void variant(const Key&, std::string&, const Choices&,
               const std::function<void(const std::string&)>&) override {}
  void section(const Key&, const std::function<void()>& body) override { body(); }
  void list(const Key&, std::size_t&, const std::function<void(std::size_t)>&) override {}
  void expressions(const Key&, std::vector<std::string>&) override {}
  void words(const Key&, std::vector<std::string>&, const Choices&) override {}
  void constants(const Key&, std::vector<std::pair<std::string, double>>&) override {}
  void paths(const Key&, std::vector<PathValues>&, Values) override {}

 private:
  std::map<std::string, double> numbers_;
  std::map<std::string, std::string> words_;
};

}  // namespace mote::test
