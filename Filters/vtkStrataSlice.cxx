#include "vtkStrataSlice.h"

#include "MaterialsFilterLists.h"

#include "Conversion/CaseData.h"
#include "Conversion/Guarded.h"
#include "Conversion/InputRepresentation.h"
#include "Conversion/OutputPolygons.h"

#include "Slice/SliceIndex.h"

#include "vtkAppendPolyData.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace conversion = strata::conversion;

vtkStandardNewMacro(vtkStrataSlice);

struct vtkStrataSlice::Internals
{
  /// Views the input; the view is kept while the input stays. A search structure is made when the same mesh is cut for
  /// the second time: for a single cut it costs more than it saves.
  void prepare(vtkDataObject* data, strata::Progress& progress)
  {
    const std::uint64_t time = conversion::modifiedTime(data);
    if (data != this->source || time != this->sourceTime)
    {
      this->index.reset();
      this->source = nullptr;
      this->input = conversion::readRepresentation(data);
      this->source = data;
      this->sourceTime = time;
    }
    else if (!this->index)
    {
      this->index = std::make_unique<strata::SliceIndex>(this->input.view, progress);
    }
  }

  const vtkDataObject* source = nullptr;
  std::uint64_t sourceTime = 0;
  conversion::RepresentationInput input;
  std::unique_ptr<strata::SliceIndex> index;

  /// The plane as it acts: subclasses of vtkPlane, like ParaView's with its offset, say by their function where it
  /// lies.
  static strata::SlicePlane planeOf(vtkPlane* plane)
  {
    strata::SlicePlane result;
    const strata::Vector normal(plane->GetNormal());
    const double length = normal.norm();
    result.origin = strata::Vector(plane->GetOrigin());
    result.normal = length > 0.0 ? strata::Vector(normal / length) : normal;
    const double distance = length > 0.0 ? plane->EvaluateFunction(plane->GetOrigin()) / length : 0.0;
    result.origin -= distance * result.normal;
    return result;
  }
};

vtkStrataSlice::vtkStrataSlice() : SliceType(vtkSmartPointer<vtkPlane>::New()), State(new Internals)
{
  this->SliceType->SetNormal(1.0, 0.0, 0.0);
}

vtkStrataSlice::~vtkStrataSlice() = default;

void vtkStrataSlice::SetSliceType(vtkPlane* plane)
{
  if (plane && this->SliceType != plane)
  {
    this->SliceType = plane;
    this->Modified();
  }
}

vtkPlane* vtkStrataSlice::GetSliceType()
{
  return this->SliceType;
}

void vtkStrataSlice::SetNumberOfSliceOffsets(int count)
{
  this->SliceOffsets.resize(static_cast<std::size_t>(std::max(count, 0)));
  this->Modified();
}

void vtkStrataSlice::SetSliceOffset(int number, double offset)
{
  if (number >= 0)
  {
    this->SliceOffsets.resize(std::max(this->SliceOffsets.size(), static_cast<std::size_t>(number) + 1));
    this->SliceOffsets[static_cast<std::size_t>(number)] = offset;
    this->Modified();
  }
}

double vtkStrataSlice::GetSliceOffset(int number) const
{
  return this->SliceOffsets.at(static_cast<std::size_t>(number));
}

vtkMTimeType vtkStrataSlice::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->SliceType->GetMTime());
}

int vtkStrataSlice::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkStrataSlice::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto* output = vtkPolyData::GetData(outputs);
  return conversion::guarded(this, output, [&](strata::Progress& progress) {
    this->State->prepare(vtkDataObject::GetData(inputs[0]), progress);
    const strata::Representation& mesh = this->State->input.view;
    const strata::MaterialSet materials = conversion::chosenMaterials(this->MaterialLists->materials, mesh.materials);
    strata::SlicePlane plane = Internals::planeOf(this->SliceType);
    vtkNew<vtkAppendPolyData> all;
    for (const double offset : this->SliceOffsets)
    {
      plane.offset = offset;
      vtkNew<vtkPolyData> one;
      progress.stage("Slicing", 0.0, 1.0);
      conversion::writePolygons(strata::slice(mesh, plane, materials, this->State->index.get(), progress), mesh, one);
      all->AddInputData(one);
    }
    if (this->SliceOffsets.size() == 1)
    {
      output->ShallowCopy(all->GetInput());
    }
    else if (!this->SliceOffsets.empty())
    {
      all->Update();
      output->ShallowCopy(all->GetOutput());
      output->GetFieldData()->ShallowCopy(all->GetInput(0)->GetFieldData());
    }
  });
}

void vtkStrataSlice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SliceOffsets: " << this->SliceOffsets.size() << "\n";
  this->SliceType->PrintSelf(os, indent.GetNextIndent());
}
