#include "CategoryColors.h"

#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace
{
/// For what is no single category: cells with several materials.
constexpr std::array<double, 3> mixed{ 0.85, 0.75, 0.25 };
constexpr std::array<double, 3> nearlyWhite{ 0.93, 0.93, 0.93 };
constexpr std::array<std::array<double, 3>, 12> palette{ { { 0.90, 0.42, 0.18 }, { 0.35, 0.60, 0.83 },
  { 0.47, 0.72, 0.42 }, { 0.55, 0.85, 0.80 }, { 0.62, 0.44, 0.75 }, { 0.20, 0.63, 0.62 }, { 0.86, 0.45, 0.63 },
  { 0.55, 0.40, 0.29 }, { 0.16, 0.36, 0.62 }, { 0.70, 0.20, 0.22 }, { 0.66, 0.79, 0.90 }, { 0.37, 0.49, 0.16 } } };

std::array<double, 3> colorOf(int category, bool plain)
{
  if (category < 0 || plain)
  {
    return plain ? nearlyWhite : mixed;
  }
  const std::size_t count = palette.size();
  std::array<double, 3> color = palette[static_cast<std::size_t>(category) % count];
  // Further rounds are paler.
  const double pale = 0.3 * static_cast<double>((static_cast<std::size_t>(category) / count) % 3);
  for (double& part : color)
  {
    part += pale * (1.0 - part);
  }
  return color;
}

Categories categoriesOf(vtkSMProxy* colorMap)
{
  Categories result;
  const vtkSMPropertyHelper annotations(colorMap, "Annotations");
  const vtkSMPropertyHelper colors(colorMap, "IndexedColors");
  const unsigned int count = std::min(annotations.GetNumberOfElements() / 2, colors.GetNumberOfElements() / 3);
  if (vtkSMPropertyHelper(colorMap, "IndexedLookup").GetAsInt() == 0)
  {
    return result;
  }
  for (unsigned int i = 0; i < count; ++i)
  {
    result[std::atoi(annotations.GetAsString(2 * i))] = { annotations.GetAsString(2 * i + 1),
      { colors.GetAsDouble(3 * i), colors.GetAsDouble(3 * i + 1), colors.GetAsDouble(3 * i + 2) } };
  }
  return result;
}
}

Categories readCategories(const std::string& legend)
{
  Categories result;
  std::istringstream lines(legend);
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream columns(line);
    std::string number;
    std::string name;
    std::string look;
    if (std::getline(columns, number, '\t') && std::getline(columns, name, '\t'))
    {
      std::getline(columns, look);
      const int category = std::atoi(number.c_str());
      result[category] = { name, colorOf(category, look == "plain") };
    }
  }
  return result;
}

bool addCategories(vtkSMProxy* colorMap, const Categories& categories)
{
  Categories all = categoriesOf(colorMap);
  for (const auto& [number, category] : categories)
  {
    if (all.emplace(number, category).first->second.name != category.name)
    {
      return false;
    }
  }
  vtkSMPropertyHelper(colorMap, "IndexedLookup").Set(1);
  vtkSMPropertyHelper annotations(colorMap, "Annotations");
  vtkSMPropertyHelper colors(colorMap, "IndexedColors");
  annotations.SetNumberOfElements(2 * static_cast<unsigned int>(all.size()));
  colors.SetNumberOfElements(3 * static_cast<unsigned int>(all.size()));
  unsigned int i = 0;
  for (const auto& [number, category] : all)
  {
    annotations.Set(2 * i, std::to_string(number).c_str());
    annotations.Set(2 * i + 1, category.name.c_str());
    for (unsigned int part = 0; part < 3; ++part)
    {
      colors.Set(3 * i + part, category.color[part]);
    }
    ++i;
  }
  colorMap->UpdateVTKObjects();
  return true;
}
