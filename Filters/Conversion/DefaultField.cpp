#include "Conversion/DefaultField.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

namespace strata::conversion
{
namespace
{
/// A quantity by the words that name it, and its place among the quantities.
struct Quantity
{
  int order;
  std::array<const char*, 4> words;
};

constexpr int sharedDensityOrder = 4;
constexpr int otherOrder = 6;
constexpr std::array<Quantity, 8> quantities = { {
  { 0, { "density", "densities", "rho", "dens" } },
  { lastDefaultOrder, { "mass", "masses", "level", "levels" } },
  { lastDefaultOrder, { "id", "ids", "gamma", "processor" } },
  { 1, { "pressure", "p", "pres", "press" } },
  { 2, { "temperature", "t", "temp", "temperatures" } },
  { 3, { "energy", "e", "energies", "enthalpy" } },
  { 5, { "velocity", "u", "speed", "velocities" } },
  { 5, { "momentum", "vel", "displacement", "stress" } },
} };

/// The words of a name, in lower case, without what stands in brackets: units.
std::set<std::string> wordsOf(const std::string& name)
{
  std::set<std::string> words;
  std::string word;
  int brackets = 0;
  for (const char character : name + " ")
  {
    const auto c = static_cast<unsigned char>(character);
    brackets += (c == '(' || c == '[') ? 1 : 0;
    if (brackets == 0 && std::isalnum(c))
    {
      word += static_cast<char>(std::tolower(c));
    }
    else
    {
      words.insert(word);
      word.clear();
    }
    brackets -= (brackets > 0 && (c == ')' || c == ']')) ? 1 : 0;
  }
  words.erase("");
  return words;
}
}

int defaultOrder(const FieldCandidate& field)
{
  const std::set<std::string> words = wordsOf(field.name);
  const auto named = std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& quantity) {
    return std::any_of(
      quantity.words.begin(), quantity.words.end(), [&](const char* word) { return words.count(word) > 0; });
  });
  const int order = named == quantities.end() ? otherOrder : named->order;
  return order == 0 && field.mixedMaterials && !field.ownArrays ? sharedDensityOrder : order;
}
}
