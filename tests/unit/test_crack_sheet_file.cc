// SPDX-License-Identifier: GPL-2.0-or-later
// Files on cracks in space: what they hold, when rows are added, and what a
// resumed run makes of them; speed and opening angle at fronts.
#include "files_of_test.h"
#include "imposed_sheets.h"

#include <base/errors.h>

#include <output/crack_sheet_file.h>
#include <output/crack_sheet_writer.h>
#include <output/front_opening.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  // a square from x = 0 to x = end
  std::vector<CrackSheet>
  square(const double end)
  {
    CrackSheet sheet;
    sheet.vertices = {{0., 0., 0.}, {end, 0., 0.}, {end, 0., 1.}, {0., 0., 1.}};
    sheet.normals  = std::vector<Tensor<1, 3>>(4, Tensor<1, 3>({0., 1., 0.}));
    sheet.triangles  = {{{0, 2, 1}}, {{0, 3, 2}}};
    sheet.area       = end;
    sheet.boundaries = {"back", "left, lower"};
    sheet.start      = "left, lower";
    CrackFront front;
    for (const double z : {0., 0.5, 1.})
      front.points.push_back(
        {{end, 0., z}, Tensor<1, 3>({0., 1., 0.}), Tensor<1, 3>({1., 0., 0.})});
    front.length = 1.;
    sheet.fronts = {front};
    return {sheet};
  }

  class CrackSheetFiles : public FilesOfTest
  {
  protected:
    CrackSheetFiles()
      : FilesOfTest("crack_sheet")
    {}

    // as the writer does
    void
    add(CrackSheetFile                &file,
        const unsigned int             step,
        const std::vector<CrackSheet> &sheets,
        const std::vector<CrackSheet> &earlier = {}) const
    {
      if (file.differs(sheets))
        file.add(step,
                 0.5 * step,
                 0.1 * step,
                 sheets,
                 front_rows(sheets, all_fronts(earlier), 0.5));
    }
  };
} // namespace



TEST_F(CrackSheetFiles, HaveARowPerCrackAndPerPointOfAFront)
{
  CrackSheetFile file(directory, 0.1);
  file.open();
  add(file, 1, {});
  EXPECT_EQ(count("crack_sheet.csv", "\n"), 1u);
  add(file, 2, square(1.));
  add(file, 3, square(1.05), square(1.)); // not far enough
  add(file, 4, square(1.25), square(1.05));
  EXPECT_EQ(count("crack_sheet.csv", "\n"), 3u);
  EXPECT_EQ(count("crack_front.csv", "\n"), 7u);
  EXPECT_NE(content("crack_sheet.csv")
              .find("\n2,1,0.2,0,1,1,\"left, lower\",\"left, lower to back to "
                    "tip\",0.5,0,0.5,0,1,0,,,\n"),
            std::string::npos)
    << content("crack_sheet.csv");
  // 0.2 mm in 0.5 s
  EXPECT_NE(content("crack_sheet.csv").find("\n4,2,0.4,0,1.25,"),
            std::string::npos);
  EXPECT_EQ(count("crack_front.csv", ",0.4,\n"), 3u)
    << content("crack_front.csv");
  EXPECT_EQ(count("crack_sheet/crack_sheet_000004.vtp",
                  "NumberOfPoints=\"4\" NumberOfPolys=\"2\""),
            1u);
  EXPECT_EQ(count("crack_front/crack_front_000004.vtp",
                  "NumberOfPoints=\"3\" NumberOfLines=\"1\""),
            1u);
  for (const std::string name : {"crack_sheet", "crack_front"})
    EXPECT_EQ(count(name + ".pvd", "<DataSet "), 2u);
  Outcome outcome;
  outcome.kind  = Outcome::Kind::arrested;
  outcome.start = "left";
  file.finish(outcome);
  EXPECT_EQ(count("crack_sheet.csv", "\n# outcome: arrested; start: left\n"),
            1u);
}



TEST_F(CrackSheetFiles, AreWholeAgainInAResumedRun)
{
  std::string sheets, fronts, front_file;
  {
    CrackSheetFile file(directory, 0.1);
    file.open();
    add(file, 2, square(1.));
    add(file, 4, square(1.25), square(1.));
    sheets     = file.sheet_rows();
    fronts     = file.front_rows();
    front_file = content("crack_front/crack_front_000002.vtp");
    // steps behind the checkpoint
    add(file, 5, square(1.7), square(1.25));
  }
  std::filesystem::remove(directory + "/crack_front/crack_front_000002.vtp");
  std::filesystem::remove(directory + "/crack_sheet/crack_sheet_000002.vtp");
  std::ofstream(directory + "/crack_sheet.csv") << "cut o";
  CrackSheetFile file(directory, 0.1);
  file.restore(sheets, fronts);
  EXPECT_EQ(content("crack_sheet.csv"), sheets);
  EXPECT_EQ(content("crack_front.csv"), fronts);
  EXPECT_EQ(content("crack_front/crack_front_000002.vtp"), front_file);
  EXPECT_EQ(count("crack_front.pvd", "<DataSet "), 2u);
  // what is not there is not listed
  EXPECT_EQ(count("crack_sheet.pvd", "<DataSet "), 1u);
  // compared with what was written last
  EXPECT_FALSE(file.differs(square(1.25)));
  EXPECT_FALSE(file.differs(square(1.3)));
  EXPECT_TRUE(file.differs(square(1.4)));
}



TEST_F(CrackSheetFiles, SayWhatCannotBeWritten)
{
  CrackSheetFile file(directory + "/nowhere", 0.1);
  try
  {
    file.open();
    ADD_FAILURE() << "a file in no directory";
  }
  catch (const FileError &error)
  {
    EXPECT_NE(std::string(error.what()).find("crack_sheet.csv"),
              std::string::npos);
  }
}



// faces that part by 2 s (x - end) behind the front, beyond what is broken
TEST(FrontOpening, IsTheAngleBetweenTheFaces)
{
  constexpr double l = 0.2, end = 0.83, s = 0.01;
  for (const bool mixed : {false, true})
  {
    ImposedSheet body({{1.2, 1., 0.6}}, 0.1, l, "AT2", [](const Point<3> &x) {
      return std::hypot(x[1] - 0.5, std::max(0., x[0] - end));
    });
    Fields<3>    fields(body.mesh, {mixed, mixed ? 2u : 1u});
    fields.distribute();
    LinearAlgebra::Vector owned = fields.owned_vector(fields.elastic_dofs);
    std::vector<std::function<double(const Point<3> &)>> components(
      fields.elastic.get_fe().n_components(),
      [](const Point<3> &) { return 7.; }); // of a rigid motion
    components[1] = [](const Point<3> &x) {
      return s * (end - x[0]) * std::clamp((x[1] - 0.5) / 0.1, -1., 1.);
    };
    dealii::VectorTools::interpolate(
      fields.mapping,
      fields.elastic,
      dealii::FunctionFromFunctionObjects<3>(components),
      owned);
    LinearAlgebra::Vector elastic = fields.ghosted_vector(fields.elastic_dofs);
    elastic                       = owned;
    const TracedCracks        cracks = body.trace();
    const std::vector<double> angles =
      opening_angles(fields, elastic, cracks.sheets, l);
    if (!is_first_rank())
      continue;
    ASSERT_EQ(cracks.sheets.size(), 1u);
    ASSERT_GT(angles.size(), 4u);
    const auto &points = cracks.sheets[0].fronts[0].points;
    ASSERT_EQ(points.size(), angles.size());
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
      // 2 l behind the front that was found
      const double w =
        2. * s * (end - points[i].position[0] + 2. * l * points[i].ahead[0]);
      EXPECT_NEAR(angles[i], 2. * std::atan(w / (4. * l)) * 180. / M_PI, 0.05)
        << i;
      EXPECT_NEAR(angles[i], 2. * s * 180. / M_PI, 0.15);
    }
  }
}
