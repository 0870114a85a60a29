#pragma once

#include "Model/Progress.h"

class vtkAlgorithm;

namespace strata::conversion
{
/// Progress that shows in a filter, and stops when the user aborts the filter.
class FilterProgress : public Progress
{
public:
  explicit FilterProgress(vtkAlgorithm* filter);
};
}
