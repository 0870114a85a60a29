/**
 * @class vtkStrataSimulationFilter
 * @brief base of the filters that read a simulation
 *
 * Holds what a user says about the arrays of the input: which are volume fractions or material ids, what the
 * remainder is called, which materials have no fields. What stays unset is found by the conventions of the
 * simulation codes, or said by the case file that the input comes from.
 */
#ifndef vtkStrataSimulationFilter_h
#define vtkStrataSimulationFilter_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkNew.h"                 // for a member
#include "vtkStrataFiltersModule.h" // for the export macro

#include <memory> // for Options
#include <string> // for members

class vtkStringArray;

class VTKSTRATAFILTERS_EXPORT vtkStrataSimulationFilter : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkStrataSimulationFilter, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Arrays of volume fractions, in cells or at points; none: those recognized by their names. */
  void AddVolumeFractionArray(const char* name);
  void ClearVolumeFractionArrays();
  ///@}

  ///@{
  /** Cell array of integer material ids, for meshes with one material per cell. */
  vtkSetMacro(MaterialIdArray, std::string);
  vtkGetMacro(MaterialIdArray, std::string);
  ///@}

  ///@{
  /** Each block of a collection is a material, called like the block, whatever the arrays say. */
  vtkSetMacro(BlocksAsMaterials, bool);
  vtkGetMacro(BlocksAsMaterials, bool);
  vtkBooleanMacro(BlocksAsMaterials, bool);
  ///@}

  ///@{
  /** Name of the material that takes what the volume fractions leave. */
  vtkSetMacro(RemainderMaterial, std::string);
  vtkGetMacro(RemainderMaterial, std::string);
  ///@}

  ///@{
  /** Materials without fields; none: those called empty, void, vacuum or outside. */
  void AddMaterialWithoutFields(const char* name);
  void ClearMaterialsWithoutFields();
  ///@}

  ///@{
  /** A material counts in a cell from this volume fraction on. */
  vtkSetMacro(MinimumVolumeFraction, double);
  vtkGetMacro(MinimumVolumeFraction, double);
  ///@}

  /** The names of the materials that the last run found, "a, b, c". */
  std::string GetMaterialNames();

  /** The materials that the input is likely to have, to choose from; empty while there is no input. */
  vtkStringArray* GetInputMaterials();

protected:
  vtkStrataSimulationFilter();
  ~vtkStrataSimulationFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  /** Throws strata::InvalidInput unless MinimumVolumeFraction lies within [0, 1]. */
  void CheckMinimumVolumeFraction() const;

  std::string MaterialIdArray;
  bool BlocksAsMaterials = false;
  std::string RemainderMaterial = "empty";
  double MinimumVolumeFraction = 0.1;

  struct Lists;
  std::unique_ptr<Lists> ArrayLists;

  vtkNew<vtkStringArray> InputMaterials;

private:
  vtkStrataSimulationFilter(const vtkStrataSimulationFilter&) = delete;
  void operator=(const vtkStrataSimulationFilter&) = delete;
};

#endif
