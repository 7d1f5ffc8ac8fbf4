// SPDX-License-Identifier: GPL-2.0-or-later
//
//   linear_solvers study [options]
//
// Iterations, seconds and memory of the linear solvers on a square or cube
// that is pulled apart; doc/solvers.md has the tables and the commands. Prints
// one row of a Markdown table per system. Memory: what the solver adds per
// unknown, resident after the solution and at its peak; of a second solver in
// the same process it lacks what the first one has left to the allocator.
//
//   studies: sizes (uniform meshes), adaptive, incompressibility (lambda/mu),
//            damage (kappa, intact to broken), orderings (of MUMPS),
//            beside (both solvers on uniform meshes, one row for both),
//            products (block AMG with its matrix and without),
//            throughput (of products, beside the bandwidth of the memory)
//   --dim 2|3  --largest UNKNOWNS  --smallest UNKNOWNS  --displacement
//   --solver "block AMG"|direct|both  --worst (broken through, kappa = 1e-6)
//   --tolerance 1e-8  --random (right hand side)
//   --passes N (of set-up and solution in products; the last is measured)
//   --levels N (adaptive ones of the study; 4, in 3-d 2)
//   --orderings AMD,PORD,METIS (of the study; without: all)
#include "measurement.h"

#include <base/log.h>

#include <solvers/assembled_product.h>
#include <solvers/direct_solver.h>
#include <solvers/mumps.h>

#include <random>

namespace
{
  using namespace MixedCracks;
  using namespace MixedCracks::Testing;

  struct Arguments
  {
    std::string study;
    std::string solver = "block AMG";
    std::string orderings;
    int         dim       = 2;
    double      smallest  = 1e4;
    double      largest   = 3e5;
    bool        mixed     = true;
    bool        worst     = false;
    bool        random    = false;
    double      tolerance = 1e-8;
    int         passes    = 1;
    int         levels    = 0; // 0: that of the dimension
  };

  Arguments
  read(const int argc, char **argv)
  {
    Arguments result;
    if (argc < 2)
      throw InputError("usage: linear_solvers study [options]");
    result.study = argv[1];
    for (int i = 2; i < argc; ++i)
    {
      const std::string option = argv[i];
      if (option == "--displacement")
        result.mixed = false;
      else if (option == "--worst")
        result.worst = true;
      else if (option == "--random")
        result.random = true;
      else if (i + 1 == argc)
        throw InputError("a value is missing after " + option);
      else if (option == "--dim")
        result.dim = std::stoi(argv[++i]);
      else if (option == "--largest")
        result.largest = std::stod(argv[++i]);
      else if (option == "--smallest")
        result.smallest = std::stod(argv[++i]);
      else if (option == "--solver")
        result.solver = argv[++i];
      else if (option == "--orderings")
        result.orderings = argv[++i];
      else if (option == "--levels")
        result.levels = std::stoi(argv[++i]);
      else if (option == "--passes")
        result.passes = std::stoi(argv[++i]);
      else if (option == "--tolerance")
        result.tolerance = std::stod(argv[++i]);
      else
        throw InputError("unknown option " + option);
    }
    return result;
  }



  std::string
  in_words(const ElasticSystemOptions &options)
  {
    const std::string damage = options.damage == Damage::none   ? "intact"
                               : options.damage == Damage::half ? "half"
                                                                : "through";
    return format("%u levels + %u | %s | %.0e | %.0e",
                  options.refinements,
                  options.adaptive_levels,
                  damage.c_str(),
                  options.lambda / options.mu,
                  options.kappa);
  }



  template <int dim>
  void
  print_row(const ElasticSystem<dim> &system, const Measurement &measured)
  {
    print(format("| %d | %u | %u | %s | %s | %u | %.2f | %.2f | %.2f | %.2f | "
                 "%.2f |",
                 dim,
                 dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                 static_cast<unsigned int>(system.fields.elastic.n_dofs()),
                 in_words(system.options).c_str(),
                 measured.solver.c_str(),
                 measured.iterations,
                 measured.analysis,
                 measured.setup,
                 measured.solve,
                 measured.resident,
                 measured.peak));
  }



  // of the size of the present one, displacements and pressures apart
  template <int dim>
  void
  randomize(ElasticSystem<dim> &system)
  {
    const auto   is_pressure = system.system().is_pressure;
    auto        &vector      = system.right_hand_side;
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> random(-1., 1.);
    double                                 largest[] = {0., 0.};
    for (std::size_t i = 0; i < is_pressure.size(); ++i)
      largest[is_pressure[i]] =
        std::max(largest[is_pressure[i]], std::abs(vector.begin()[i]));
    for (double &value : largest)
      value = dealii::Utilities::MPI::max(value, MPI_COMM_WORLD);
    for (std::size_t i = 0; i < is_pressure.size(); ++i)
      vector.begin()[i] = largest[is_pressure[i]] * random(generator);
    system.constraints.elastic_corrections().set_zero(vector);
  }



  template <int dim>
  void
  measure(const ElasticSystemOptions &options, const Arguments &arguments)
  {
    ElasticSystem<dim> system(options);
    if (arguments.random)
      randomize(system);
    for (const std::string name : {"block AMG", "direct", "matrix-free"})
      if (arguments.solver == name ||
          (arguments.solver == "both" && name != "matrix-free"))
        print_row(system, measure<dim>(name, system, arguments.tolerance));
  }



  // unknowns of a uniform mesh, about
  double
  n_unknowns(const int dim, const bool mixed, const unsigned int refinements)
  {
    const double cells = std::pow(2., dim * refinements);
    if (!mixed)
      return dim * cells;
    return cells * (dim * std::pow(2., dim) + 1.);
  }



  unsigned int
  refinements_for(const Arguments &arguments, const double unknowns)
  {
    unsigned int result = 1;
    while (n_unknowns(arguments.dim, arguments.mixed, result + 1) <=
           1.01 * unknowns)
      ++result;
    return result;
  }



  ElasticSystemOptions
  basic(const Arguments &arguments)
  {
    ElasticSystemOptions options;
    options.mixed       = arguments.mixed;
    options.degree      = arguments.mixed ? 2 : 1;
    options.lambda      = arguments.mixed ? 1000. : 1.;
    options.refinements = refinements_for(arguments, arguments.largest);
    options.kappa       = arguments.worst ? 1e-6 : 1e-4;
    options.damage      = arguments.worst ? Damage::through : Damage::half;
    options.matrix_free = arguments.solver == "matrix-free";
    options.with_matrix = !options.matrix_free;
    return options;
  }



  // Uniform meshes from the smallest to the largest size asked for.
  template <typename Body>
  void
  for_each_size(const Arguments &arguments, const Body &body)
  {
    ElasticSystemOptions options = basic(arguments);
    const unsigned int   last    = options.refinements;
    for (options.refinements = refinements_for(arguments, arguments.smallest);
         options.refinements <= last;
         ++options.refinements)
      body(options);
  }



  template <int dim>
  void
  study_sizes(const Arguments &arguments, const unsigned int adaptive_levels)
  {
    ElasticSystemOptions options = basic(arguments);
    options.adaptive_levels      = adaptive_levels;
    // a few levels less, which the adaptive ones make up for
    const unsigned int less =
      adaptive_levels == 0 ? 0 : (dim == 2 ? 1 : adaptive_levels);
    const unsigned int last =
      options.refinements - std::min(less, options.refinements - 1);
    unsigned int first = refinements_for(arguments, arguments.smallest);
    first -= std::min(less, first - 1);
    for (options.refinements = first; options.refinements <= last;
         ++options.refinements)
      measure<dim>(options, arguments);
  }



  // as the table of doc/solvers.md has it
  template <int dim>
  void
  study_beside(const Arguments &arguments)
  {
    for_each_size(arguments, [&](ElasticSystemOptions options) {
      ElasticSystem<dim> system(options);
      const Measurement  amg =
        measure<dim>("block AMG", system, arguments.tolerance);
      const Measurement direct =
        measure<dim>("direct", system, arguments.tolerance);
      print(format(
        "| %d-d, %u | %u | %u | %.2f | %.2f | %.2f | %.2f | %.2f | %.1f | %.1f "
        "|",
        dim,
        static_cast<unsigned int>(system.fields.elastic.n_dofs()),
        dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
        amg.iterations,
        amg.analysis + amg.setup,
        amg.solve,
        direct.analysis,
        // a solution is in the set-up of both
        direct.setup - direct.solve,
        direct.solve,
        amg.peak,
        direct.peak));
    });
  }



  // Block AMG with its matrix and without, from a state to the correction:
  // matrix or tangents, hierarchy, solution; memory with that of the matrix.
  template <int dim>
  void
  study_products(const Arguments &arguments)
  {
    for_each_size(arguments, [&](ElasticSystemOptions options) {
      options.with_matrix = options.matrix_free = false;
      for (const bool matrix_free : {false, true})
      {
        if (!matrix_free && arguments.solver == "matrix-free")
          continue;
        ElasticSystem<dim> system(options);
        forget_peak();
        const Memory before        = memory();
        system.options.matrix_free = matrix_free;
        system.options.with_matrix = !matrix_free;
        const double pattern       = seconds_of([&]() {
          system.make_operator();
          system.make_auxiliaries();
        });
        const auto   states        = system.states();
        double       values        = 0.;
        for (int pass = 0; pass < arguments.passes; ++pass)
          values = seconds_of([&]() { system.assemble(states); });
        const Measurement measured =
          measure<dim>(matrix_free ? "matrix-free" : "block AMG",
                       system,
                       arguments.tolerance,
                       arguments.passes);
        const Memory after = memory();
        const double kB    = 1024. / system.fields.elastic.n_dofs();
        print(format(
          "| %d-d, %u | %u | %s | %u | %.2f | %.2f | %.2f | %.2f | %.2f | "
          "%.2f |",
          dim,
          static_cast<unsigned int>(system.fields.elastic.n_dofs()),
          dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
          matrix_free ? "matrix-free" : "block AMG",
          measured.iterations,
          pattern,
          values,
          measured.analysis + measured.setup,
          measured.solve,
          values + measured.analysis + measured.setup + measured.solve,
          (after.peak - before.resident) * kB));
      }
    });
  }



  // GB/s of all ranks in a <- b + 3 c of vectors that no cache holds, as STREAM
  // counts them (McCalpin, 1995): two are read, one is written.
  double
  memory_bandwidth()
  {
    const std::size_t   n = 20000000;
    std::vector<double> a(n, 0.), b(n, 1.), c(n, 2.);
    double              best = 0.;
    for (unsigned int k = 0; k < 5; ++k)
    {
      const double seconds = seconds_of([&]() {
        for (std::size_t i = 0; i < n; ++i)
          a[i] = b[i] + 3. * c[i];
      });
      best                 = std::max(best, 24e-9 * n / seconds);
    }
    if (a[n / 2] != 7.)
      throw InputError("the loop was not done");
    return best * dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  }



  // Products per second, and what they read and write at least: the numbers of
  // the cells and index tables once, source and result once.
  template <int dim>
  void
  study_throughput(const Arguments &arguments)
  {
    const double gb = memory_bandwidth();
    for_each_size(arguments, [&](ElasticSystemOptions options) {
      for (const bool matrix_free : {false, true})
      {
        options.matrix_free = matrix_free;
        options.with_matrix = !matrix_free;
        ElasticSystem<dim>        system(options);
        const AssembledProduct    assembled(system.matrix, {});
        const SaddlePointProduct &product =
          matrix_free
            ? static_cast<const SaddlePointProduct &>(system.matrix_free)
            : assembled;
        SaddlePointProduct::Vector source, result;
        product.reinit(source);
        product.reinit(result);
        std::copy(system.right_hand_side.begin(),
                  system.right_hand_side.end(),
                  source.begin());
        const auto multiply = [&]() { product.vmult(result, source); };
        multiply();
        const unsigned int n       = 20;
        const double       seconds = seconds_of([&]() {
                                 for (unsigned int k = 0; k < n; ++k)
                                   multiply();
                               }) /
                               n;
        const double unknowns = system.fields.elastic.n_dofs();
        const double stored   = dealii::Utilities::MPI::sum(
          matrix_free
            ? 1. * system.matrix_free.memory_consumption()
            : 12. * system.matrix.n_nonzero_elements() /
                dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
          MPI_COMM_WORLD);
        const double bytes = stored + 24. * unknowns;
        print(format(
          "| %d-d, %.0f | %u | %s | %.1f | %.0f | %.1f | %.1f | %.0f |",
          dim,
          unknowns,
          dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
          matrix_free ? format("%u lanes", system.matrix_free.n_lanes()).c_str()
                      : "matrix",
          1e-6 * unknowns / seconds,
          bytes / unknowns,
          1e-9 * bytes / seconds,
          gb,
          1e-7 * bytes / seconds / gb));
      }
    });
  }



  template <int dim>
  void
  study_incompressibility(const Arguments &arguments)
  {
    ElasticSystemOptions options = basic(arguments);
    for (options.lambda = 1.; options.lambda < 2e6; options.lambda *= 10.)
      measure<dim>(options, arguments);
  }



  template <int dim>
  void
  study_damage(const Arguments &arguments)
  {
    ElasticSystemOptions options = basic(arguments);
    options.damage               = Damage::none;
    measure<dim>(options, arguments);
    for (const Damage damage : {Damage::half, Damage::through})
      for (const double kappa : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
      {
        options.damage = damage;
        options.kappa  = kappa;
        measure<dim>(options, arguments);
      }
  }



  template <int dim>
  void
  study_orderings(const Arguments &arguments)
  {
    ElasticSystem<dim>             system(basic(arguments));
    const std::vector<std::string> names =
      arguments.orderings.empty()
        ? Mumps::orderings()
        : dealii::Utilities::split_string_list(arguments.orderings);
    for (const std::string &name : names)
    {
      forget_peak();
      const Memory           before = memory();
      LinearOutcome          analysis, factorization, solution;
      auto                   result = system.right_hand_side;
      std::unique_ptr<Mumps> mumps;
      const double           seconds_analysis = seconds_of([&]() {
        mumps = std::make_unique<Mumps>(
          system.matrix, MatrixSymmetry::symmetric, analysis, name);
      });
      const double           seconds_factors =
        seconds_of([&]() { factorization = mumps->factorize(); });
      const double seconds_solve = seconds_of(
        [&]() { solution = mumps->solve(result, system.right_hand_side); });
      const double kB = 1024. / system.fields.elastic.n_dofs();
      print(
        format("| %d | %u | %u | %s | %s | %.3g | %.2f | %.2f | %.2f | %.2f | "
               "%s |",
               dim,
               dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
               system.fields.elastic.n_dofs(),
               name.c_str(),
               mumps->ordering().c_str(),
               mumps->n_entries_of_factors(),
               seconds_analysis,
               seconds_factors,
               seconds_solve,
               (memory().peak - before.resident) * kB,
               factorization.reason.c_str()));
    }
  }



  std::string
  head_of(const std::string &study)
  {
    if (study == "orderings")
      return "| dim | ranks | unknowns | ordering | used | entries of factors "
             "| analysis, s | factorisation, s | solve, s | peak kB per "
             "unknown | |\n"
             "|---|---|---|---|---|---|---|---|---|---|---|";
    if (study == "throughput")
      return "| unknowns | ranks | product | million unknowns/s | bytes per "
             "unknown | GB/s | of memory, GB/s | % |\n"
             "|---|---|---|---:|---:|---:|---:|---:|";
    if (study == "products")
      return "| unknowns | ranks | solver | iterations | pattern, s | matrix or "
             "tangents and two residuals, s | set-up, s | solve, s | without "
             "pattern, s | peak kB |\n"
             "|---|---|---|---:|---:|---:|---:|---:|---:|---:|";
    if (study == "beside")
      return "| unknowns | ranks | iterations | AMG set-up | AMG solve | MUMPS "
             "analysis | factors | solve | AMG peak kB | MUMPS peak kB |\n"
             "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|";
    return "| dim | ranks | unknowns | mesh | broken | lambda/mu | kappa | "
           "solver | iterations | analysis, s | set-up, s | solve, s | kB per "
           "unknown | peak |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|";
  }



  template <int dim>
  void
  run(const Arguments &arguments)
  {
    print(head_of(arguments.study));
    if (arguments.study == "sizes")
      study_sizes<dim>(arguments, 0);
    else if (arguments.study == "adaptive")
      study_sizes<dim>(arguments,
                       arguments.levels > 0 ? arguments.levels
                       : dim == 2           ? 4
                                            : 2);
    else if (arguments.study == "beside")
      study_beside<dim>(arguments);
    else if (arguments.study == "products")
      study_products<dim>(arguments);
    else if (arguments.study == "throughput")
      study_throughput<dim>(arguments);
    else if (arguments.study == "incompressibility")
      study_incompressibility<dim>(arguments);
    else if (arguments.study == "damage")
      study_damage<dim>(arguments);
    else if (arguments.study == "orderings")
      study_orderings<dim>(arguments);
    else
      throw InputError("unknown study " + arguments.study);
  }
} // namespace



int
main(int argc, char **argv)
{
  return run_benchmark(argc, argv, [&]() {
    const Arguments arguments = read(argc, argv);
    if (arguments.dim == 2)
      run<2>(arguments);
    else
      run<3>(arguments);
  });
}
