// SPDX-License-Identifier: GPL-2.0-or-later
// The dimension, which is read before everything else.
#include <base/errors.h>

#include <input/dimension.h>
#include <input/parameter_file.h>
#include <input/parameter_manual.h>

#include <simulation/parameters.h>

#include <gtest/gtest.h>

#include <sstream>

using namespace MixedCracks;

namespace
{
  std::vector<SourceLine>
  source(const std::string &text)
  {
    std::vector<SourceLine> lines;
    std::istringstream      stream(text);
    unsigned int            number = 0;
    for (std::string line; std::getline(stream, line);)
    {
      ++number;
      const auto begin = line.find_first_not_of(' ');
      if (begin != std::string::npos)
        lines.push_back({"case.prm", number, line.substr(begin)});
    }
    return lines;
  }

  const std::string three = "subsection Geometry\n"
                            "  set Name = box\n"
                            "  set Dimension = 3\n"
                            "  subsection Box\n"
                            "    set Cells = 1, 1, 1\n"
                            "  end\n"
                            "end\n";

  template <int dim>
  std::string
  manual()
  {
    Parameters<dim>          parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    std::ostringstream out;
    print_parameters(out, prm, "json");
    return out.str();
  }

  // what check() says of a case in 3-d, empty when it accepts
  std::string
  problem(const std::string &text, const std::vector<std::string> &overrides)
  {
    Parameters<3>            parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    std::vector<std::string> all = overrides;
    all.insert(all.end(),
               {"Material/Lame lambda=1",
                "Material/Shear modulus=1",
                "Boundary conditions/Displacement=top : all : 0"});
    read_parameters(source(text), all, prm);
    try
    {
      parameters.check();
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }
} // namespace



TEST(Dimension, IsReadFromFileAndOverrides)
{
  EXPECT_EQ(chosen_dimension({}, {}), 2);
  EXPECT_EQ(chosen_dimension(source(three), {}), 3);
  EXPECT_EQ(chosen_dimension(source(three), {"Geometry/Dimension=2"}), 2);
  EXPECT_EQ(chosen_dimension({}, {"Geometry/Name=box", "Geometry/Dimension=3"}),
            3);
  // elsewhere the name means something else
  EXPECT_EQ(
    chosen_dimension(source("subsection Model\n set Dimension = 3\nend\n"), {}),
    2);
}



TEST(Dimension, LeavesMistakesToTheReading)
{
  EXPECT_EQ(chosen_dimension({}, {"Geometry/Dimension=4"}), 2);
  EXPECT_EQ(chosen_dimension({}, {"nonsense", "Geometry/Dimension=3"}), 3);
  EXPECT_EQ(chosen_dimension(source("set\nnonsense\n" + three), {}), 3);
  EXPECT_EQ(chosen_dimension(source(three + "end\n"), {}), 3);
}



TEST(Dimension, HasTheSameParametersIn2dAnd3d)
{
  EXPECT_EQ(manual<2>(), manual<3>());
}



TEST(Dimension, ChecksThatTheGeometryExists)
{
  EXPECT_EQ(problem(three, {}), "");
  for (const char *name : {"slit square", "rectangle"})
  {
    const std::string message =
      problem("", {std::string("Geometry/Name=") + name});
    EXPECT_NE(message.find("Geometry/Name: found '" + std::string(name)),
              std::string::npos)
      << message;
    EXPECT_NE(message.find("slit cube, box"), std::string::npos) << message;
  }
}



TEST(Dimension, ChecksWhatDependsOnIt)
{
  EXPECT_EQ(problem(three, {"Load stepping/Stop when separated=true"}), "");
  EXPECT_EQ(problem(three, {"Output/Events=all"}), "");
  EXPECT_EQ(problem(three, {"Output/Events=onset, crack area"}), "");
  EXPECT_NE(problem(three, {"Output/Events=onset, crack length"})
              .find("onset, crack area, boundary, separation"),
            std::string::npos);
  // refused in plane stress only
  EXPECT_EQ(problem(three, {"Model/Deviator dimension=3"}), "");
  EXPECT_NE(problem(three, {"Mesh/Refined boxes=0,0 : 1,1 : 1"})
              .find("point of 3 numbers"),
            std::string::npos);
  EXPECT_EQ(problem(three, {"Mesh/Refined boxes=0,0,0 : 1,1,0.5 : 1"}), "");
  EXPECT_NE(problem(three, {"Mesh/Refined discs=0,0,7 : 1 : 1"})
              .find("lies outside the domain"),
            std::string::npos);
}



TEST(Dimension, ThicknessCountsOnce)
{
  Parameters<2> plane;
  Parameters<3> body;
  plane.material.thickness = body.material.thickness = 3.;
  EXPECT_EQ(plane.thickness_factor(), 3.);
  EXPECT_EQ(body.thickness_factor(), 1.);

  dealii::ParameterHandler prm;
  body.add_parameters(prm);
  read_parameters(source(""), {"Material/Thickness=2.5"}, prm);
  EXPECT_EQ(body.geometry.chosen().extent()->upper_bound(2), 2.5);
}
