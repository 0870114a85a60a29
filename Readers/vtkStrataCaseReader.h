#ifndef vtkStrataCaseReader_h
#define vtkStrataCaseReader_h

#include "vtkStrataReadersModule.h"
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

/// Reads a simulation and its interface surfaces from a case file (.strata).
class VTKSTRATAREADERS_EXPORT vtkStrataCaseReader : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkStrataCaseReader* New();
  vtkTypeMacro(vtkStrataCaseReader, vtkPartitionedDataSetCollectionAlgorithm);

protected:
  vtkStrataCaseReader() = default;
  ~vtkStrataCaseReader() override = default;

private:
  vtkStrataCaseReader(const vtkStrataCaseReader&) = delete;
  void operator=(const vtkStrataCaseReader&) = delete;
};

#endif
