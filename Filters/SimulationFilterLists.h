#pragma once

#include "vtkStrataSimulationFilter.h"

#include "Conversion/ReadSimulation.h"

#include <string>
#include <vector>

/// The lists of names that a filter was given.
struct vtkStrataSimulationFilter::Lists
{
  std::vector<std::string> volumeFractionArrays;
  std::vector<std::string> materialsWithoutFields;
  std::vector<std::string> fieldArrays;

  strata::conversion::SimulationOptions options(const vtkStrataSimulationFilter& filter) const
  {
    strata::conversion::SimulationOptions result;
    result.volumeFractionArrays = volumeFractionArrays;
    result.materialIdArray = filter.MaterialIdArray;
    result.blocksAsMaterials = filter.BlocksAsMaterials;
    result.remainderMaterial = filter.RemainderMaterial;
    result.materialsWithoutFields = materialsWithoutFields;
    result.fieldArrays = fieldArrays;
    return result;
  }
};
