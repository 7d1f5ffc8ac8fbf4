// SPDX-License-Identifier: GPL-2.0-or-later
#include "parameter_file_fixture.h"

#include <input/parameter_tree.h>

namespace MixedCracks
{
  namespace
  {
    const std::string strip =
      "subsection Geometry\nsubsection Punctured strip\n";
    const std::string ends = "\nend\nend\n";
  } // namespace

  class ParameterFile : public ParameterFileFixture
  {};

  TEST_F(ParameterFile, ReadsEveryKind)
  {
    read("\xEF\xBB\xBF# a comment that ends with a backslash \\\n"
         "set Title = a strip, notched = yes   # trailing\r\n"
         "\n"
         "subsection Geometry\n"
         "\tset Name=punctured strip\n"
         "  subsection   Punctured   strip # comment\n"
         "    set Hole  radius   = 2.5e0\n"
         "    set Hole center = 1, \\   # first\n"
         "      # between\n"
         "      2\n"
         "  end\n"
         "END\n"
         "SUBSECTION Model\n"
         "  SET Young's modulus = 3.54\n"
         "  set Mixed = false\n"
         "  set Cracks =\n"
         "end");
    EXPECT_EQ(values.title, "a strip, notched = yes");
    EXPECT_EQ(values.name, "punctured strip");
    EXPECT_EQ(values.radius, 2.5);
    EXPECT_EQ(values.center, (std::vector<double>{1., 2.}));
    EXPECT_EQ(values.modulus, 3.54);
    EXPECT_FALSE(values.mixed);
    EXPECT_EQ(values.cracks, "");
    EXPECT_EQ(values.levels, 2);
  }

  TEST_F(ParameterFile, OverridesComeLast)
  {
    read(strip + "set Hole radius = 1" + ends,
         {"Geometry/Punctured strip/Hole radius=3",
          " Mesh / Global refinements = 5",
          "Title=",
          "Model/Cracks=a=b/c"});
    EXPECT_EQ(values.radius, 3.);
    EXPECT_EQ(values.levels, 5);
    EXPECT_EQ(values.title, "");
    EXPECT_EQ(values.cracks, "a=b/c");
  }

  TEST_F(ParameterFile, CommentsAloneAreAFile)
  {
    read("# all defaults\n");
    EXPECT_EQ(values.radius, 4.);
  }

  TEST_F(ParameterFile, Includes)
  {
    write("subsection Mesh\n set Global refinements = 3\nend\n"
          "include deeper/model.prm\n",
          "parts/base.prm");
    write("subsection Model\n set Mixed = false\nend\n",
          "parts/deeper/model.prm");
    read("include parts/base.prm   # relative to this file\n"
         "subsection Mesh\n set Global refinements = 4\nend\n");
    EXPECT_EQ(values.levels, 4);
    EXPECT_FALSE(values.mixed);
  }

  TEST_F(ParameterFile, IncludesThatFail)
  {
    expect("include\n", {"case.prm:1", "no file name"});
    expect("\ninclude case.prm\n", {"case.prm:2", "includes itself"});
    write("include ../case.prm\n", "parts/a.prm");
    expect("include parts/a.prm\n", {"a.prm:1", "includes itself"});
    write("subsection Mesh\n", "open.prm");
    expect("include open.prm\nend\n", {"case.prm:2", "open.prm:1"});
    write("\nset Titel = x\n", "typo.prm");
    expect("include typo.prm\n", {"typo.prm:2", "did you mean 'Title'?"});
    EXPECT_THROW(read("include missing.prm\n"), FileError);
    EXPECT_THROW(read("include .\n"), FileError);
  }

  TEST_F(ParameterFile, FilesThatCannotBeRead)
  {
    for (const std::filesystem::path &path :
         {directory / "missing.prm", directory, directory / "no" / "x.prm"})
      for (const MPI_Comm comm : {MPI_COMM_SELF, MPI_COMM_WORLD})
        try
        {
          read_parameters(path.string(), {}, values.prm, comm);
          ADD_FAILURE() << path;
        }
        catch (const FileError &error)
        {
          EXPECT_NE(std::string(error.what()).find("parameter file '"),
                    std::string::npos);
        }
  }

  TEST_F(ParameterFile, FilesThatAreNoText)
  {
    expect("", {"is empty"});
    expect(" \n\t\n", {"is empty"});
    expect(std::string("set Title = a\0b", 15), {"not a text file"});
    expect("\x7f"
           "ELF\x02\x01",
           {"not a text file"});
    expect("\x1f\x8b\x08 zip", {"not a text file"});
    expect(std::string(9U << 20U, 'a'), {"more than 8 MB"});
  }

  TEST_F(ParameterFile, NothingIsTouchedByABadFile)
  {
    EXPECT_THROW(read(strip + "set Hole radius = 1" + ends + "nonsense\n"),
                 InputError);
    EXPECT_EQ(values.radius, 4.);
    read(strip + "set Hole radius = 1" + ends);
    EXPECT_EQ(values.radius, 1.);
  }

  TEST(ParameterTree, ListsInTheOrderOfDeclaration)
  {
    const DeclaredValues values;
    const ParameterTree  tree(values.prm);
    ASSERT_EQ(tree.entries().size(), 9U);
    EXPECT_EQ(tree.entries()[0].full_name(), "Title");
    EXPECT_EQ(tree.entries()[1].full_name(), "Geometry/Name");
    EXPECT_EQ(tree.entries()[2].full_name(),
              "Geometry/Punctured strip/Hole radius");
    EXPECT_EQ(tree.entries()[2].value, "4");
    EXPECT_EQ(tree.entries()[2].default_value, "4");
    EXPECT_EQ(tree.entries()[2].documentation, "In mm.");
    EXPECT_NE(tree.find({"Model"}, "Young's modulus"), nullptr);
    EXPECT_EQ(tree.find({"Model"}, "Name"), nullptr);
    EXPECT_TRUE(tree.has_subsection({"Geometry", "Punctured strip"}));
    EXPECT_FALSE(tree.has_subsection({"Punctured strip"}));
  }

} // namespace MixedCracks
