"""The layer check finds what it is for."""
import os
import tempfile
import unittest

from check_layers import violations


class CheckLayers(unittest.TestCase):
    def found(self, **files):
        with tempfile.TemporaryDirectory() as root:
            for path, text in files.items():
                path = os.path.join(root, path)
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
            return list(violations(root))

    def include(self, source, target):
        name = target.split("/", 1)[1] if target.startswith("Core/") else target
        return self.found(**{source: f'#include "{name}"\n', target: "\n"})

    def test_downward_includes_are_fine(self):
        self.assertEqual(self.include("Core/Model/Mesh.h", "Core/Geometry/Box.h"), [])
        self.assertEqual(self.include("Core/Slice/Slice.h", "Core/Model/Mesh.h"), [])
        self.assertEqual(self.include("Core/Pipeline.h", "Core/Slice/Slice.h"), [])
        self.assertEqual(self.include("Readers/vtkReader.cxx", "Filters/Conversion/Convert.h"), [])
        self.assertEqual(self.include("Testing/Core/Slice/Test.cpp", "Core/Slice/Slice.h"), [])

    def test_a_part_may_include_itself(self):
        self.assertEqual(self.include("Core/Slice/Slice.cpp", "Core/Slice/Slice.h"), [])

    def test_an_include_that_points_up_is_found(self):
        self.assertEqual(len(self.include("Core/Geometry/Box.h", "Core/Model/Ids.h")), 1)
        self.assertEqual(len(self.include("Core/Model/Mesh.h", "Core/Slice/Slice.h")), 1)
        self.assertEqual(len(self.include("Core/Slice/Slice.h", "Core/Pipeline.h")), 1)
        self.assertEqual(len(self.include("Filters/Conversion/Convert.h", "Filters/vtkFilter.h")), 1)
        self.assertEqual(len(self.include("Core/Slice/Slice.h", "Testing/Support/Analytic.h")), 1)

    def test_stages_that_include_each_other_are_found(self):
        self.assertEqual(len(self.include("Core/Slice/Slice.h", "Core/Pieces/Pieces.h")), 1)

    def test_filters_and_readers_that_include_each_other_are_found(self):
        self.assertEqual(len(self.include("Readers/vtkReader.cxx", "Filters/vtkFilter.h")), 1)

    def test_vtk_in_the_core_is_found(self):
        self.assertEqual(len(self.found(**{"Core/Model/Mesh.h": "#include <vtkObject.h>\n"})), 1)


if __name__ == "__main__":
    unittest.main()
