#pragma once

#include "Model/CellRows.h"
#include "Model/ErrorBounds.h"
#include "Model/Hierarchy.h"

namespace strata
{
/// The signed distance to the interface of two materials in a cell: linear, zero where both are equally near.
struct SignedDistance
{
  std::array<double, 4> corners;
  Vector gradient = Vector::Zero();

  double at(const CellRows::Weights& w) const
  {
    return w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2] + w[3] * corners[3];
  }
};

SignedDistance signedDistance(const Hierarchy& values, const HierarchyCell& cell, const CellRows& rows,
  const CellRows::InterfaceVertices& vertices);

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
