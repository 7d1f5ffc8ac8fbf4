// SPDX-License-Identifier: GPL-2.0-or-later
// Does a crack that a fluid opens converge to the exact solution? [Sneddon,
// Lowengrub 1969]
//
// A crack of length 2 in a square of 80 x 80 that is held all around: wide
// enough for its opening to be that in an unbounded body but for 0.1 %. The
// length scale is two cells, so that it goes to 0 with the mesh, and the
// smeared crack, longer than the sharp one by about a cell at each tip, gets
// its length. The cells halve from one row of the table to the next, and so
// shall the error.
#include <input/case_signature.h>
#include <input/parameter_file.h>
#include <input/parameter_manual.h>

#include <simulation/simulation.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

using namespace MixedCracks;

namespace
{
  namespace Files = std::filesystem;
  using dealii::numbers::PI;

  constexpr double pressure = 1e-3; // MPa

  struct Opened
  {
    double volume;    // mm^2
    double opening;   // in the middle, mm
    double imbalance; // of the energy, mJ
  };

  // a directory for a run, the same on all ranks
  class Directory
  {
  public:
    Directory()
      : path(dealii::Utilities::MPI::broadcast(
          MPI_COMM_WORLD,
          (Files::temp_directory_path() /
           ("mixed_cracks_sneddon_" + std::to_string(getpid())))
            .string()))
    {
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::ofstream(case_file())
          << "subsection Output\n  set Directory = " << path << "\nend\n";
      MPI_Barrier(MPI_COMM_WORLD);
    }

    std::string
    case_file() const
    {
      return path + ".prm";
    }

    ~Directory()
    {
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        Files::remove_all(path);
        Files::remove(case_file());
      }
    }

    const std::string path;
  };

  // 12 fine cells to all sides of the crack on each level
  std::string
  boxes(const unsigned int n_levels)
  {
    std::ostringstream text;
    for (unsigned int level = 1; level <= n_levels; ++level)
    {
      const double margin = 12. * 4. / std::pow(2., level);
      text << (level > 1 ? " ; " : "") << -1. - margin << ',' << -margin
           << " : " << 1. + margin << ',' << margin << " : " << level;
    }
    return text.str();
  }

  std::vector<std::string>
  entries(const bool mixed, const unsigned int n_levels)
  {
    return {"Geometry/Name=rectangle",
            "Geometry/Rectangle/Lower corner=-40,-40",
            "Geometry/Rectangle/Upper corner=40,40",
            "Geometry/Rectangle/Cell size=4",
            "Mesh/Refined boxes=" + boxes(n_levels),
            std::string("Model/Formulation=") +
              (mixed ? "mixed" : "displacement"),
            "Model/Kinematics=plane strain",
            "Model/Crack density=AT2",
            "Model/Energy split=none",
            std::string("Model/Pressure law=") +
              (mixed ? "relaxed bulk" : "degraded bulk"),
            "Model/Length scale=2*h",
            "Model/Residual stiffness=1e-8",
            "Material/Young's modulus=1",
            std::string("Material/Poisson ratio=") + (mixed ? "0.4999" : "0.2"),
            "Material/Critical energy release rate=1",
            "Fluid/Pressure=1e-3",
            std::string("Boundary conditions/Displacement=bottom : all : 0 ; "
                        "top : all : 0") +
              (mixed ? "" : " ; left : all : 0 ; right : all : 0"),
            "Initial cracks/Cracks=-1,0 : 1,0",
            "Initial cracks/Half width=h",
            "Load stepping/End time=1",
            "Load stepping/First step=1",
            "Load stepping/Largest step=1",
            "Load stepping/Onset step=1",
            "Load stepping/Smallest step=0.1",
            "Load stepping/Largest phase-field change=0",
            "Output/Crack volume=true",
            "Output/Crack opening=0,0 : 0,0 : 0,1 : 1"};
  }

  // number of the last line in a column with this name
  double
  number_in(const std::string &file_name, const std::string &column)
  {
    std::ifstream file(file_name);
    std::string   header, line, last;
    std::getline(file, header);
    while (std::getline(file, line))
      last = line;
    std::istringstream names(header), numbers(last);
    std::string        name, number;
    while (std::getline(names, name, ',') && std::getline(numbers, number, ','))
      if (name == column)
        return std::stod(number);
    throw std::runtime_error("no column " + column + " in " + header);
  }

  Opened
  solve(const std::vector<std::string> &case_entries)
  {
    const Directory          directory;
    Parameters<2>            parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    read_parameters(directory.case_file(), case_entries, prm, MPI_COMM_WORLD);
    parameters.check();
    Log           log(/*active=*/false);
    Simulation<2> simulation(
      parameters, "", case_signature(prm), MPI_COMM_WORLD, log);
    EXPECT_EQ(simulation.run(ExistingRun::overwrite).exit_status, 0);
    const std::string   statistics = directory.path + "/statistics.csv";
    std::vector<double> found(3, 0.);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      found = {number_in(statistics, "crack_volume_mm3"),
               number_in(statistics, "energy_imbalance_mJ"),
               number_in(directory.path + "/crack_opening.csv", "opening_mm")};
    found = dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, found);
    return {found[0], found[2], found[1]};
  }

  // relative errors on meshes with cells of 1/16, 1/32, 1/64 at the crack
  void
  expect_first_order(const bool   mixed,
                     const double poisson_ratio,
                     const double volume_error,
                     const double opening_error)
  {
    const double compliance = 1. - poisson_ratio * poisson_ratio; // 1/E'
    Opened       before{0., 0., 0.}, error{0., 0., 0.};
    for (const unsigned int n_levels : {6, 7, 8})
    {
      const Opened found = solve(entries(mixed, n_levels));
      before             = error;
      error = {found.volume / (2. * PI * pressure * compliance) - 1.,
               found.opening / (4. * pressure * compliance) - 1.,
               0.};
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << "h = 1/" << std::pow(2., n_levels - 2) << ": volume "
                  << found.volume << " (" << 100. * error.volume
                  << " %), opening " << found.opening << " ("
                  << 100. * error.opening << " %)\n";
      EXPECT_GT(error.volume, 0.);
      if (n_levels == 6)
        continue;
      EXPECT_LT(error.volume, 0.56 * before.volume);
      EXPECT_LT(error.opening, 0.56 * before.opening);
    }
    EXPECT_LT(error.volume, volume_error);
    EXPECT_LT(error.opening, opening_error);
  }
} // namespace



TEST(Sneddon, ConvergesInTheDisplacementFormulation)
{
  expect_first_order(/*mixed=*/false, 0.2, 0.04, 0.025);
}



TEST(Sneddon, ConvergesWhenNearlyIncompressible)
{
  expect_first_order(/*mixed=*/true, 0.4999, 0.14, 0.08);
}



TEST(Sneddon, StoresTheWorkOfTheFluid)
{
  // A pressure that rises in three steps opens a crack that does not grow: the
  // toughness keeps the phase field where it is but for 1e-8, and the response
  // is linear. (Tougher, rounding of the crack energy would spoil the balance.)
  for (const bool mixed : {false, true})
  {
    std::vector<std::string> rising = entries(mixed, 5);
    for (std::string &entry : rising)
    {
      if (entry == "Fluid/Pressure=1e-3")
        entry = "Fluid/Pressure=1e-3*t*(1+0.3*x)";
      if (entry == "Load stepping/First step=1")
        entry = "Load stepping/First step=0.4";
      if (entry == "Material/Critical energy release rate=1")
        entry = "Material/Critical energy release rate=30";
    }
    const Opened found = solve(rising);
    const double work  = 0.5 * pressure * found.volume;
    EXPECT_GT(work, 0.9 * 0.5 * pressure * 2. * PI * pressure * 0.75);
    EXPECT_LT(std::abs(found.imbalance), 1e-6 * work) << (mixed ? "mixed" : "");
  }
}
