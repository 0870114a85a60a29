#pragma once

#include "CaseFile.h"

#include "Model/Errors.h"
#include "Model/Progress.h"

class vtkPartitionedDataSetCollection;

/// Reads a step's grid and surfaces into the blocks of a collection; surfaces that the file doesn't name are found from
/// the volume fractions. Throws strata::InvalidInput for missing files and arrays.
strata::Warnings readStep(const CaseFile& file, const CaseFile::Step& step, vtkPartitionedDataSetCollection* output,
  strata::Progress& progress);
