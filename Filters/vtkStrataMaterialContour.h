/**
 * @class vtkStrataMaterialContour
 * @brief iso-surfaces of a field, material by material
 *
 * In each material the surface on which that material's own field takes a value. It ends sharply at the interface:
 * nothing is interpolated across the jump. The field is the array to process (point data, a field of the
 * representation); by default its first field.
 */
#ifndef vtkStrataMaterialContour_h
#define vtkStrataMaterialContour_h

#include "vtkStrataMaterialsFilter.h"

#include <string>
#include <vector>

class VTKSTRATAFILTERS_EXPORT vtkStrataMaterialContour : public vtkStrataMaterialsFilter
{
public:
  static vtkStrataMaterialContour* New();
  vtkTypeMacro(vtkStrataMaterialContour, vtkStrataMaterialsFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Values of the surfaces, in the field's unit; at least one. */
  void SetNumberOfIsosurfaces(int count);
  int GetNumberOfIsosurfaces() const { return static_cast<int>(this->Isosurfaces.size()); }
  void SetIsosurface(int number, double value);
  double GetIsosurface(int number) const;
  ///@}

  /** What the numbers of the output's cell array `material` stand for, a line "<number><tab><name>" each. */
  std::string GetLegend();

protected:
  vtkStrataMaterialContour() = default;
  ~vtkStrataMaterialContour() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkStrataMaterialContour(const vtkStrataMaterialContour&) = delete;
  void operator=(const vtkStrataMaterialContour&) = delete;

  std::string FieldName();

  std::vector<double> Isosurfaces;
};

#endif
