/// Any bytes as a case file: the reader says what is wrong, or reads.
#include "vtkStrataCaseReader.h"

#include "vtkNew.h"
#include "vtkObject.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const std::string path =
    (std::filesystem::temp_directory_path() / ("fuzz_" + std::to_string(getpid()) + ".strata")).string();
  vtkObject::GlobalWarningDisplayOff();
  {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  vtkNew<vtkStrataCaseReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  std::remove(path.c_str());
  return 0;
}
