#pragma once

#include "Build/HierarchyBuilder.h"
#include "InterfaceCertificate.h"
#include "Select/Front.h"

namespace strata
{
struct FitOptions
{
  /// The first level meets the bounds times this; fitting brings most of its cells below the bounds. Certified errors
  /// leave fits less freedom.
  double looseness = 3.0;
  double certifiedLooseness = 2.0;
  /// Passes over the vertices before cells are split, each time.
  int sweeps = 6;
  /// Cells that fall short although so many of their ancestors in a row were split for it get unfitted values.
  int mostFailures = 4;
  int maximumLevel = 60;
};

/// A level with values of its own: `values` is the builder's hierarchy but for the values and errors at the level.
struct FittedLevel
{
  Hierarchy values;
  Level level;                                       ///< its regions are closed
  std::unique_ptr<InterfaceCertificate> certificate; ///< of the level, where distances are certified
};

/// Finds a level that meets the bounds with few cells: takes a looser one, fits the values at its vertices, splits
/// the cells that still fall short, fits again, until all bounds hold (design 3.7). The values belong to the
/// level, never to the hierarchy. `original`: the surfaces that distances are certified against, or null.
FittedLevel fitLevel(HierarchyBuilder& builder, const InterfaceTrees* original, const ErrorBounds& bounds,
  const FitOptions& options, Progress& progress);
}
