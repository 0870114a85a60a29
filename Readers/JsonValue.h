#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// A value in a JSON file that knows where it stands, so that what is wrong with it can be said.
class JsonValue
{
public:
  JsonValue(const nlohmann::ordered_json& value, std::string where) : value_(&value), where_(std::move(where)) {}

  /// "impact.strata: steps[2].grid"
  const std::string& where() const { return where_; }

  bool isText() const { return value_->is_string(); }
  bool has(const std::string& key) const { return value_->is_object() && value_->contains(key); }

  // Each of these throws strata::InvalidInput where the value is of another type, or the key missing.
  std::string text() const;
  double number() const;
  bool boolean() const;
  JsonValue at(const std::string& key) const;
  std::vector<std::string> keys() const;
  std::vector<JsonValue> elements() const;
  /// Throws unless the value is an object with none but these keys.
  void expectKeys(const std::vector<std::string>& known) const;

private:
  [[noreturn]] void fail(const std::string& what) const;

  const nlohmann::ordered_json* value_;
  std::string where_;
};

/// A JSON file. The values handed out live as long as the document.
class JsonDocument
{
public:
  /// Throws strata::InvalidInput, with line and column where the text is no JSON.
  explicit JsonDocument(const std::string& path);

  JsonValue root() const;

private:
  std::string name_;
  nlohmann::ordered_json json_;
};
