/**
 * @class vtkStrataCaseReader
 * @brief reads a simulation and its interface surfaces from a case file (.strata)
 *
 * A case file is JSON that names the grids of the time steps, which of their arrays are volume fractions and fields of
 * which material, and the surfaces between the materials; without surfaces they are found from the fractions. The
 * output has a block `grid` and one block per surface, named `<positive>|<negative>`. The grid's field data say what
 * the file said, so that filters need no further settings:
 *
 * - `material_names`, `material_has_fields`: one entry per material;
 * - `strata_fraction_arrays`: the array of volume fractions of each material, "" for the one that takes the rest;
 * - `strata_field_arrays`: three strings per entry: field, material ("" for all), array.
 */
#ifndef vtkStrataCaseReader_h
#define vtkStrataCaseReader_h

#include "vtkPartitionedDataSetCollectionAlgorithm.h"
#include "vtkStrataReadersModule.h" // for the export macro

#include <memory> // for Internals

class VTKSTRATAREADERS_EXPORT vtkStrataCaseReader : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkStrataCaseReader* New();
  vtkTypeMacro(vtkStrataCaseReader, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The case file. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** 1 for files whose name ends in .strata. */
  static int CanReadFile(VTK_FILEPATH const char* name);

protected:
  vtkStrataCaseReader();
  ~vtkStrataCaseReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkStrataCaseReader(const vtkStrataCaseReader&) = delete;
  void operator=(const vtkStrataCaseReader&) = delete;

  char* FileName = nullptr;

  struct Internals;
  std::unique_ptr<Internals> State;
};

#endif
