#include "JsonValue.h"

#include "Conversion/ValueConversion.h"

#include "Model/Errors.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <sstream>

using strata::InvalidInput;

void JsonValue::fail(const std::string& what) const
{
  throw InvalidInput(where_ + " " + what);
}

std::string JsonValue::text() const
{
  if (!value_->is_string())
  {
    this->fail("must be a text");
  }
  return value_->get<std::string>();
}

double JsonValue::number() const
{
  if (!value_->is_number())
  {
    this->fail("must be a number");
  }
  return value_->get<double>();
}

bool JsonValue::boolean() const
{
  if (!value_->is_boolean())
  {
    this->fail("must be true or false");
  }
  return value_->get<bool>();
}

JsonValue JsonValue::at(const std::string& key) const
{
  if (!value_->is_object())
  {
    this->fail("must be an object {...}");
  }
  const auto found = value_->find(key);
  if (found == value_->end())
  {
    this->fail("lacks the key '" + key + "'");
  }
  return JsonValue(*found, where_ + (where_.back() == ':' ? " " : ".") + key);
}

std::vector<std::string> JsonValue::keys() const
{
  if (!value_->is_object())
  {
    this->fail("must be an object {...}");
  }
  std::vector<std::string> result;
  for (auto entry = value_->begin(); entry != value_->end(); ++entry)
  {
    result.push_back(entry.key());
  }
  return result;
}

std::vector<JsonValue> JsonValue::elements() const
{
  if (!value_->is_array())
  {
    this->fail("must be a list [...]");
  }
  std::vector<JsonValue> result;
  for (const auto& element : *value_)
  {
    result.emplace_back(element, where_ + "[" + std::to_string(result.size()) + "]");
  }
  return result;
}

void JsonValue::expectKeys(const std::vector<std::string>& known) const
{
  for (const std::string& key : this->keys())
  {
    if (std::find(known.begin(), known.end(), key) == known.end())
    {
      this->fail("has the unknown key '" + key + "'; known: " + strata::conversion::listed(known));
    }
  }
}

JsonDocument::JsonDocument(const std::string& path) : name_(vtksys::SystemTools::GetFilenameName(path))
{
  vtksys::ifstream file(path.c_str(), std::ios::binary);
  if (!file)
  {
    throw InvalidInput("The file '" + path + "' can't be opened");
  }
  std::ostringstream buffer;
  buffer << file.rdbuf();
  const std::string text = buffer.str();
  try
  {
    json_ = nlohmann::ordered_json::parse(text);
  }
  catch (const nlohmann::json::parse_error& error)
  {
    const std::size_t end = std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    const std::size_t lineStart = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
    const std::size_t column = end - (lineStart == std::string::npos ? 0 : lineStart + 1) + 1;
    throw InvalidInput(
      name_ + ": line " + std::to_string(line) + ", column " + std::to_string(column) + ": this is no JSON");
  }
}

JsonValue JsonDocument::root() const
{
  return JsonValue(json_, name_ + ":");
}
