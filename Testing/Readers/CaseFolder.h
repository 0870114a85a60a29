#pragma once

#include "TwoHalves.h"

#include <vtkXMLImageDataWriter.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace strata::test
{
/// A folder of its own with the two halves as `halves.vti`, removed at the end.
class CaseFolder
{
public:
  CaseFolder()
  {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
      std::filesystem::temp_directory_path() / (std::string("strata_") + info->test_suite_name() + "_" + info->name());
    std::filesystem::create_directories(folder_);
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(twoHalves(4));
    writer->SetDataModeToBinary();
    writer->SetFileName(path("halves.vti").c_str());
    writer->Write();
  }
  CaseFolder(const CaseFolder&) = delete;
  CaseFolder& operator=(const CaseFolder&) = delete;
  ~CaseFolder() { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Writes a file of the folder and returns its path.
  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name)) << text;
    return path(name);
  }

private:
  std::filesystem::path folder_;
};

/// A case over `halves.vti`; the parts in the middle can be replaced.
inline std::string caseText(const std::string& steps = R"([{"time": 2.5, "grid": "halves.vti"}])",
  const std::string& fractions = R"({"left": "volume_fraction_left", "right": "volume_fraction_right"})",
  const std::string& fields = R"({"rho": {"left": "density_left", "right": "density_right"}})")
{
  return R"({"strata": 1, "materials": ["left", {"name": "right", "fields": false}],
"volume_fractions": )" +
         fractions + R"(,
"fields": )" +
         fields + R"(,
"steps": )" +
         steps + "}";
}
}
