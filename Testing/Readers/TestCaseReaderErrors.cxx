#include "CaseFolder.h"

#include "vtkStrataCaseReader.h"

#include <vtkPartitionedDataSetCollection.h>

using namespace strata::test;

namespace
{
struct CaseReaderErrors : testing::Test
{
  void expectRefused(const std::string& text, std::initializer_list<std::string> messages)
  {
    reader->SetFileName(folder.write("case.strata", text).c_str());
    reader->Modified();
    const Outcome outcome = update(reader);
    for (const std::string& message : messages)
    {
      EXPECT_NE(outcome.error.find(message), std::string::npos) << message << " in: " << outcome.error;
    }
    EXPECT_EQ(cellsOf(reader), 0);
  }

  CaseFolder folder;
  vtkNew<vtkStrataCaseReader> reader;
};

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}
}

TEST_F(CaseReaderErrors, TextThatIsNoJsonIsNamedWithLineAndColumn)
{
  expectRefused("{\"strata\": 1,\n  \"materials\": oops}", { "case.strata", "line 2", "column 16" });
  expectRefused("", { "line 1, column 1" });
}

TEST_F(CaseReaderErrors, KeysMustBeKnownAndThere)
{
  expectRefused(replaced(caseText(), "\"fields\": {", "\"feilds\": {"), { "unknown key 'feilds'" });
  expectRefused(replaced(caseText(), "\"steps\"", "\"step\""), { "unknown key 'step'" });
  expectRefused(R"({"strata": 1})", { "lacks the key 'materials'" });
  expectRefused(replaced(caseText(), "\"strata\": 1", "\"strata\": 2"), { "version 1" });
}

TEST_F(CaseReaderErrors, ValuesMustHaveTheirType)
{
  expectRefused(caseText(R"([{"time": "soon", "grid": "halves.vti"}])"), { "steps[0].time", "number" });
  expectRefused(caseText(R"([])"), { "no steps" });
  expectRefused(caseText(R"({"grid": "halves.vti"})"), { "steps", "list" });
}

TEST_F(CaseReaderErrors, TimesMustAscend)
{
  expectRefused(
    caseText(R"([{"time": 1, "grid": "halves.vti"}, {"time": 1, "grid": "halves.vti"}])"), { "steps[1]", "ascend" });
}

TEST_F(CaseReaderErrors, MaterialsMustBeKnown)
{
  expectRefused(caseText(R"([{"grid": "halves.vti"}])", R"({"lead": "volume_fraction_left"})"), { "lead", "'left'" });
  expectRefused(caseText(R"([{"grid": "halves.vti"}])", R"({})"), { "'right' has no array" });
}

TEST_F(CaseReaderErrors, MissingFilesAndArraysAreNamed)
{
  expectRefused(caseText(R"([{"grid": "nowhere.vti"}])"), { "nowhere.vti", "doesn't exist" });
  folder.write("grid.xyz", "");
  expectRefused(caseText(R"([{"grid": "grid.xyz"}])"), { "grid.xyz", "extension" });
  expectRefused(caseText(R"([{"grid": "halves.vti"}])", R"({"left": "vf_left", "right": "volume_fraction_right"})"),
    { "'vf_left'", "volume_fraction_left" });
  expectRefused(caseText(R"([{"grid": "halves.vti",
      "interfaces": [{"surface": "gone.stl", "positive": "left", "negative": "right"}]}])"),
    { "gone.stl" });
}

TEST_F(CaseReaderErrors, AFileMustBeGiven)
{
  const Outcome outcome = update(reader);
  EXPECT_NE(outcome.error.find("No file name"), std::string::npos) << outcome.error;
  reader->SetFileName(folder.path("gone.strata").c_str());
  EXPECT_NE(update(reader).error.find("gone.strata"), std::string::npos);
}
