// SPDX-License-Identifier: GPL-2.0-or-later
// Where the files are that a .prm names.
#include "parameter_file_fixture.h"

#include <input/parameter_paths.h>

using namespace MixedCracks;
namespace fs = std::filesystem;

namespace
{
  class ParameterPaths : public ParameterFileFixture
  {
  protected:
    // what an entry holds after reading
    std::string
    read(const std::string              &file,
         const std::vector<std::string> &overrides = {})
    {
      std::string              mesh;
      dealii::ParameterHandler prm;
      prm.add_parameter(
        "File name",
        mesh,
        "",
        dealii::Patterns::FileName(dealii::Patterns::FileName::input));
      read_parameters(
        (directory / file).string(), overrides, prm, MPI_COMM_SELF);
      return mesh;
    }

    void
    put(const std::string &name, const std::string &text)
    {
      fs::create_directories((directory / name).parent_path());
      std::ofstream(directory / name) << text;
    }
  };
} // namespace



TEST_F(ParameterPaths, AreRelativeToTheFileThatSetsThem)
{
  put("deep/case.prm", "set File name = ../meshes/body.msh\n");
  put("meshes/body.msh", "body\n");
  put("other/outer.prm", "include ../deep/case.prm\n");
  const fs::path expected = directory / "meshes" / "body.msh";
  EXPECT_EQ(read("deep/case.prm"), expected.lexically_normal().string());
  EXPECT_EQ(read("other/outer.prm"), expected.lexically_normal().string());
}



TEST_F(ParameterPaths, FallBackToTheWorkingDirectory)
{
  put("deep/case.prm", "set File name = body.msh\n");
  put("body.msh", "body\n");
  const fs::path before = fs::current_path();
  fs::current_path(directory);
  const std::string outside = read("deep/case.prm");
  put("deep/body.msh", "body\n");
  const std::string beside     = read("deep/case.prm");
  const std::string overridden = read("deep/case.prm", {"File name=body.msh"});
  fs::current_path(before);
  EXPECT_EQ(outside, (directory / "body.msh").string());
  EXPECT_EQ(beside, (directory / "deep" / "body.msh").string());
  EXPECT_EQ(overridden, (directory / "body.msh").string());
}



TEST_F(ParameterPaths, ThatAreAbsoluteOrEmptyStay)
{
  put("absolute.prm", "set File name = /no/such/../file.msh\n");
  put("empty.prm", "set File name =\n");
  EXPECT_EQ(read("absolute.prm"), "/no/such/../file.msh");
  EXPECT_EQ(read("empty.prm"), "");
  // named where it should have been
  put("missing.prm", "set File name = no.msh\n");
  EXPECT_EQ(read("missing.prm"), (directory / "no.msh").string());
}
