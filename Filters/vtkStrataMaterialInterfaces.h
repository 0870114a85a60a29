/**
 * @class vtkStrataMaterialInterfaces
 * @brief finds the surfaces between the materials of a simulation
 *
 * One surface per pair of materials that touch, without gaps where several meet, from volume fractions or material
 * ids. Blocks are named `<positive>|<negative>`; normals point into the positive material.
 */
#ifndef vtkStrataMaterialInterfaces_h
#define vtkStrataMaterialInterfaces_h

#include "vtkStrataFiltersModule.h" // for the export macro
#include "vtkStrataSimulationFilter.h"

#include <memory>
#include <string>

class VTKSTRATAFILTERS_EXPORT vtkStrataMaterialInterfaces : public vtkStrataSimulationFilter
{
public:
  static vtkStrataMaterialInterfaces* New();
  vtkTypeMacro(vtkStrataMaterialInterfaces, vtkStrataSimulationFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Drive the reconstructed volume of each material in each cell to its fraction. */
  vtkSetMacro(VolumeCorrection, bool);
  vtkGetMacro(VolumeCorrection, bool);
  vtkBooleanMacro(VolumeCorrection, bool);
  ///@}

  ///@{
  /** Where a solver smears fractions over several cells across an interface, let the volume in these cells together
   * place the interface (on, default), not each cell for itself. */
  vtkSetMacro(GatherSmearedFractions, bool);
  vtkGetMacro(GatherSmearedFractions, bool);
  vtkBooleanMacro(GatherSmearedFractions, bool);
  ///@}

  ///@{
  /** Add the input as a block `grid`, with the volume error of each material as cell arrays `volume_error_<m>`. */
  vtkSetMacro(VolumeErrors, bool);
  vtkGetMacro(VolumeErrors, bool);
  vtkBooleanMacro(VolumeErrors, bool);
  ///@}

  /** How often interfaces were extracted since the filter was made: runs in which fields alone change share them. */
  vtkGetMacro(NumberOfExtractions, int);

  /** What the numbers of the output's cell array `pair` stand for, a line "<number><tab><name>" each. */
  std::string GetLegend();

protected:
  vtkStrataMaterialInterfaces();
  ~vtkStrataMaterialInterfaces() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool VolumeCorrection = true;
  bool GatherSmearedFractions = true;
  bool VolumeErrors = false;
  int NumberOfExtractions = 0;

private:
  vtkStrataMaterialInterfaces(const vtkStrataMaterialInterfaces&) = delete;
  void operator=(const vtkStrataMaterialInterfaces&) = delete;

  struct Internals;
  std::unique_ptr<Internals> State;
};

#endif
