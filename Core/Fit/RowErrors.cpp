#include "Fit/RowErrors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata
{
double relativeError(
  const Hierarchy& values, const HierarchyCell& cell, const CellRows::Samples& samples, const ErrorBounds& bounds)
{
  std::array<const float*, 4> corners;
  for (std::size_t k = 0; k < 4; ++k)
  {
    corners[k] = values.valuesOf(cell.corners[k], samples.material) + samples.firstValue;
  }
  double largest2 = 0.0;
  const double* native = samples.values.data();
  for (const CellRows::Weights& w : samples.weights)
  {
    double squared = 0.0;
    for (int c = 0; c < samples.components; ++c)
    {
      const double represented = w[0] * static_cast<double>(corners[0][c]) + w[1] * static_cast<double>(corners[1][c]) +
                                 w[2] * static_cast<double>(corners[2][c]) + w[3] * static_cast<double>(corners[3][c]);
      const double difference = *native++ - represented;
      squared += difference * difference;
    }
    // A NaN (a field that is not known at this sample) compares false.
    largest2 = squared > largest2 ? squared : largest2;
  }
  return std::sqrt(largest2) / bounds.fieldErrors[samples.field];
}

SignedDistance signedDistance(
  const Hierarchy& values, const HierarchyCell& cell, const CellRows& rows, const CellRows::InterfaceVertices& vertices)
{
  SignedDistance result;
  for (std::size_t k = 0; k < 4; ++k)
  {
    result.corners[k] = static_cast<double>(*values.valuesOf(cell.corners[k], vertices.negative)) -
                        static_cast<double>(*values.valuesOf(cell.corners[k], vertices.positive));
    result.gradient += result.corners[k] * rows.gradients[k];
  }
  return result;
}

double relativeError(const Hierarchy& values, const HierarchyCell& cell, const CellRows& rows,
  const CellRows::InterfaceVertices& vertices, const ErrorBounds& bounds)
{
  const SignedDistance distance = signedDistance(values, cell, rows, vertices);
  double largest = 0.0;
  for (const CellRows::Weights& w : vertices.weights)
  {
    largest = std::max(largest, std::abs(distance.at(w)));
  }
  return largest > 0.0 ? largest / distance.gradient.norm() / bounds.interfaceError : 0.0;
}

double relativeError(
  const Hierarchy& values, const HierarchyCell& cell, const CellRows& rows, const ErrorBounds& bounds)
{
  double largest = 0.0;
  for (const CellRows::Samples& samples : rows.samples)
  {
    largest = std::max(largest, relativeError(values, cell, samples, bounds));
  }
  for (const CellRows::InterfaceVertices& vertices : rows.interfaces)
  {
    largest = std::max(largest, relativeError(values, cell, rows, vertices, bounds));
  }
  return largest;
}
}
