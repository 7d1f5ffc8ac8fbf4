// SPDX-License-Identifier: GPL-2.0-or-later
// Mesh files with broken bytes are read or refused with one sentence, never
// more. MIXED_CRACKS_MUTATIONS=2000 in the environment tries so many of each
// format instead of a few.
#include <problem/geometries/mesh_builder.h>
#include <problem/geometries/mesh_scan.h>

#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "hex_meshes.h"

using namespace MixedCracks;

namespace
{
  const std::string grid =
    "1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n";

  const std::string gmsh2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 1 \"left\"\n"
    "$EndPhysicalNames\n$Nodes\n6\n" +
    grid +
    "$EndNodes\n$Elements\n3\n1 1 2 1 1 1 4\n2 3 2 7 1 1 2 5 4\n"
    "3 3 2 7 1 2 3 6 5\n$EndElements\n";

  const std::string gmsh4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 1 1 0\n"
    "1 0 0 0 0 1 0 1 1 2 4 -1\n1 0 0 0 2 1 0 1 7 0\n$EndEntities\n$Nodes\n"
    "1 6 1 6\n2 1 0 6\n1\n2\n3\n4\n5\n6\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n"
    "2 1 0\n$EndNodes\n$Elements\n2 3 1 3\n1 1 1 1\n1 4 1\n2 1 3 2\n"
    "2 1 2 5 4\n3 2 3 6 5\n$EndElements\n";

  const std::string abaqus =
    "*NODE, NSET=all\n1, 0, 0\n2, 1, 0\n3, 2, 0\n4, 0, 1\n5, 1, 1\n6, 2, 1\n"
    "*ELEMENT, TYPE=T2D2, ELSET=line\n9, 1, 4\n*ELEMENT, TYPE=CPS4, ELSET=EB2\n"
    "1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n*ELSET, ELSET=both, GENERATE\n1, 2, 1\n"
    "*NSET, NSET=base\n1, 2, 3\n*SURFACE, NAME=SS1, TYPE=ELEMENT\n1, S4\n"
    "*SURFACE, NAME=Top\nboth, S3\n*SOLID SECTION, ELSET=both, MATERIAL=M-3\n";

  const std::string ucd =
    "6 3 0 0 0\n" + grid + "1 5 quad 1 2 5 4\n2 5 quad 2 3 6 5\n3 1 line 1 4\n";

  const std::string vtk =
    "# vtk DataFile Version 2.0\nsquares\nASCII\nDATASET UNSTRUCTURED_GRID\n"
    "POINTS 6 float\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\nCELLS 3 13\n"
    "4 0 1 4 3\n4 1 2 5 4\n2 0 3\nCELL_TYPES 3\n9\n9\n3\nCELL_DATA 3\n"
    "SCALARS material int 1\nLOOKUP_TABLE default\n5\n5\n1\n";

  const std::string triangles =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n" + grid +
    "$EndNodes\n$Elements\n4\n1 1 2 1 1 1 4\n2 2 2 7 1 1 2 4\n"
    "3 2 2 7 1 2 5 4\n4 3 2 7 1 2 3 6 5\n$EndElements\n";

  // two blocks of one part, one beside the other and tied
  const std::string parts =
    "*PART, NAME=P\n*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n"
    "*ELEMENT, TYPE=CPS4, ELSET=all\n1, 1, 2, 3, 4\n*SURFACE, NAME=r\nall, S2\n"
    "*SURFACE, NAME=l\nall, S4\n*END PART\n*ASSEMBLY, NAME=A\n"
    "*INSTANCE, NAME=a, PART=P\n*END INSTANCE\n*INSTANCE, NAME=b, PART=P\n"
    "1, 0, 0\n0, 0, 0, 0, 0, 1, 0\n*END INSTANCE\n*END ASSEMBLY\n"
    "*TIE, NAME=t\nb.l, a.r\n";

  class Mutator
  {
  public:
    explicit Mutator(const unsigned int seed)
      : random(seed)
    {}

    std::string
    operator()(std::string text)
    {
      const std::size_t n_changes = 1 + below(3);
      for (std::size_t i = 0; i < n_changes && !text.empty(); ++i)
        change(text);
      return text;
    }

  private:
    std::size_t
    below(const std::size_t n)
    {
      return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    }

    void
    change(std::string &text)
    {
      const std::size_t place  = below(text.size());
      const std::size_t length = std::min(text.size() - place, 1 + below(20));
      switch (below(6))
      {
        case 0:
          text[place] = static_cast<char>(below(256));
          break;
        case 1:
          text.erase(place, length);
          break;
        case 2:
          text.insert(place, text.substr(below(text.size()), length));
          break;
        case 3:
          text.resize(place);
          break;
        case 4: // lines change places
        {
          const std::size_t end = text.find('\n', place);
          if (end == std::string::npos)
            break;
          const std::string line = text.substr(place, end - place + 1);
          text.erase(place, line.size());
          text.insert(text.empty() ? 0 : below(text.size()), line);
          break;
        }
        default: // a number becomes another
        {
          static const char *numbers[] = {"0",
                                          "-1",
                                          "2",
                                          "5",
                                          "2147483647",
                                          "2147483648",
                                          "99999999999999999999",
                                          "1e308",
                                          "nan",
                                          "0.5",
                                          "1e-300"};
          const std::size_t  begin = text.find_first_of("0123456789", place);
          if (begin == std::string::npos)
            break;
          const std::size_t end =
            std::min(text.size(), text.find_first_not_of("0123456789", begin));
          text.replace(begin, end - begin, numbers[below(11)]);
        }
      }
    }

    std::mt19937 random;
  };

  // Whether it was read
  template <int dim>
  bool
  try_to_read(const std::string &text, const std::string &key)
  {
    try
    {
      const MeshScan             scan = scan_mesh(text, dim, true);
      dealii::Triangulation<dim> triangulation;
      MeshBuilder<dim>           builder(scan.contents);
      builder.build(triangulation);
      builder.set_boundary_ids({{key, "it", 1}}, triangulation);
      EXPECT_GT(triangulation.n_active_cells(), 0u) << text;
      return true;
    }
    catch (const MeshProblem &error)
    {
      const std::string problem = error.what();
      EXPECT_EQ(problem.find('\n'), std::string::npos) << problem;
      EXPECT_LT(problem.size(), 600u) << problem;
      return false;
    }
  }

  template <int dim>
  void
  mutate(const std::string &name,
         const std::string &text,
         const std::string &key)
  {
    ASSERT_TRUE(try_to_read<dim>(text, key)) << name;
    const char        *wanted = std::getenv("MIXED_CRACKS_MUTATIONS");
    const unsigned int n      = wanted != nullptr ? std::atoi(wanted) : 60;
    unsigned int       n_read = 0;
    for (unsigned int seed = 0; seed < n; ++seed)
    {
      const std::string mutant = Mutator(seed)(text);
      try
      {
        n_read += try_to_read<dim>(mutant, key);
      }
      catch (const std::exception &error)
      {
        ADD_FAILURE() << name << ", seed " << seed << ": " << error.what()
                      << '\n'
                      << mutant;
      }
    }
    EXPECT_LT(n_read, n) << name;
    if (wanted != nullptr)
      std::cout << name << ": " << n << " mutations, " << n_read << " read, "
                << n - n_read << " refused" << std::endl;
  }
} // namespace



TEST(MeshFileMutations, AreReadOrRefused)
{
  mutate<2>("Gmsh 2.2", gmsh2, "1");
  mutate<2>("Gmsh 4.1", gmsh4, "1");
  mutate<2>("Abaqus", abaqus, "Top");
  mutate<2>("UCD", ucd, "1");
  mutate<2>("VTK", vtk, "1");
  mutate<2>("triangles", triangles, "1");
  mutate<2>("parts", parts, "b.r");
}



TEST(MeshFileMutations, OfHexahedraToo)
{
  const auto cubes = GeometryTests::unit_cubes(2, 2);
  mutate<3>("Gmsh 2.2, 3-d", cubes.gmsh2(), "1");
  mutate<3>("Abaqus, 3-d", cubes.abaqus(), "SS1");
  mutate<3>("UCD, 3-d", cubes.ucd(), "2");
}
