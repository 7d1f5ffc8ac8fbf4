// SPDX-License-Identifier: GPL-2.0-or-later
//
//   regression_driver case.prm
//
// Runs a case as the program does and writes what a regression test compares,
// the physical columns of the statistics, to the file "output" in the working
// directory. Counts of iterations and times are left out: they may differ
// between machines although the answer is the same.
//
// The test macros of deal.II call numdiff with an absolute tolerance of 1e-6,
// and either tolerance suffices. So each column is divided by the power of ten
// that brings its largest magnitude to between 0.1 and 1: values then have to
// agree to 1e-6 to 1e-5 of the largest one in their column. Newton's method
// and the coupling are stopped by tolerances, and the order of sums depends on
// the machine; agreement to more digits means nothing.
#include <base/single_process.h>

#include <input/case_signature.h>
#include <input/dimension.h>
#include <input/parameter_file.h>
#include <input/parameter_manual.h>

#include <simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>

namespace
{
  using namespace MixedCracks;

  const std::vector<std::string> compared = {"time_s",
                                             "displacement_mm",
                                             "force_x_N",
                                             "force_y_N",
                                             "force_z_N",
                                             "elastic_energy_mJ",
                                             "crack_energy_mJ",
                                             "external_work_mJ",
                                             "min_phase_field",
                                             "max_phase_field_change",
                                             "cells",
                                             "dofs",
                                             "crack_volume_mm3"};

  // What is smaller than this in a whole column is rounding: 0.
  constexpr double negligible = 1e-6;
  // A column whose largest value is 1, as of an intact phase field, shall not
  // change its unit when that becomes 1 + 1e-12.
  constexpr double slightly_more = 1.0001;



  std::vector<std::string>
  cells_of(const std::string &line)
  {
    std::vector<std::string> cells;
    std::istringstream       stream(line);
    for (std::string cell; std::getline(stream, cell, ',');)
      cells.push_back(cell);
    return cells;
  }



  void
  write_column(std::ostream              &out,
               const std::string         &name,
               const std::vector<double> &values)
  {
    double largest = 0.;
    for (const double value : values)
      largest = std::max(largest, std::abs(value));
    const int exponent =
      largest < negligible
        ? 0
        : static_cast<int>(std::floor(std::log10(largest / slightly_more))) + 1;
    out << name << ", in units of 10^" << exponent << ":\n";
    for (const double value : values)
      out << format(
        "%.8f\n", largest < negligible ? 0. : value / std::pow(10., exponent));
  }



  void
  write_comparison(std::istream &statistics, std::ostream &out)
  {
    std::string line;
    std::getline(statistics, line);
    const std::vector<std::string>   names = cells_of(line);
    std::vector<std::vector<double>> columns(names.size());
    std::size_t                      n_steps = 0;
    for (; std::getline(statistics, line); ++n_steps)
    {
      const std::vector<std::string> cells = cells_of(line);
      for (std::size_t i = 0; i < cells.size() && i < names.size(); ++i)
        columns[i].push_back(std::stod(cells[i]));
    }
    out << n_steps << " rows\n";
    for (std::size_t i = 0; i < names.size(); ++i)
      if (std::find(compared.begin(), compared.end(), names[i]) !=
          compared.end())
        write_column(out, names[i], columns[i]);
  }



  // The outcome, and each crack of the last step.
  void
  write_cracks(std::istream &paths, std::ostream &out)
  {
    std::string line, names;
    std::getline(paths, names);
    std::vector<std::vector<std::string>> rows;
    while (std::getline(paths, line))
      if (line.rfind("#", 0) == 0)
        out << line.substr(2) << '\n';
      else
        rows.push_back(cells_of(line));
    for (std::size_t i = 0; i < rows.size(); ++i)
      // step, crack, length, tip: the same in all rows of a crack
      if (rows[i][0] == rows.back()[0] &&
          (i + 1 == rows.size() || rows[i + 1][3] != rows[i][3]))
        out << format("crack %s from '%s' to '%s', mm:\n%.3f\n%.3f\n%.3f\n",
                      rows[i][3].c_str(),
                      rows[i][6].c_str(),
                      rows[i][7].c_str(),
                      std::stod(rows[i][4]),
                      std::stod(rows[i][8]),
                      std::stod(rows[i][9]));
  }



  template <int dim>
  void
  run(const std::vector<SourceLine> &source)
  {
    Parameters<dim>          parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    read_parameters(source, {"Output/Directory=results"}, prm);
    parameters.check();
    std::ostringstream effective;
    print_parameters(effective, prm, "prm");

    RunOutcome outcome;
    {
      Log             log(/*active=*/false);
      Simulation<dim> simulation(
        parameters, effective.str(), case_signature(prm), MPI_COMM_WORLD, log);
      outcome = simulation.run(ExistingRun::overwrite);
    }
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
      return;
    std::ifstream statistics("results/statistics.csv");
    std::ofstream out("output");
    out << "exit status " << outcome.exit_status << ": " << outcome.reason
        << '\n';
    write_comparison(statistics, out);
    std::ifstream paths("results/crack_path.csv");
    write_cracks(paths, out);
  }
} // namespace



int
main(int argc, char **argv)
{
  prepare_single_process();
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
  {
    if (argc != 2)
      throw InputError("usage: regression_driver case.prm");
    const std::vector<SourceLine> source = read_source(argv[1], MPI_COMM_WORLD);
    if (chosen_dimension(source, {}) == 3)
      run<3>(source);
    else
      run<2>(source);
    return 0;
  }
  catch (const std::exception &error)
  {
    std::cerr << error.what() << std::endl;
    MPI_Abort(MPI_COMM_WORLD, 1);
    return 1;
  }
}
