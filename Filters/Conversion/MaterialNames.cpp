#include "Conversion/MaterialNames.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace strata::conversion
{
namespace
{
std::string lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool startsWith(const std::string& text, const std::string& prefix)
{
  return text.size() > prefix.size() && text.compare(0, prefix.size(), prefix) == 0;
}

bool endsWith(const std::string& text, const std::string& suffix)
{
  return text.size() > suffix.size() && text.compare(text.size() - suffix.size(), suffix.size(), suffix) == 0;
}

/// Fractions of something else than volume.
bool isOtherFraction(const std::string& name)
{
  return endsWith(name, "mass_fraction") || endsWith(name, "mole_fraction") || name == "mass_fraction" ||
         name == "mole_fraction" || name == "volume_fraction";
}
}

std::optional<std::string> materialOfFractions(const std::string& arrayName)
{
  const std::string name = lower(arrayName);
  const std::string numbered = "material volume fraction - ";
  if (startsWith(name, numbered))
  {
    return "Material " + arrayName.substr(numbered.size());
  }
  for (const std::string prefix : { "volume_fraction_", "volume fraction for ", "vf_", "alpha." })
  {
    if (startsWith(name, prefix))
    {
      return arrayName.substr(prefix.size());
    }
  }
  if (isOtherFraction(name))
  {
    return std::nullopt;
  }
  for (const std::string suffix : { " volume fraction", "_volume_fraction", "_vf", "_fraction" })
  {
    if (endsWith(name, suffix))
    {
      return arrayName.substr(0, arrayName.size() - suffix.size());
    }
  }
  return std::nullopt;
}

bool isEmptySpace(const std::string& materialName)
{
  const std::string name = lower(materialName);
  return name == "empty" || name == "void" || name == "vacuum" || name == "outside";
}

bool isMaterialIdName(const std::string& arrayName)
{
  std::string name = lower(arrayName);
  name.erase(std::remove(name.begin(), name.end(), '_'), name.end());
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  return name == "material" || name == "materialid" || name == "materialids";
}
}
