// SPDX-License-Identifier: GPL-2.0-or-later
// What is written about cracks, and what a resumed run keeps of it.
#include "files_of_test.h"

#include <base/errors.h>

#include <output/crack_path_file.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;
using dealii::Point;

namespace
{
  class CrackPathFiles : public FilesOfTest
  {
  protected:
    CrackPathFiles()
      : FilesOfTest("crack_path")
    {}

    CrackPathFile file{directory, 0.03};
  };

  // from the notch to the right
  Crack
  crack_to(const double x)
  {
    Crack crack;
    crack.points     = {{3., 3.}, {x, 3.}};
    crack.length     = x - 3.;
    crack.kink_angle = 1. / 3.;
    crack.start      = {CrackEnd::Kind::boundary, "notch"};
    return crack;
  }

  const std::string header =
    "step,time_s,displacement_mm,crack,length_mm,kink_angle_deg,start,end,"
    "tip_x_mm,tip_y_mm,point,x_mm,y_mm,arc_length_mm\n";
  const std::string rows_of_step_2 =
    "2,0.1,0.02,0,1.5,0.3333333333,notch,,4.5,3,0,3,3,0\n"
    "2,0.1,0.02,0,1.5,0.3333333333,notch,,4.5,3,1,4.5,3,1.5\n";
} // namespace



TEST_F(CrackPathFiles, HoldARowPerPoint)
{
  file.add(1, 0.05, 0.01, {});
  EXPECT_EQ(content("crack_path.csv"), header);
  file.add(2, 0.1, 0.02, {crack_to(4.5)});
  EXPECT_EQ(content("crack_path.csv"), header + rows_of_step_2);
}



TEST_F(CrackPathFiles, LeaveOutAnAngleThatIsNone)
{
  Crack crack      = crack_to(4.5);
  crack.start      = {};
  crack.end        = {CrackEnd::Kind::boundary, "right"};
  crack.kink_angle = std::numeric_limits<double>::quiet_NaN();
  file.add(2, 0.1, 0.02, {crack});
  EXPECT_EQ(count("crack_path.csv", ",1.5,,,right,4.5,"), 2u);
}



TEST_F(CrackPathFiles, AreNotWrittenForPathsThatStay)
{
  file.add(2, 0.1, 0.02, {crack_to(4.5)});
  file.add(3, 0.2, 0.03, {crack_to(4.52)});
  EXPECT_EQ(content("crack_path.csv"), header + rows_of_step_2);
  EXPECT_FALSE(
    std::filesystem::exists(directory + "/crack_path/crack_path_000003.vtp"));
  // more than the tolerance from what was written, though not from step 3
  file.add(4, 0.3, 0.04, {crack_to(4.54)});
  EXPECT_EQ(count("crack_path.csv", "\n4,"), 2u);
  file.add(5, 0.4, 0.05, {crack_to(4.54), crack_to(9.)});
  EXPECT_EQ(count("crack_path.csv", "\n5,"), 4u);
}



TEST_F(CrackPathFiles, CanBeSeenInParaView)
{
  file.add(2, 0.1, 0.02, {crack_to(4.5), crack_to(6.)});
  file.add(7, 0.2, 0.03, {crack_to(5.)});
  EXPECT_EQ(count("crack_path.pvd", "<DataSet "), 2u);
  EXPECT_EQ(count("crack_path.pvd",
                  "timestep=\"0.2\" group=\"\" part=\"0\" "
                  "file=\"crack_path/crack_path_000007.vtp\""),
            1u);
  const std::string name = "crack_path/crack_path_000002.vtp";
  EXPECT_EQ(count(name, "NumberOfPoints=\"4\""), 1u);
  EXPECT_EQ(count(name, "NumberOfLines=\"2\""), 1u);
  EXPECT_EQ(count(name, "3 3 0\n4.5 3 0\n3 3 0\n6 3 0\n"), 1u);
  EXPECT_EQ(count(name, "\n0 1 2 3 \n"), 1u); // connectivity
  EXPECT_EQ(count(name, "\n2 4 \n"), 1u);     // offsets
  EXPECT_EQ(count(name, "\n1.5 3 \n"), 1u);   // lengths
  EXPECT_EQ(count(name, "\n0\n1.5\n0\n3\n"), 1u);
}



TEST_F(CrackPathFiles, EndWithTheOutcome)
{
  file.add(2, 0.1, 0.02, {crack_to(4.5)});
  Outcome through_hole;
  through_hole.kind  = Outcome::Kind::separated;
  through_hole.way   = Outcome::Way::through;
  through_hole.hole  = "hole";
  through_hole.start = "notch";
  file.finish(through_hole);
  EXPECT_EQ(content("crack_path.csv"),
            header + rows_of_step_2 +
              "# outcome: through hole; start: notch\n");
}



// Whatever has become of the files: lost, cut off, or gone on.
TEST_F(CrackPathFiles, AreRestoredFromTheRowsOfACheckpoint)
{
  file.add(2, 0.1, 0.02, {crack_to(4.5)});
  file.add(3, 0.2, 0.02, {crack_to(5.5), crack_to(7.)});
  const std::string rows = file.rows(), pvd = content("crack_path.pvd"),
                    vtp_2 = content("crack_path/crack_path_000002.vtp"),
                    vtp_3 = content("crack_path/crack_path_000003.vtp");
  EXPECT_EQ(content("crack_path.csv"), rows);
  file.add(10, 0.2, 0.03, {crack_to(8.)});
  Outcome arrested;
  arrested.kind = Outcome::Kind::arrested;
  file.finish(arrested);
  std::ofstream(directory + "/crack_path.csv") << "step,ti";
  std::filesystem::remove(directory + "/crack_path.pvd");
  std::filesystem::remove(directory + "/crack_path/crack_path_000002.vtp");
  std::ofstream(directory + "/crack_path/crack_path_000003.vtp") << "<?xml";
  CrackPathFile resumed(directory, 0.03);
  resumed.restore(rows);
  EXPECT_EQ(resumed.rows(), rows);
  EXPECT_EQ(content("crack_path.csv"), rows);
  EXPECT_EQ(content("crack_path.pvd"), pvd);
  EXPECT_EQ(content("crack_path/crack_path_000002.vtp"), vtp_2);
  EXPECT_EQ(content("crack_path/crack_path_000003.vtp"), vtp_3);
  // it remembers what was written last
  resumed.add(9, 0.15, 0.025, {crack_to(5.5), crack_to(7.)});
  EXPECT_EQ(content("crack_path.csv"), rows);
  resumed.add(10, 0.2, 0.03, {crack_to(6.)});
  EXPECT_EQ(count("crack_path.csv", "\n10,"), 2u);
  EXPECT_EQ(count("crack_path.pvd", "<DataSet "), 3u);
}



// Who has the old file open sees it whole.
TEST_F(CrackPathFiles, AreReplacedAndNotWrittenOver)
{
  file.add(2, 0.1, 0.02, {crack_to(4.5)});
  const std::string rows = file.rows(), pvd = content("crack_path.pvd");
  std::ifstream     old_rows(directory + "/crack_path.csv"),
    old_pvd(directory + "/crack_path.pvd");
  CrackPathFile resumed(directory, 0.03);
  resumed.restore("");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(old_rows), {}), rows);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(old_pvd), {}), pvd);
  EXPECT_EQ(content("crack_path.csv"), header);
}



TEST_F(CrackPathFiles, KeepNamesWithCommasTogether)
{
  Crack crack = crack_to(4.5);
  crack.end   = {CrackEnd::Kind::boundary, "right, \"upper\""};
  file.add(2, 0.1, 0.02, {crack});
  EXPECT_EQ(count("crack_path.csv", "notch,\"right, \"\"upper\"\"\",4.5,3,"),
            2u);
  CrackPathFile resumed(directory, 0.03);
  resumed.restore(file.rows());
  EXPECT_EQ(content("crack_path.csv"), file.rows());
  resumed.add(3, 0.2, 0.03, {crack});
  EXPECT_EQ(content("crack_path.csv"), file.rows());
}



TEST_F(CrackPathFiles, BeginAnewWhenThereIsNothingToRestore)
{
  file.restore("");
  EXPECT_EQ(content("crack_path.csv"), header);
}



TEST_F(CrackPathFiles, SayWhenTheyCannotBeWritten)
{
  CrackPathFile nowhere(directory + "/missing", 0.03);
  try
  {
    nowhere.add(1, 0., 0., {crack_to(4.)});
    ADD_FAILURE() << "a file in no directory";
  }
  catch (const FileError &error)
  {
    EXPECT_NE(std::string(error.what()).find("crack_path.csv"),
              std::string::npos);
  }
  EXPECT_THROW(nowhere.finish({}), FileError);
}
