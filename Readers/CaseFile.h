#pragma once

#include "Conversion/CaseData.h"

#include <string>
#include <vector>

/// What a case file (.strata) says; paths are absolute or relative to the working folder.
struct CaseFile
{
  struct Surface
  {
    std::string path;
    std::string positive;
    std::string negative;
  };
  struct Step
  {
    double time = 0.0;
    std::string grid;
    bool hasInterfaces = false; ///< false: they are to be found from the fractions
    std::vector<Surface> interfaces;
  };

  strata::conversion::CaseDescription description;
  std::vector<Step> steps; ///< times ascend
};

/// Reads a case file. Throws strata::InvalidInput with the file's name, and line and column where it is no JSON, and
/// the key where a key is unknown, missing or of the wrong type.
CaseFile readCaseFile(const std::string& path);
