// SPDX-License-Identifier: GPL-2.0-or-later
// Starts MPI, runs all unit tests on every rank, and fails on all ranks when
// one of them fails.
#include <base/single_process.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <iostream>

namespace
{
  // All ranks but the first only speak when something is wrong.
  class FailurePrinter : public ::testing::EmptyTestEventListener
  {
  public:
    explicit FailurePrinter(const unsigned int rank)
      : rank(rank)
    {}

  private:
    void
    OnTestPartResult(const ::testing::TestPartResult &result) override
    {
      if (result.failed())
        std::cerr << "[rank " << rank << "] "
                  << (result.file_name() ? result.file_name() : "?") << ':'
                  << result.line_number() << ": " << result.summary()
                  << std::endl;
    }

    unsigned int rank;
  };
} // namespace



int
main(int argc, char *argv[])
{
  ::testing::InitGoogleTest(&argc, argv);
  MixedCracks::prepare_single_process();
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  if (rank != 0)
  {
    auto &listeners = ::testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailurePrinter(rank));
  }

  const int failed = RUN_ALL_TESTS();
  return dealii::Utilities::MPI::max(failed, MPI_COMM_WORLD);
}
