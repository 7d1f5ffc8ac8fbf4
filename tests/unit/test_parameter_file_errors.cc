// SPDX-License-Identifier: GPL-2.0-or-later
#include "parameter_file_fixture.h"

#include <algorithm>

namespace MixedCracks
{
  namespace
  {
    const std::string strip =
      "subsection Geometry\nsubsection Punctured strip\n";
    const std::string ends = "\nend\nend\n";
  } // namespace

  class ParameterFileErrors : public ParameterFileFixture
  {};

  TEST_F(ParameterFileErrors, UnknownNames)
  {
    expect("\n" + strip + "set Hole radis = 1" + ends,
           {"case.prm:4: unknown entry 'Hole radis' in "
            "Geometry/Punctured strip; did you mean 'Hole radius'?",
            "Hole radius, Hole center."});
    expect("set Hole radius = 1\n",
           {"case.prm:1", "it belongs in Geometry/Punctured strip"});
    expect("set Young modulus = 1\n",
           {"did you mean 'Model/Young's modulus'?"});
    expect("set Geometry = strip\n", {"it is a subsection"});
    expect("set title = x\n", {"did you mean 'Title'?"});
    expect("subsection Geometri\nset Name = x\nset y = z\nend\n",
           {"case.prm:1: unknown subsection 'Geometri' in the top level; did "
            "you mean 'Geometry'?"});
    expect("subsection Punctured strip\nend\n", {"it belongs in Geometry"});
    expect("subsection Title\nend\n", {"it is an entry"});
    expect("subsection xyzabc\nend\n",
           {"Subsections of the top level: Geometry, Mesh, Model."});
  }

  TEST_F(ParameterFileErrors, OneMistakeOneMessage)
  {
    const std::string message = message_for(
      "subsection Geometri\n subsection Deeper\n set Name = x\n end\n"
      " set y = z\nend\nset Title = a\n");
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    const std::string missing_end =
      message_for("subsection Geometry\n set Name = rectangle\n"
                  "subsection Mesh\n set Global refinements = 1\nend\n"
                  "subsection Model\n set Mixed = true\nend\n");
    EXPECT_EQ(missing_end.find('\n'), std::string::npos) << missing_end;
    EXPECT_NE(missing_end.find("case.prm:3"), std::string::npos);
    EXPECT_NE(missing_end.find("'end' of subsection 'Geometry'"),
              std::string::npos);
    EXPECT_NE(missing_end.find("case.prm:1"), std::string::npos);
  }

  TEST_F(ParameterFileErrors, ValuesThatAreNotAllowed)
  {
    for (const std::string value :
         {"four", "nan", "inf", "1e999", "-1", "1,5", "4 mm", "0x10"})
      expect(strip + "set Hole radius = " + value + ends,
             {"case.prm:3: Geometry/Punctured strip/Hole radius: found '" +
                value + "'",
              "expected a number, at least 0."});
    expect(strip + "set Hole radius = " + ends,
           {"Hole radius: no value; expected a number"});
    for (const std::string value : {"1", "1, 2, 3", "1, x", "1, nan", "1,,2"})
      expect(
        strip + "set Hole center = " + value + ends,
        {"found '" + value + "'", "2 values separated by ',', each a number"});
    for (const std::string value : {"-1", "11", "2.5", "two", "99999999999"})
      expect("subsection Mesh\nset Global refinements = " + value + "\nend\n",
             {"Mesh/Global refinements: found '" + value + "'",
              "a whole number between 0 and 10"});
    expect("subsection Model\nset Mixed = yes\nend\n", {"true or false"});
    expect("subsection Model\nset Residual stiffness = 2\nend\n",
           {"a number between 0 and 1"});
    expect("subsection Geometry\nset Name = slit sqare\nend\n",
           {"case.prm:2: Geometry/Name: unknown 'slit sqare'; did you mean "
            "'slit square'?",
            "rectangle, slit square, punctured strip"});
    expect("subsection Model\nset Cracks = refused\nend\n",
           {"case.prm:2: Model/Cracks: refused by its owner."});
  }

  TEST_F(ParameterFileErrors, LinesThatAreMalformed)
  {
    expect("Title = x\n", {"case.prm:1", "is 'set' missing"});
    expect("set Title x\n", {"case.prm:1", "'set ENTRY = VALUE'"});
    expect("set = x\n", {"'set ENTRY = VALUE'"});
    expect("set\n", {"'set ENTRY = VALUE'"});
    expect("[Geometry]\n", {"cannot understand '[Geometry]'"});
    expect("{\"Geometry\": 1}\n", {"cannot understand"});
    expect("<xml/>\n", {"cannot understand"});
    expect("setTitle\n", {"cannot understand"});
    expect("subsection\nend\n", {"found no name"});
    expect("subsection Mesh\nend Mesh\n", {"case.prm:2", "stands alone"});
    expect("set Title = a\nend\n", {"case.prm:2", "without a subsection"});
    expect("subsection Mesh\n",
           {"case.prm:1: the 'end' of subsection 'Mesh' is missing"});
    expect("\nset Title = a \\\n", {"case.prm:2", "backslash"});
  }

  TEST_F(ParameterFileErrors, NothingIsSetTwice)
  {
    expect("set Title = a\n\nset Title = b\n",
           {"case.prm:3: Title is set twice, first in line 1"});
    expect("subsection Mesh\nset Global refinements = 1\nend\n"
           "subsection Mesh\nset Global  refinements = 1\nend\n",
           {"case.prm:5: Mesh/Global refinements is set twice", "line 2"});
  }

  TEST_F(ParameterFileErrors, OverridesThatFail)
  {
    const std::string good  = "set Title = a\n";
    const auto        fails = [&](const std::string              &text,
                           const std::vector<std::string> &parts) {
      expect(good, parts, {text});
      EXPECT_EQ(message_for(good, {text}).compare(0, 5, "--set"), 0);
    };
    fails("Mesh/Global refinements", {"Entry=value"});
    fails("", {"Entry=value"});
    fails("=3", {"Entry=value"});
    fails("/=3", {"Entry=value"});
    fails("Mesh/Global refinement=3", {"did you mean 'Global refinements'?"});
    fails("Mehs/Global refinements=3", {"did you mean 'Mesh'?"});
    fails("Global refinements=3", {"it belongs in Mesh"});
    fails("Geometry/Punctured/Hole radius=3", {"in Geometry"});
    fails("Geometry/Punctured strip/Hole radius=-3",
          {"Geometry/Punctured strip/Hole radius: found '-3'", "at least 0"});
    fails("Geometry=3", {"it is a subsection"});
    fails("Mesh/Global refinements=", {"no value"});
    fails("Title=a # b", {"cannot hold '#'"});
    fails("Title=a\nset x = b", {"line break"});
    fails("Title=a\\", {"backslash"});
    expect(good, {"Title is set twice by --set"}, {"Title=a", "Title=b"});
  }

  TEST_F(ParameterFileErrors, MistakesAreShownTogether)
  {
    const std::string two = message_for("set Titel = a\nsubsection Mesh\n"
                                        "set Global refinements = x\nend\n",
                                        {"Titel=b"});
    EXPECT_NE(two.find("case.prm:1: "), std::string::npos) << two;
    EXPECT_NE(two.find("\ncase.prm:3: "), std::string::npos) << two;
    EXPECT_NE(two.find("\n--set "), std::string::npos) << two;

    std::string many;
    for (int i = 0; i < 25; ++i)
      many += "nonsense\n";
    const std::string message = message_for(many);
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 10);
    EXPECT_NE(message.find("... and 15 more"), std::string::npos);
  }

} // namespace MixedCracks
