#include "ReadFiles.h"

#include "Model/Errors.h"

#include <vtkGenericDataObjectReader.h>
#include <vtkHyperTreeGrid.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkSTLReader.h>
#include <vtkXMLGenericDataObjectReader.h>
#include <vtkXMLPolyDataReader.h>

#include <vtksys/SystemTools.hxx>

namespace
{
using strata::InvalidInput;

std::string extensionOf(const std::string& path)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(path));
}

void expectFile(const std::string& path)
{
  if (!vtksys::SystemTools::FileExists(path, true))
  {
    throw InvalidInput("The file '" + path + "' doesn't exist");
  }
}

template<typename Reader>
vtkSmartPointer<vtkDataObject> read(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutputDataObject(0);
}

/// ParaView 5.11 with a current expat can't read XML files with appended data and gives an empty object instead.
void expectContent(vtkDataObject* data, const std::string& path)
{
  if (!data || data->GetNumberOfElements(vtkDataObject::CELL) == 0)
  {
    throw InvalidInput("The file '" + path +
                       "' can't be read or has no cells. (Some installations of ParaView 5.11 can't read XML files "
                       "with appended data: write them with inline binary data.)");
  }
}
}

vtkSmartPointer<vtkDataObject> readGridFile(const std::string& path)
{
  expectFile(path);
  const std::string extension = extensionOf(path);
  vtkSmartPointer<vtkDataObject> data;
  if (extension == ".vtk")
  {
    data = read<vtkGenericDataObjectReader>(path);
  }
  else if (extension.compare(0, 3, ".vt") == 0 || extension.compare(0, 4, ".pvt") == 0 || extension == ".htg")
  {
    data = read<vtkXMLGenericDataObjectReader>(path);
  }
  else
  {
    throw InvalidInput("The grid '" + path + "' has the unknown extension '" + extension +
                       "'; VTK's own formats (.vti .vtr .vts .vtu .vtm .vthb .htg .vtk ...) are read");
  }
  expectContent(data, path);
  return data;
}

vtkSmartPointer<vtkPolyData> readSurfaceFile(const std::string& path)
{
  expectFile(path);
  const std::string extension = extensionOf(path);
  vtkSmartPointer<vtkDataObject> data;
  if (extension == ".vtp")
  {
    data = read<vtkXMLPolyDataReader>(path);
  }
  else if (extension == ".vtk")
  {
    data = read<vtkGenericDataObjectReader>(path);
  }
  else if (extension == ".stl")
  {
    data = read<vtkSTLReader>(path);
  }
  else if (extension == ".ply")
  {
    data = read<vtkPLYReader>(path);
  }
  else if (extension == ".obj")
  {
    data = read<vtkOBJReader>(path);
  }
  else
  {
    throw InvalidInput("The surface '" + path + "' has the unknown extension '" + extension +
                       "'; .vtp, .vtk, .stl, .ply and .obj are read");
  }
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (!surface)
  {
    throw InvalidInput("The file '" + path + "' holds no surface");
  }
  expectContent(surface, path);
  return surface;
}
