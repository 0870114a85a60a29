#pragma once

#include "Conversion/CaseData.h"

#include "Extract/Extract.h"
#include "Model/Errors.h"
#include "Model/Interfaces.h"
#include "Model/Progress.h"
#include "Model/Simulation.h"

class vtkDataObject;

/// How interfaces are extracted for a mesh or its errors.
strata::ExtractOptions extractOptions(double minimumVolumeFraction);

/// The interfaces of a simulation: the surfaces given, else those of the case, else those that its fractions or ids
/// say.
strata::Interfaces originalInterfaces(const strata::conversion::CaseData& input, vtkDataObject* given,
  const strata::Simulation& simulation, double minimumVolumeFraction, strata::Warnings& warnings,
  strata::Progress& progress);
