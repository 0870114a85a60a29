#include "Select/Criterion.h"

#include <algorithm>

namespace strata
{
bool Criterion::exceedsBounds(const Hierarchy& hierarchy, CellId cell, double scale) const
{
  if (static_cast<double>(hierarchy.interfaceError(cell)) > bounds_.interfaceError * scale)
  {
    return true;
  }
  for (std::size_t f = 0; f < bounds_.fieldErrors.size(); ++f)
  {
    if (static_cast<double>(hierarchy.fieldError(cell, f)) > bounds_.fieldErrors[f] * scale)
    {
      return true;
    }
  }
  return false;
}

bool Criterion::mustSplit(const Hierarchy& hierarchy, CellId cell, double scale) const
{
  return exceedsBounds(hierarchy, cell, scale) && hierarchy.cell(cell).level < maximumLevel_;
}

double Criterion::sufficientScale(const Hierarchy& hierarchy, CellId cell) const
{
  double scale = static_cast<double>(hierarchy.interfaceError(cell)) / bounds_.interfaceError;
  for (std::size_t f = 0; f < bounds_.fieldErrors.size(); ++f)
  {
    scale = std::max(scale, static_cast<double>(hierarchy.fieldError(cell, f)) / bounds_.fieldErrors[f]);
  }
  return scale;
}
}
