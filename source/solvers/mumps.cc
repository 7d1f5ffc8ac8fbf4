// SPDX-License-Identifier: GPL-2.0-or-later
// MUMPS (multifrontal, distributed): A given by its entries on each rank, the
// right hand side and the solution on rank 0. Symmetric matrices as their lower
// triangle, scaled to ones on the diagonal,
//
//   (S A S)(S^-1 x) = S b,   S = diag(1/sqrt(abs(a_ii))),
//
// and factorised as L D L^T with 1x1 and 2x2 pivots, as A is indefinite.

#include <deal.II/base/exceptions.h>

#include <solvers/mumps.h>
#include <solvers/mumps_orderings.h>
#include <solvers/nested_dissection.h>

#ifdef MIXED_CRACKS_WITH_MUMPS

#  include <deal.II/base/mpi.h>

#  include <dmumps_c.h>

#  include <algorithm>
#  include <cmath>
#  include <cstddef>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    enum Job
    {
      start         = -1,
      finish        = -2,
      analysis      = 1,
      factorization = 2,
      solution      = 3
    };

    // names of the manual's entries that are used here, counted from 0
    enum Control
    {
      error_stream       = 0,
      diagnostic_stream  = 1,
      global_stream      = 2,
      print_level        = 3,
      ordering_kind      = 6,
      scaling_kind       = 7,
      workspace_increase = 13, // percent
      matrix_input       = 17,
      analysis_kind      = 27
    };
    // entries of the global information, counted from 0
    constexpr int used_ordering       = 6;
    constexpr int entries_of_factors  = 19;
    constexpr int sequential_analysis = 1;
    constexpr int no_scaling          = 0;
    constexpr int distributed_input   = 3;
    constexpr int initial_workspace   = 30;
    constexpr int largest_workspace   = 2000;
    constexpr int too_little_integer  = -8;
    constexpr int too_little_real     = -9;
    constexpr int singular_structure  = -6;
    constexpr int singular            = -10;
    constexpr int out_of_memory       = -13;
    constexpr int master              = 0;
  } // namespace



  struct Mumps::Implementation
  {
    MPI_Comm                communicator;
    const Epetra_CrsMatrix *matrix;
    DMUMPS_STRUC_C          data{};

    // this rank's part of the matrix: rows and columns counted from 1, and
    // where the values stand in the matrix's own array
    std::vector<MUMPS_INT>   rows, columns;
    std::vector<std::size_t> positions;
    std::vector<double>      values;
    // which unknowns each rank owns; on the master, the vector of all
    std::vector<int> owned;
    std::vector<int> counts, offsets;
    // of rows and columns of a symmetric matrix; 1 for others
    std::vector<double> scaling;
    std::vector<double> in_rank_order, all;
    // of the unknowns, counted from 1, on the master; where it is not MUMPS
    // that finds an ordering
    std::vector<MUMPS_INT> given_places;

    void
    run(const int job)
    {
      data.job = job;
      dmumps_c(&data);
    }

    void          take_pattern(bool lower_triangle);
    void          take_owners();
    void          take_values(const double *matrix_values);
    LinearOutcome take_ordering(const LinearAlgebra::SparseMatrix &matrix,
                                MatrixSymmetry                     symmetry,
                                const std::string                 &ordering);
    LinearOutcome outcome(const std::string &phase) const;
  };



  // Entries are found once, values follow by their positions in the matrix: a
  // new factorisation copies numbers only.
  void
  Mumps::Implementation::take_pattern(const bool lower_triangle)
  {
    int    *starts, *local_columns;
    double *unused;
    AssertThrow(matrix->ExtractCrsDataPointers(starts, local_columns, unused) ==
                  0,
                ExcMessage("the matrix is not compressed"));
    for (int row = 0; row < matrix->NumMyRows(); ++row)
      for (int k = starts[row]; k < starts[row + 1]; ++k)
      {
        const int global_row    = matrix->GRID(row);
        const int global_column = matrix->GCID(local_columns[k]);
        // each entry above the diagonal is one below it in another row
        if (lower_triangle && global_column > global_row)
          continue;
        rows.push_back(global_row + 1);
        columns.push_back(global_column + 1);
        positions.push_back(k);
      }
    values.resize(positions.size());
    data.nnz_loc = values.size();
    data.irn_loc = rows.data();
    data.jcn_loc = columns.data();
    data.a_loc   = values.data();
  }



  void
  Mumps::Implementation::take_owners()
  {
    const int  n_owned   = matrix->NumMyRows();
    const int  n_ranks   = Utilities::MPI::n_mpi_processes(communicator);
    const bool is_master = Utilities::MPI::this_mpi_process(communicator) == 0;
    std::vector<int> mine(n_owned);
    for (int row = 0; row < n_owned; ++row)
      mine[row] = matrix->GRID(row);
    counts.resize(n_ranks);
    offsets.resize(n_ranks, 0);
    MPI_Allgather(
      &n_owned, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator);
    for (int rank = 1; rank < n_ranks; ++rank)
      offsets[rank] = offsets[rank - 1] + counts[rank - 1];
    owned.resize(data.n);
    scaling.resize(data.n, 1.);
    if (is_master)
    {
      in_rank_order.resize(data.n);
      all.resize(data.n);
    }
    MPI_Allgatherv(mine.data(),
                   n_owned,
                   MPI_INT,
                   owned.data(),
                   counts.data(),
                   offsets.data(),
                   MPI_INT,
                   communicator);
    data.rhs  = all.data();
    data.nrhs = 1;
    data.lrhs = data.n;
  }



  // Ones on the diagonal, so that units do not matter. The scaling of MUMPS
  // itself takes several sweeps over a distributed matrix, in each
  // factorisation.
  void
  Mumps::Implementation::take_values(const double *matrix_values)
  {
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = matrix_values[positions[k]];
    if (data.sym == 0)
      return;
    std::vector<double> mine(matrix->NumMyRows(), 1.), gathered(scaling.size());
    for (std::size_t k = 0; k < values.size(); ++k)
      if (rows[k] == columns[k] && values[k] != 0.)
        mine[matrix->LRID(rows[k] - 1)] = 1. / std::sqrt(std::abs(values[k]));
    MPI_Allgatherv(mine.data(),
                   mine.size(),
                   MPI_DOUBLE,
                   gathered.data(),
                   counts.data(),
                   offsets.data(),
                   MPI_DOUBLE,
                   communicator);
    for (std::size_t i = 0; i < scaling.size(); ++i)
      scaling[owned[i]] = gathered[i];
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] *= scaling[rows[k] - 1] * scaling[columns[k] - 1];
  }



  // A METIS that MUMPS was built with is not asked: ours sees one vertex for
  // all unknowns of a node.
  LinearOutcome
  Mumps::Implementation::take_ordering(
    const LinearAlgebra::SparseMatrix &matrix,
    const MatrixSymmetry               symmetry,
    const std::string                 &ordering)
  {
    data.icntl[ordering_kind] = mumps_number_of(ordering);
    if (ordering != "automatic")
      // the parallel one has orderings of its own
      data.icntl[analysis_kind] = sequential_analysis;
    if (ordering != "METIS" || !nested_dissection_is_available())
      return {};
    std::vector<int>    places;
    const LinearOutcome outcome = nested_dissection(matrix, symmetry, places);
    for (const int place : places)
      given_places.push_back(place + 1);
    data.perm_in              = given_places.data();
    data.icntl[ordering_kind] = mumps_given_ordering;
    return outcome;
  }



  LinearOutcome
  Mumps::Implementation::outcome(const std::string &phase) const
  {
    const int error = data.infog[0];
    if (error >= 0)
      return {};
    const std::string reason = error == singular || error == singular_structure
                                 ? "the matrix is singular"
                               : error == out_of_memory
                                 ? "there is not enough memory"
                                 : "error " + std::to_string(error) + ", " +
                                     std::to_string(data.infog[1]);
    return {false, 0, phase + " by MUMPS failed: " + reason};
  }



  bool
  Mumps::is_available()
  {
    return true;
  }



  Mumps::Mumps(const LinearAlgebra::SparseMatrix &matrix,
               const MatrixSymmetry               symmetry,
               LinearOutcome                     &outcome,
               const std::string                 &ordering)
    : implementation(std::make_unique<Implementation>())
  {
    Implementation &my = *implementation;
    my.communicator =
      Utilities::MPI::duplicate_communicator(matrix.get_mpi_communicator());
    my.matrix            = &matrix.trilinos_matrix();
    DMUMPS_STRUC_C &data = my.data;
    data.comm_fortran    = MPI_Comm_c2f(my.communicator);
    data.par             = 1; // the master works too
    data.sym             = symmetry == MatrixSymmetry::symmetric ? 2 : 0;
    my.run(start);
    // errors are told by the outcome, on one rank
    data.icntl[error_stream]       = data.icntl[diagnostic_stream] =
      data.icntl[global_stream]    = -1;
    data.icntl[print_level]        = 0;
    data.icntl[matrix_input]       = distributed_input;
    data.icntl[workspace_increase] = initial_workspace;
    if (data.sym != 0)
      data.icntl[scaling_kind] = no_scaling;
    data.n = matrix.m();
    // before the copies of the pattern need their memory
    outcome = my.take_ordering(matrix, symmetry, ordering);
    if (!outcome.success)
      return;
    my.take_pattern(data.sym != 0);
    my.take_owners();
    my.run(analysis);
    outcome = my.outcome("analysis");
  }



  Mumps::~Mumps()
  {
    implementation->run(finish);
    MPI_Comm_free(&implementation->communicator);
  }



  // Workspace is an estimate of the analysis plus workspace_increase percent,
  // and pivoting for stability may need more, which is told by an error only:
  // doubled from 30 percent until it is enough, or 2000 are reached.
  LinearOutcome
  Mumps::factorize()
  {
    Implementation &my = *implementation;
    int            *starts, *columns;
    double         *values;
    my.matrix->ExtractCrsDataPointers(starts, columns, values);
    my.take_values(values);
    my.run(factorization);
    // more pivoting than the analysis expected
    while ((my.data.infog[0] == too_little_integer ||
            my.data.infog[0] == too_little_real) &&
           my.data.icntl[workspace_increase] < largest_workspace)
    {
      my.data.icntl[workspace_increase] *= 2;
      my.run(factorization);
    }
    return my.outcome("factorisation");
  }



  // x = S y with (S A S) y = S b; for matrices that are not symmetric S = 1.
  // Vectors come from the ranks one after the other: owned[] has the number in
  // the matrix of each place in that order.
  LinearOutcome
  Mumps::solve(LinearAlgebra::Vector       &result,
               const LinearAlgebra::Vector &right_hand_side)
  {
    Implementation &my      = *implementation;
    const int       n_owned = my.matrix->NumMyRows();
    MPI_Gatherv(right_hand_side.begin(),
                n_owned,
                MPI_DOUBLE,
                my.in_rank_order.data(),
                my.counts.data(),
                my.offsets.data(),
                MPI_DOUBLE,
                master,
                my.communicator);
    for (std::size_t i = 0; i < my.all.size(); ++i)
      my.all[my.owned[i]] = my.in_rank_order[i] * my.scaling[my.owned[i]];
    my.run(solution);
    for (std::size_t i = 0; i < my.all.size(); ++i)
      my.in_rank_order[i] = my.all[my.owned[i]] * my.scaling[my.owned[i]];
    MPI_Scatterv(my.in_rank_order.data(),
                 my.counts.data(),
                 my.offsets.data(),
                 MPI_DOUBLE,
                 result.begin(),
                 n_owned,
                 MPI_DOUBLE,
                 master,
                 my.communicator);
    LinearOutcome outcome = my.outcome("solution");
    outcome.iterations    = 1;
    return outcome;
  }



  std::string
  Mumps::ordering() const
  {
    return mumps_ordering_of(implementation->data.infog[used_ordering]);
  }



  double
  Mumps::n_entries_of_factors() const
  {
    const int entries = implementation->data.infog[entries_of_factors];
    // negative: in millions
    return entries < 0 ? -1e6 * entries : entries;
  }
} // namespace MixedCracks

#endif
