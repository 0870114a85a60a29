"""The classes can be imported and used without ParaView's server manager."""
import strata

CLASSES = ("vtkStrataCaseReader", "vtkStrataMaterialInterfaces", "vtkStrataTetrahedra", "vtkStrataSlice")

for name in CLASSES:
    algorithm = getattr(strata, name)()
    if not algorithm.IsA("vtkAlgorithm"):
        raise TypeError(f"{name} is no algorithm")
print("strata", strata.__version__)
