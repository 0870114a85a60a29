/**
 * @class vtkStrataSlice
 * @brief cuts a representation by planes, material by material
 *
 * The polygons are convex and planar and lie within one material each; points are not shared across materials, so
 * that the jump of a field stays sharp.
 */
#ifndef vtkStrataSlice_h
#define vtkStrataSlice_h

#include "vtkSmartPointer.h"        // for the plane
#include "vtkStrataFiltersModule.h" // for the export macro
#include "vtkStrataMaterialsFilter.h"

#include <vector> // for the offsets

class vtkPlane;

class VTKSTRATAFILTERS_EXPORT vtkStrataSlice : public vtkStrataMaterialsFilter
{
public:
  static vtkStrataSlice* New();
  vtkTypeMacro(vtkStrataSlice, vtkStrataMaterialsFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The plane. */
  void SetSliceType(vtkPlane* plane);
  vtkPlane* GetSliceType();
  ///@}

  ///@{
  /** Distances of the slices from the plane along its normal; by default a single 0. */
  void SetNumberOfSliceOffsets(int count);
  int GetNumberOfSliceOffsets() const { return static_cast<int>(this->SliceOffsets.size()); }
  void SetSliceOffset(int number, double offset);
  double GetSliceOffset(int number) const;
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkStrataSlice();
  ~vtkStrataSlice() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkStrataSlice(const vtkStrataSlice&) = delete;
  void operator=(const vtkStrataSlice&) = delete;

  vtkSmartPointer<vtkPlane> SliceType;
  std::vector<double> SliceOffsets = { 0.0 };

  struct Internals;
  std::unique_ptr<Internals> State;
};

#endif
