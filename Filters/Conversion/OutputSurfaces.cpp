#include "Conversion/OutputSurfaces.h"

#include "Conversion/CaseData.h"
#include "Conversion/Legend.h"
#include "Conversion/ValueConversion.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataAssembly.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>

#include <Eigen/Geometry>

#include <map>

namespace strata::conversion
{
namespace
{
/// A surface with points of its own, in order of first use.
struct OwnPoints
{
  std::vector<Vector> points;
  Buffer<std::int64_t> corners;

  OwnPoints(const Interfaces& interfaces, const Interfaces::Surface& surface) :
    corners(3 * static_cast<Index>(surface.triangles.size()))
  {
    std::map<std::int32_t, Index> places;
    Index next = 0;
    for (const auto& triangle : surface.triangles)
    {
      for (const std::int32_t point : triangle)
      {
        const auto [at, isNew] = places.try_emplace(point, static_cast<Index>(points.size()));
        if (isNew)
        {
          points.push_back(interfaces.points[static_cast<std::size_t>(point)]);
        }
        corners[next++] = at->second;
      }
    }
  }
};

vtkSmartPointer<vtkFloatArray> normalsOf(const OwnPoints& own)
{
  std::vector<Vector> sums(own.points.size(), Vector::Zero());
  for (Index i = 0; i < own.corners.size(); i += 3)
  {
    const auto a = static_cast<std::size_t>(own.corners[i]);
    const auto b = static_cast<std::size_t>(own.corners[i + 1]);
    const auto c = static_cast<std::size_t>(own.corners[i + 2]);
    // Twice the area in length: the sum is weighted by area.
    const Vector area = (own.points[b] - own.points[a]).cross(own.points[c] - own.points[a]);
    sums[a] += area;
    sums[b] += area;
    sums[c] += area;
  }
  Buffer<float> normals(3 * static_cast<Index>(sums.size()));
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    const Vector normal = sums[i].stableNormalized();
    for (int axis = 0; axis < 3; ++axis)
    {
      normals[3 * static_cast<Index>(i) + axis] = static_cast<float>(normal[axis]);
    }
  }
  return give<vtkFloatArray>("Normals", std::move(normals), 3);
}

vtkSmartPointer<vtkIntArray> constant(const char* name, int value, Index count)
{
  Buffer<std::int32_t> values(count);
  std::fill(values.begin(), values.end(), value);
  return give<vtkIntArray>(name, std::move(values));
}

vtkSmartPointer<vtkPolyData> surfaceOf(
  const Interfaces& interfaces, const Interfaces::Surface& surface, const Materials& materials)
{
  OwnPoints own(interfaces, surface);
  auto output = vtkSmartPointer<vtkPolyData>::New();
  Buffer<double> coordinates(3 * static_cast<Index>(own.points.size()));
  for (std::size_t i = 0; i < own.points.size(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      coordinates[3 * static_cast<Index>(i) + axis] = own.points[i][axis];
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(give<vtkDoubleArray>("Points", std::move(coordinates), 3));
  output->SetPoints(points);
  output->GetPointData()->SetNormals(normalsOf(own));
  vtkNew<vtkCellArray> cells;
  cells->SetData(3, give<vtkTypeInt64Array>("", std::move(own.corners)));
  output->SetPolys(cells);
  labelSurface(output, surface.positive, surface.negative, materials);
  return output;
}

int addLabelled(vtkDataAssembly* assembly, const std::string& label, int parent)
{
  const int node = assembly->AddNode(vtkDataAssembly::MakeValidNodeName(label.c_str()).c_str(), parent);
  assembly->SetAttribute(node, "label", label.c_str());
  return node;
}
}

void labelSurface(vtkPolyData* surface, MaterialId positive, MaterialId negative, const Materials& materials)
{
  const Index count = surface->GetNumberOfCells();
  surface->GetCellData()->AddArray(constant(names::positive, positive.value, count));
  surface->GetCellData()->AddArray(constant(names::negative, negative.value, count));
  const int pair = pairNumber(positive.value, negative.value, static_cast<int>(materials.size()));
  surface->GetCellData()->AddArray(constant(names::pair, pair, count));
  writeMaterials(materials, surface->GetFieldData());
}

void writeInterfaces(const Interfaces& interfaces, const Materials& materials, vtkPartitionedDataSetCollection* output)
{
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    const std::string name = materials[static_cast<std::size_t>(surface.positive.value)].name + "|" +
                             materials[static_cast<std::size_t>(surface.negative.value)].name;
    const unsigned int block = output->GetNumberOfPartitionedDataSets();
    output->SetPartition(block, 0, surfaceOf(interfaces, surface, materials));
    output->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
  writeMaterials(materials, output->GetFieldData());
}

void writeAssembly(const Materials& materials, vtkPartitionedDataSetCollection* output)
{
  vtkNew<vtkDataAssembly> assembly;
  assembly->SetRootNodeName("Strata");
  const int pairs = assembly->AddNode("pairs");
  const int byMaterial = assembly->AddNode("materials");
  std::map<std::string, int> nodes;
  for (const Material& material : materials)
  {
    nodes[material.name] = addLabelled(assembly, material.name, byMaterial);
  }
  for (unsigned int block = 0; block < output->GetNumberOfPartitionedDataSets(); ++block)
  {
    const char* metaName = output->GetMetaData(block)->Get(vtkCompositeDataSet::NAME());
    const std::string name = metaName ? metaName : "";
    const std::size_t bar = name.find('|');
    if (bar == std::string::npos)
    {
      assembly->AddDataSetIndex(addLabelled(assembly, name, assembly->GetRootNode()), block);
      continue;
    }
    assembly->AddDataSetIndex(addLabelled(assembly, name, pairs), block);
    for (const std::string& material : { name.substr(0, bar), name.substr(bar + 1) })
    {
      const auto node = nodes.find(material);
      if (node != nodes.end())
      {
        assembly->AddDataSetIndex(node->second, block);
      }
    }
  }
  output->SetDataAssembly(assembly);
}

void writeVolumes(const ExtractedInterfaces& found, vtkFieldData* data)
{
  using Member = double VolumeReport::*;
  const std::pair<const char*, Member> columns[] = { { "volume_given", &VolumeReport::given },
    { "volume_reconstructed", &VolumeReport::reconstructed }, { "volume_error_largest", &VolumeReport::largestError },
    { "volume_error_mean", &VolumeReport::meanError } };
  for (const auto& [name, member] : columns)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (const VolumeReport& volume : found.volumes)
    {
      column->InsertNextValue(volume.*member);
    }
    data->AddArray(column);
  }
  vtkNew<vtkDoubleArray> smearing;
  smearing->SetName("gathered_smearing");
  smearing->InsertNextValue(found.smearing);
  data->AddArray(smearing);
}
}
