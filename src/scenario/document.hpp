#pragma once

#include <string>
#include <utility>
#include <vector>

namespace mote {

/// Where a value was written: a place in a file, or a `--set` of the command line.
struct Origin {
  std::string text;  ///< `file.yaml:12:5`, or `--set key=value`
};

/// A value of a scenario file with its origin: a word, a list or a section of keys in file order.
struct Value {
  enum class Kind { empty, word, list, section };
  struct Entry;

  Kind kind = Kind::empty;
  std::string word;
  Origin origin;
  std::vector<Value> list;
  std::vector<Entry> entries;
  /// The word that stood here before `--set` added a key to it (`operator: sph.gauss`).
  std::string short_form;

  const Value* find(const std::string& key) const;
};

struct Value::Entry {
  std::string key;
  Origin origin;  ///< of the key
  Value value;
};

/// A value as YAML in one line, as it may stand in a list; and as a file's text.
std::string flow_text(const Value& value);
std::string block_text(const Value& value);

/// The keys of a dotted path.
std::vector<std::string> keys_of(const std::string& path);

/// A scenario file as strict YAML: yaml-cpp parses it, and duplicate keys, several documents and
/// keys that are not words are refused here. Throws LocatedError.
class Document {
 public:
  static Document from_file(const std::string& path);

  /// Puts the value of `assignment`, `key.path=value` with a YAML value, in place of what the
  /// file says.
  void set(const std::string& assignment);

  /// The same with a value that is there already and its keys from the top, which may have dots in
  /// them; `origin` says where the keys were written.
  void set(const std::vector<std::string>& keys, Value value, const Origin& origin);

  /// A YAML value that was written elsewhere, such as on the command line.
  static Value parsed(const std::string& text, const Origin& origin);

  const Value& root() const { return root_; }

  /// The value under these keys from the top; null if there is none.
  const Value* find(const std::vector<std::string>& keys) const;

  /// Where the value of a dotted key path was written, or the nearest section around it; a number
  /// in the path is an item of a list, from 0.
  std::string locate(const std::string& path) const;

 private:
  Value root_;
};

}  // namespace mote
