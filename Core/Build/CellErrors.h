#pragma once

#include "Build/CellElements.h"
#include "Model/Hierarchy.h"

namespace strata
{
/// The smallest float that is not below a number.
float roundedUp(double value);

/// A cell's own errors at points (design 2), from the values at its corners and its elements alone.
struct CellErrors
{
  float interfaceError = 0.0f;
  std::vector<float> fieldErrors;
};

/// Errors of a cell. Field errors: largest |native - represented| over its samples and the materials they count
/// for. Interface error: largest distance of an interface vertex to the plane that stands for its interface,
/// infinite where the cell has no such plane.
CellErrors cellErrors(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric,
  const CellElements& elements, const NativeData& native, const InterfaceElements& interfaces);
}
