#pragma once

#include "Model/CellRows.h"
#include "Model/ErrorBounds.h"
#include "Model/Hierarchy.h"

namespace strata
{
/// The largest error of a field over the samples of a group, divided by its bound.
double relativeError(
  const Hierarchy& values, const HierarchyCell& cell, const CellRows::Samples& samples, const ErrorBounds& bounds);

/// The largest distance of the group's vertices to the plane that stands for their interface, by its bound.
double relativeError(const Hierarchy& values, const HierarchyCell& cell, const CellRows& rows,
  const CellRows::InterfaceVertices& vertices, const ErrorBounds& bounds);

/// The largest of all of a cell's errors, each divided by its bound.
double relativeError(
  const Hierarchy& values, const HierarchyCell& cell, const CellRows& rows, const ErrorBounds& bounds);
}
