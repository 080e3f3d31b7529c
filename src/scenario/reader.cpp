#include "mote/scenario/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "mote/scenario/located_error.hpp"
#include "mote/scenario/suggestion.hpp"

namespace mote {
namespace {

[[noreturn]] void refuse(const Value& value, const std::string& message) {
  throw LocatedError(value.origin.text, message);
}

const Value& require(const Value& value, Value::Kind kind, const std::string& what) {
  if (value.kind == Value::Kind::empty) refuse(value, what + ", and nothing is given");
  if (value.kind != kind) refuse(value, what);
  return value;
}

/// The words `inf`, `.nan`, `0x10` or `010`: numbers for YAML, mistakes for us.
bool is_questionable_number(const std::string& word) {
  const auto digits = word.substr(word.find_first_not_of("+-") == 1 ? 1 : 0);
  if (digits.size() > 1 && digits[0] == '0' && std::isalnum(static_cast<unsigned char>(digits[1])))
    return digits[1] != 'e' && digits[1] != 'E';
  std::string lower = digits;
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower == "nan" || lower == ".nan" || lower == "inf" || lower == ".inf" ||
         lower == "infinity";
}

std::string range_in_words(const Range& range) {
  const bool has_lower = std::isfinite(range.lower), has_upper = std::isfinite(range.upper);
  if (has_lower && has_upper && range.open)
    return fmt::format("must be greater than {} and at most {}", range.lower, range.upper);
  if (has_lower && has_upper) return fmt::format("must be from {} to {}", range.lower, range.upper);
  if (has_upper) return fmt::format("must be at most {}", range.upper);
  if (range.open) return fmt::format("must be greater than {}", range.lower);
  return fmt::format("must be at least {}", range.lower);
}

std::vector<std::string> names_of(const Choices& choices) {
  std::vector<std::string> names;
  for (const Choice& choice : choices) names.push_back(choice.name);
  return names;
}

void check_choice(const Value& value, const std::string& word, const std::string& key,
                  const Choices& choices) {
  const auto names = names_of(choices);
  if (std::ranges::find(names, word) != names.end()) return;
  refuse(value, fmt::format("unknown {} '{}'{}; there are: {}", key, word, suggestion(word, names),
                            fmt::join(names, ", ")));
}

}  // namespace

Reader::Reader(const Document& document, const std::string& what) {
  levels_.push_back({&document.root(), document.root().origin.text, what});
}

void Reader::finish() { close(levels_.front()); }

const Value* Reader::take(const Key& key) {
  Level& level = levels_.back();
  level.known.push_back(key.name);
  const Value* value = level.value != nullptr ? level.value->find(key.name) : nullptr;
  if (value == nullptr && key.required) level.missing.push_back(key.name);
  return value;
}

/// Misspelt keys are told before missing ones: the one is usually the cause of the other.
void Reader::close(const Level& level) const {
  refuse_unknown_keys(level);
  if (!level.missing.empty()) refuse_missing(level, level.missing.front());
  if (!level.short_form.empty())
    throw LocatedError(level.place, fmt::format("'{}' has nothing to say here in {}",
                                                level.short_form.front(), level.name));
}

void Reader::refuse_unknown_keys(const Level& level) const {
  if (level.value == nullptr) return;
  for (const auto& entry : level.value->entries)
    if (std::ranges::find(level.known, entry.key) == level.known.end())
      throw LocatedError(entry.origin.text,
                         fmt::format("unknown key '{}'{} in {}", entry.key,
                                     suggestion(entry.key, level.known), level.name));
}

/// Refuses a key that is not known so far and looks like `key`, which is not given.
void Reader::refuse_misspelt(const Level& level, const std::string& key) const {
  if (level.value == nullptr) return;
  for (const auto& entry : level.value->entries) {
    const bool known = std::ranges::find(level.known, entry.key) != level.known.end();
    const std::string hint = suggestion(entry.key, {key});
    if (!known && !hint.empty())
      throw LocatedError(entry.origin.text,
                         fmt::format("unknown key '{}'{} in {}", entry.key, hint, level.name));
  }
}

void Reader::refuse_missing(const Level& level, const std::string& key) const {
  refuse_misspelt(level, key);
  throw LocatedError(level.place, fmt::format("{} lacks the key '{}'", level.name, key));
}

double Reader::read_number(const Value& value, const std::string& name) {
  const std::string& word =
      require(value, Value::Kind::word, fmt::format("'{}' must be a number", name)).word;
  double number = 0;
  if (word.empty()) refuse(value, fmt::format("'{}' must be a number, and is empty", name));
  if (is_questionable_number(word))
    refuse(value, fmt::format("'{}' must be a finite decimal number, not '{}'", name, word));
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool whole = end == word.data() + word.size();
  if (whole && error == std::errc::result_out_of_range)
    refuse(value, fmt::format("'{}' must be finite: {} is out of range", name, word));
  if (error != std::errc{} || !whole) {
    try {
      const Expression formula(word, constants_);
      if (formula.depends_on_place())
        refuse(value, fmt::format("'{}' is one number; it cannot depend on x, y, z, r or t", name));
      number = formula({});
    } catch (const ExpressionError& problem) {
      refuse(value, fmt::format("'{}' must be a number or an expression: {} in '{}'", name,
                                problem.what(), word));
    }
  }
  if (!std::isfinite(number))
    refuse(value, fmt::format("'{}' must be finite, and '{}' is {}", name, word,
                              std::isnan(number) ? "not a number" : "infinite"));
  return number;
}

void Reader::number(const Key& key, double& value, Range range) {
  const Value* given = take(key);
  if (given == nullptr) return;
  value = read_number(*given, key.name);
  if (!range.contains(value))
    refuse(*given, fmt::format("'{}' {}, and is {}", key.name, range_in_words(range), value));
}

void Reader::number(const Key& key, std::optional<double>& value, Range range) {
  double read = std::nan("");
  number(key, read, range);
  if (!std::isnan(read)) value = read;
}

void Reader::count(const Key& key, std::int64_t& value, Range range) {
  auto read = static_cast<double>(value);
  number(key, read, range);
  if (read != std::floor(read) || std::abs(read) > 9e15)
    refuse(*levels_.back().value->find(key.name),
           fmt::format("'{}' must be a whole number below 9e15, and is {}", key.name, read));
  value = static_cast<std::int64_t>(read);
}

void Reader::count(const Key& key, std::optional<std::int64_t>& value, Range range) {
  const Level& level = levels_.back();
  const bool given = level.value != nullptr && level.value->find(key.name) != nullptr;
  std::int64_t read = 0;
  if (given)
    count(key, read, range);
  else
    take(key);
  if (given) value = read;
}

void Reader::flag(const Key& key, bool& value) {
  const Value* given = take(key);
  if (given == nullptr) return;
  const std::string what = fmt::format("'{}' must be true or false", key.name);
  const std::string& word = require(*given, Value::Kind::word, what).word;
  if (word != "true" && word != "false") refuse(*given, what);
  value = word == "true";
}

void Reader::text(const Key& key, std::string& value) {
  const Value* given = take(key);
  if (given == nullptr) return;
  const std::string what = fmt::format("'{}' must be a text", key.name);
  value = require(*given, Value::Kind::word, what).word;
  if (value.empty()) refuse(*given, fmt::format("'{}' must not be empty", key.name));
}

void Reader::numbers(const Key& key, std::vector<double>& values) {
  const Value* given = take(key);
  if (given == nullptr) return;
  require(*given, Value::Kind::list,
          fmt::format("'{}' must be a list of numbers, as in [1]", key.name));
  values.clear();
  for (const Value& item : given->list) values.push_back(read_number(item, key.name));
}

std::string Reader::read_expression(const Value& given, const std::string& name) const {
  const bool unquoted = given.kind == Value::Kind::section || given.kind == Value::Kind::list;
  const std::string& text = require(given, Value::Kind::word,
                                    fmt::format("'{}' must be a number or an expression{}", name,
                                                unquoted ? ", which goes in quotes" : ""))
                                .word;
  if (is_questionable_number(text))
    refuse(given, fmt::format("'{}' must be a finite decimal number, not '{}'", name, text));
  if (text.empty()) refuse(given, fmt::format("'{}' must not be empty", name));
  double number = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
  if (parsed.ec == std::errc::result_out_of_range)
    refuse(given, fmt::format("'{}' must be finite: {} is out of range", name, text));
  try {
    Expression(text, constants_);
  } catch (const ExpressionError& problem) {
    const std::string place =
        problem.position() < 0 ? "in" : fmt::format("at character {} of", problem.position() + 1);
    refuse(given, fmt::format("'{}': {} {} '{}'", name, problem.what(), place, text));
  }
  return text;
}

void Reader::expression(const Key& key, std::string& value, std::string_view variables) {
  const Value* given = take(key);
  if (given == nullptr) return;
  value = read_expression(*given, key.name);
  const Expression formula(value, constants_);
  for (const char variable : std::string_view("xyzrt"))
    if (variables.find(variable) == std::string_view::npos && formula.uses({variable}))
      refuse(*given, fmt::format("'{}' is a formula in {} alone, and this names {}", key.name,
                                 fmt::join(variables, ", "), variable));
}

void Reader::expressions(const Key& key, std::vector<std::string>& values) {
  const Value* given = take(key);
  if (given == nullptr) return;
  require(*given, Value::Kind::list, fmt::format("'{}' must be a list of expressions", key.name));
  values.clear();
  for (const Value& item : given->list) values.push_back(read_expression(item, key.name));
}

void Reader::words(const Key& key, std::vector<std::string>& values, const Choices& choices) {
  const Value* given = take(key);
  if (given == nullptr) return;
  const std::string what = fmt::format("'{}' must be a list of words, as in [{}]", key.name,
                                       choices.empty() ? "" : choices.front().name);
  require(*given, Value::Kind::list, what);
  if (given->list.empty()) refuse(*given, fmt::format("'{}' must not be empty", key.name));
  values.clear();
  for (const Value& item : given->list) {
    const std::string& word = require(item, Value::Kind::word, what).word;
    check_choice(item, word, fmt::format("word in '{}':", key.name), choices);
    values.push_back(word);
  }
}

void Reader::choice(const Key& key, std::string& value, const Choices& choices) {
  const Value* given = take(key);
  if (given == nullptr) return;
  const std::string what = fmt::format("'{}' must be a word", key.name);
  const std::string& word = require(*given, Value::Kind::word, what).word;
  check_choice(*given, word, key.name, choices);
  value = word;
}

void Reader::variant(const Key& key, std::string& value, const Choices& choices,
                     const std::function<void(const std::string&)>& rest) {
  Level& level = levels_.back();
  level.has_variant = true;
  const bool given = level.value != nullptr && level.value->find(key.name) != nullptr;
  if (!given && !level.short_form.empty()) {
    take({key.name, key.summary});
    value = level.short_form.front();
    level.short_form.pop_front();
    check_choice(*level.value, value, key.name, choices);
  } else {
    if (!given && key.required) {
      refuse_misspelt(level, key.name);
      throw LocatedError(level.place,
                         fmt::format("{} lacks the key '{}'; there are: {}", level.name, key.name,
                                     fmt::join(names_of(choices), ", ")));
    }
    if (given && !level.short_form.empty()) level.short_form.pop_front();
    choice(key, value, choices);
  }
  rest(value);
}

void Reader::section(const Key& key, const std::function<void()>& body) {
  const Value* given = take(key);
  if (given == nullptr && key.required) refuse_missing(levels_.back(), key.name);
  read_section(given, key.name, body);
}

void Reader::list(const Key& key, std::size_t& count,
                  const std::function<void(std::size_t)>& body) {
  const Value* given = take(key);
  if (given == nullptr) {
    if (key.required) refuse_missing(levels_.back(), key.name);
    return;
  }
  require(*given, Value::Kind::list, fmt::format("'{}' must be a list", key.name));
  if (given->list.empty() && key.required)
    refuse(*given, fmt::format("'{}' must not be empty", key.name));
  count = given->list.size();
  for (std::size_t k = 0; k < count; ++k) read_section(&given->list[k], key.name, [&] { body(k); });
}

/// Reads a section, also one that the file does not have (null).
void Reader::read_section(const Value* given, const std::string& name,
                          const std::function<void()>& body) {
  Level level{given, given != nullptr ? given->origin.text : levels_.back().place,
              fmt::format("section '{}'", name)};
  if (given != nullptr) {
    if (given->kind == Value::Kind::list || given->kind == Value::Kind::empty)
      refuse(*given, fmt::format("'{}' must be a section of keys", name));
    std::istringstream words(given->kind == Value::Kind::word ? given->word : given->short_form);
    for (std::string word; std::getline(words, word, '.');) level.short_form.push_back(word);
  }
  levels_.push_back(std::move(level));
  body();
  if (given != nullptr && given->kind == Value::Kind::word && !levels_.back().has_variant)
    refuse(*given, fmt::format("'{}' must be a section of keys", name));
  close(levels_.back());
  levels_.pop_back();
}

void Reader::constants(const Key& key, std::vector<std::pair<std::string, double>>& values) {
  const Value* given = take(key);
  if (given == nullptr) return refuse_misspelt(levels_.back(), key.name);
  require(*given, Value::Kind::section,
          fmt::format("'{}' must be a section of names and numbers", key.name));
  for (const auto& entry : given->entries) {
    const bool word =
        !entry.key.empty() && !std::isdigit(static_cast<unsigned char>(entry.key[0])) &&
        std::ranges::all_of(entry.key, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    if (!word || Expression::is_reserved(entry.key))
      throw LocatedError(entry.origin.text, fmt::format("'{}' cannot name a constant", entry.key));
    values.emplace_back(entry.key, read_number(entry.value, entry.key));
    constants_[entry.key] = values.back().second;
  }
}

void Reader::paths(const Key& key, std::vector<PathValues>& paths, Values values) {
  const Value* given = take(key);
  if (given == nullptr) return;
  const bool several = values == Values::several;
  require(*given, Value::Kind::section,
          fmt::format("'{}' must be a section of key paths, each with {}", key.name,
                      several ? "a list of values, as in 'particles.count: [41, 81]'"
                              : "a value, as in 'particles.count: 41'"));
  paths.clear();
  for (const auto& entry : given->entries) {
    const std::string what = fmt::format("'{}' must have {}", entry.key,
                                         several ? "a list of values, as in [a, b]" : "a value");
    PathValues& path = paths.emplace_back(PathValues{entry.key, {}});
    if (several) {
      for (const Value& item : require(entry.value, Value::Kind::list, what).list)
        path.values.push_back(flow_text(item));
      if (path.values.empty()) refuse(entry.value, fmt::format("'{}' has no values", entry.key));
    } else {
      if (entry.value.kind == Value::Kind::empty) refuse(entry.value, what);
      path.values.push_back(flow_text(entry.value));
    }
  }
}

}  // namespace mote
