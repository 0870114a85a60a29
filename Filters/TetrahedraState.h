#pragma once

#include "KeptInterfaces.h"
#include "vtkStrataTetrahedra.h"

#include "Conversion/ReadSimulation.h"

#include "Pipeline.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkDataObject;

/// The hierarchy that the filter keeps, what it was built from, and what the last level achieved.
struct vtkStrataTetrahedra::Internals
{
  struct Inputs
  {
    vtkDataObject* simulation;
    vtkDataObject* interfaces; ///< null if not connected
  };

  /// Starts a new hierarchy unless the input and the build options are those of the one that is kept. True if it did.
  bool prepare(const vtkStrataTetrahedra& filter, const Inputs& inputs, strata::Progress& progress);

  /// What the filter's bounds and limits come to. Throws InvalidInput for bounds that make no sense.
  strata::SelectOptions selection(const vtkStrataTetrahedra& filter) const;
  strata::EmitOptions emission(const vtkStrataTetrahedra& filter) const;

  /// Notes what a level achieved.
  void report(const strata::Mesh& mesh);

  /// Forgets the hierarchy unless a run comes to its end: an exception may leave it half extended.
  class Guard
  {
  public:
    explicit Guard(Internals& state) : state_(state) {}
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;
    ~Guard()
    {
      if (!done_)
      {
        state_.key.clear();
        state_.multiresolution.reset();
      }
    }
    void done() { done_ = true; }

  private:
    Internals& state_;
    bool done_ = false;
  };

  std::vector<std::pair<std::string, double>> absoluteBounds;
  std::vector<std::string> focusMaterials;

  KeptInterfaces interfaces;
  std::string key;
  std::shared_ptr<const strata::NativeData> native;
  std::unique_ptr<strata::Multiresolution> multiresolution;
  std::vector<std::string> warnings;
  strata::conversion::Deviations deviations; ///< of the input that the hierarchy was built from

  strata::Achieved achieved;
  std::string fieldErrorText;

private:
  strata::BuildOptions buildOptions(const vtkStrataTetrahedra& filter) const;
  std::string keyOf(const vtkStrataTetrahedra& filter, const Inputs& inputs) const;
  strata::Interest interest(const vtkStrataTetrahedra& filter) const;
  static strata::RegionOfInterest region(const vtkStrataTetrahedra& filter);
  static strata::View view(const vtkStrataTetrahedra& filter);
  strata::ErrorBounds bounds(double interfaceError, double relativeFieldError) const;
};
