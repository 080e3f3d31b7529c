#pragma once

#include <deque>
#include <string>
#include <vector>

#include "mote/options/description.hpp"
#include "mote/scenario/document.hpp"
#include "mote/scenario/expression.hpp"

namespace mote {

/// Reads described values out of a document and refuses, with the place, everything that the
/// descriptions do not know: unknown keys, wrong types, numbers that are not finite, values out of
/// range, missing keys. Throws LocatedError.
class Reader final : public Description {
 public:
  /// `what` names the document in messages.
  explicit Reader(const Document& document, const std::string& what = "the scenario");

  /// Refuses what is left over at the top level; call it after the last description.
  void finish();

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
  /// A section that is being read.
  struct Level {
    const Value* value;  ///< null for a section that the file does not have
    std::string place;
    std::string name;                     ///< for messages: `section 'model'`, or `the scenario`
    std::vector<std::string> known = {};  ///< keys described so far
    std::vector<std::string> missing = {};
    std::deque<std::string> short_form = {};  ///< words of `sph.gauss` not yet taken
    bool has_variant = false;                 ///< whether a short form can have a meaning
  };

  const Value* take(const Key& key);
  double read_number(const Value& value, const std::string& name);
  std::string read_expression(const Value& value, const std::string& name) const;
  void read_section(const Value* given, const std::string& name, const std::function<void()>& body);
  void close(const Level& level) const;
  void refuse_unknown_keys(const Level& level) const;
  void refuse_misspelt(const Level& level, const std::string& key) const;
  [[noreturn]] void refuse_missing(const Level& level, const std::string& key) const;

  std::vector<Level> levels_;
  Constants constants_;
};

}  // namespace mote
