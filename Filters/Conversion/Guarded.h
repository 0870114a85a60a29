#pragma once

#include "Conversion/FilterProgress.h"

#include "Model/Errors.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkObject.h>

namespace strata::conversion
{
/// Runs a filter's work behind the one `try` at the wall between VTK and the core: an exception becomes an error of
/// the filter and an empty output, an abort an empty output. `work` is called with the progress.
template<typename Work>
int guarded(vtkAlgorithm* filter, vtkDataObject* output, const Work& work)
{
  // An abort of the run before must not stop this one: this VTK doesn't reset the flag.
  filter->SetAbortExecute(0);
  try
  {
    FilterProgress progress(filter);
    progress.stage("Reading the input", 0.0, 0.0);
    work(progress);
    return 1;
  }
  catch (const Cancelled&)
  {
    output->Initialize();
    return 1;
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorWithObjectMacro(filter, << error.what());
    return 0;
  }
}

inline void warn(vtkAlgorithm* filter, const Warnings& warnings)
{
  for (const std::string& warning : warnings)
  {
    vtkWarningWithObjectMacro(filter, << warning);
  }
}
}
