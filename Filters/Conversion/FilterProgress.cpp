#include "Conversion/FilterProgress.h"

#include <vtkAlgorithm.h>

namespace strata::conversion
{
FilterProgress::FilterProgress(vtkAlgorithm* filter) :
  Progress([filter](const std::string& stage, double fraction) {
    filter->SetProgressText(stage.c_str());
    filter->UpdateProgress(fraction);
    return !filter->GetAbortExecute() && !filter->CheckAbort();
  })
{}
}
