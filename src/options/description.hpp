#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mote {

/// One key of a section: its word in the file and one line that says what it means.
struct Key {
  std::string name;
  std::string summary;
  bool required = false;
};

/// The numbers that a key accepts; an open lower end excludes `lower` itself.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool open = false;

  bool contains(double value) const {
    return (open ? value > lower : value >= lower) && value <= upper;
  }
};

inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range not_negative{0};
constexpr Range at_least(double lower) { return {lower}; }

/// One of the words that a key accepts.
struct Choice {
  std::string name;
  std::string summary;
};
using Choices = std::vector<Choice>;

/// A dotted key path of a file, and values that it can have, each as YAML in one line.
struct PathValues {
  std::string path;
  std::vector<std::string> values;
};
enum class Values { one, several };

/// How a part of mote says, once, which options it takes. A scenario file is read, written with
/// every default filled in, and turned into a JSON Schema by three implementations of this
/// interface, so the three cannot disagree.
///
/// The value passed in holds the default; a key that is not required may be absent.
class Description {
 public:
  virtual ~Description() = default;

  /// Whether all variants of a file are wanted, as for a schema, and not those of one file.
  virtual bool wants_all_variants() const { return false; }

  virtual void number(const Key& key, double& value, Range range = {}) = 0;
  /// A number that has no default: absent stays absent.
  virtual void number(const Key& key, std::optional<double>& value, Range range = {}) = 0;
  virtual void count(const Key& key, std::int64_t& value, Range range = {}) = 0;
  virtual void count(const Key& key, std::optional<std::int64_t>& value, Range range = {}) = 0;
  virtual void flag(const Key& key, bool& value) = 0;
  virtual void text(const Key& key, std::string& value) = 0;
  virtual void numbers(const Key& key, std::vector<double>& values) = 0;
  /// A formula in x, y, z, r and t, or in some of these letters alone, in pi and the scenario's
  /// constants; kept as text.
  virtual void expression(const Key& key, std::string& value,
                          std::string_view variables = "xyzrt") = 0;
  /// An empty word is none: absent stays absent.
  virtual void choice(const Key& key, std::string& value, const Choices& choices) = 0;
  /// A word that decides which further keys the section has; `rest` describes those.
  virtual void variant(const Key& key, std::string& value, const Choices& choices,
                       const std::function<void(const std::string&)>& rest) = 0;
  /// A nested section; `body` describes its keys on this same object.
  virtual void section(const Key& key, const std::function<void()>& body) = 0;
  /// A list of sections, which may hold any number of them; `body` describes the keys of the k-th
  /// on this same object, and has to make room for it.
  virtual void list(const Key& key, std::size_t& count,
                    const std::function<void(std::size_t k)>& body) = 0;
  /// A list of formulas, and of some of the words.
  virtual void expressions(const Key& key, std::vector<std::string>& values) = 0;
  virtual void words(const Key& key, std::vector<std::string>& values, const Choices& choices) = 0;
  /// Named numbers that later expressions may use.
  virtual void constants(const Key& key, std::vector<std::pair<std::string, double>>& values) = 0;
  /// Key paths of the file itself, each with one value of any kind, or with a list of several.
  virtual void paths(const Key& key, std::vector<PathValues>& paths, Values values) = 0;
};

/// A list of sections of one type, in a vector that grows as they are described.
template <class Item, class Body>
void describe_list(Description& description, const Key& key, std::vector<Item>& items, Body body) {
  std::size_t count = items.size();
  description.list(key, count, [&](std::size_t k) {
    if (items.size() <= k) items.resize(k + 1);
    body(items[k]);
  });
}

/// One value of an enumeration with its word in a scenario file.
template <class Enumeration>
struct Word {
  Enumeration value;
  std::string_view name;
  std::string_view summary;
};

/// Describes an enumeration that has no default by its table of words: absent stays absent.
template <class Enumeration, std::size_t N>
void describe_words(Description& description, const Key& key, std::optional<Enumeration>& value,
                    const Word<Enumeration> (&words)[N]) {
  Choices choices;
  std::string name;
  for (const auto& word : words) {
    choices.push_back({std::string(word.name), std::string(word.summary)});
    if (word.value == value) name = word.name;
  }
  description.choice(key, name, choices);
  for (const auto& word : words)
    if (word.name == name) value = word.value;
}

/// Describes an enumeration by its table of words.
template <class Enumeration, std::size_t N>
void describe_words(Description& description, const Key& key, Enumeration& value,
                    const Word<Enumeration> (&words)[N]) {
  std::optional<Enumeration> chosen = value;
  describe_words(description, key, chosen, words);
  value = *chosen;
}

}  // namespace mote
