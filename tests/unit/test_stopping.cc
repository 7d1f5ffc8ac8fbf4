// SPDX-License-Identifier: GPL-2.0-or-later
// A request to stop is noticed inside the solvers, on all ranks alike.
#include "elastic_system.h"
#include "small_systems.h"

#include <base/stop_request.h>

#include <deal.II/base/mpi.h>

#include <simulation/stop_poll.h>

#include <solvers/active_set.h>
#include <solvers/block_amg.h>
#include <solvers/newton.h>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  // says yes when it is asked for the n-th time
  struct Counted
  {
    unsigned int n;
    unsigned int asked = 0;

    StopCheck
    check()
    {
      return [this](const std::string &) { return ++asked >= n; };
    }
  };



  LinearOutcome
  solve_by_multigrid(Counted &counted)
  {
    ElasticSystem<2> system{ElasticSystemOptions()};
    LinearSystem     description = system.system();
    description.stop             = counted.check();
    BlockAmgSolver solver{LinearSolverOptions()};
    EXPECT_TRUE(solver.initialize(description).success);
    EXPECT_TRUE(solver.factorize().success);
    LinearAlgebra::Vector solution(system.right_hand_side);
    return solver.solve(solution, system.right_hand_side, 1e-10);
  }
} // namespace



TEST(Stopping, AnIterativeSolutionIsLeftBetweenTwoIterations)
{
  Counted             never{1000000};
  const LinearOutcome whole = solve_by_multigrid(never);
  EXPECT_TRUE(whole.success) << whole.reason;
  ASSERT_GT(whole.iterations, 6u);
  EXPECT_GE(never.asked, whole.iterations);

  // the first question comes after the set-up
  Counted             fifth{5};
  const LinearOutcome stopped = solve_by_multigrid(fifth);
  EXPECT_FALSE(stopped.success);
  EXPECT_LT(stopped.iterations, 5u);
  EXPECT_EQ(fifth.asked, 5u) << "nothing is done after a yes";
  EXPECT_NE(stopped.reason.find("asked to stop"), std::string::npos);

  Counted             at_once{1};
  const LinearOutcome after_set_up = solve_by_multigrid(at_once);
  EXPECT_FALSE(after_set_up.success);
  EXPECT_EQ(after_set_up.iterations, 0u);
}



TEST(Stopping, TheActiveSetIsLeftInsideALinearSolve)
{
  const unsigned int  n    = 400;
  const Rows          rows = string_rows(n, 2.001);
  std::vector<double> load(n, -1.);
  load[0] = -3.;
  LinearAlgebra::SparseMatrix matrix;
  make_matrix(rows, matrix);
  const auto              lower = distributed(std::vector<double>(n, 0.));
  const auto              upper = distributed(std::vector<double>(n, 1e6));
  const auto              scale = distributed(std::vector<double>(n, 1.));
  const std::vector<bool> constrained(lower.locally_owned_size(), false);
  for (const unsigned int limit : {1u, 4u, 1000000u})
  {
    Counted          counted{limit};
    auto             x        = distributed(std::vector<double>(n, 0.));
    auto             residual = distributed(load);
    ActiveSetOptions options;
    options.patience               = 1e6; // the diagonal, many iterations
    const ActiveSetOutcome outcome = ActiveSetSolver(options).solve(
      {matrix, lower, upper, scale, constrained, 0., counted.check()},
      x,
      residual);
    EXPECT_EQ(outcome.converged, limit > 4u) << outcome.reason;
    if (limit > 4u)
    {
      EXPECT_GT(counted.asked, 10u);
    }
    else
    {
      // the other questions are those of the iterations that follow
      EXPECT_LE(counted.asked, limit + 2u);
      EXPECT_EQ(outcome.reason, "asked to stop");
    }
  }
}



TEST(Stopping, NewtonIsLeftWithoutAnotherMatrix)
{
  double        x          = 10.;
  unsigned int  n_matrices = 0;
  NewtonProblem problem;
  problem.residual = [&]() { return ResidualSize{std::abs(x * x - 2.), 0.}; };
  problem.update_matrix = [&](bool) {
    ++n_matrices;
    return LinearOutcome();
  };
  problem.solve = [](double) { return LinearOutcome(); };
  problem.move  = [&](const double factor) {
    x -= factor * (x * x - 2.) / (2. * x);
  };
  problem.is_to_stop          = [&]() { return n_matrices == 2; };
  const NewtonOutcome outcome = solve_newton(problem, NewtonOptions());
  EXPECT_FALSE(outcome.converged);
  EXPECT_EQ(outcome.reason, "asked to stop");
  EXPECT_EQ(n_matrices, 2u);
}



TEST(Stopping, TheClockCountsFromWhenItIsHeeded)
{
  StopPoll poll(MPI_COMM_WORLD, 1e-6);
  EXPECT_FALSE(poll.ask("set-up"));
  poll.heed_the_clock();
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_TRUE(poll.ask_before_a_step());
  EXPECT_TRUE(poll.is_by_clock());
  EXPECT_TRUE(poll.ask("anything"));
  EXPECT_EQ(poll.n_steps(), 0u);
  EXPECT_NE(poll.in_words().find("Output/Wall time limit"), std::string::npos);
}



TEST(Stopping, AStepThatWouldBeTooLongIsNotBegun)
{
  // so long that a busy machine reaches the second question in time
  StopPoll poll(MPI_COMM_WORLD, 8.);
  poll.heed_the_clock();
  EXPECT_FALSE(poll.ask_before_a_step());
  std::this_thread::sleep_for(std::chrono::milliseconds(4100));
  // the step has taken more than half of the time
  EXPECT_TRUE(poll.ask_before_a_step());
  EXPECT_LT(poll.now(), 8.);
  EXPECT_EQ(poll.n_steps(), 1u);
}



TEST(Stopping, ASecondInterruptLaterEndsTheProcess)
{
  const pid_t child = fork();
  if (child == 0)
  {
    listen_for_stop_requests();
    std::raise(SIGINT);
    std::raise(SIGINT); // the same one
    std::raise(SIGTERM);
    sleep(3);
    std::raise(SIGTERM); // who asks twice has to wait
    std::raise(SIGINT);
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
}



// The last one, for a signal is not forgotten.
TEST(StoppingLast, ASignalToOneRankStopsAllAndTheCallIsNamed)
{
  const auto before = std::signal(SIGTERM, SIG_DFL);
  listen_for_stop_requests();
  StopPoll poll(MPI_COMM_WORLD, 0.);
  EXPECT_FALSE(poll.ask("set-up"));
  const unsigned int last =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == last)
    std::raise(SIGTERM);
  std::this_thread::sleep_for(std::chrono::milliseconds(2100));
  EXPECT_TRUE(poll.ask("factorisation, MUMPS"));
  EXPECT_FALSE(poll.is_by_clock());
  const std::string text = poll.in_words();
  EXPECT_NE(text.find("SIGTERM"), std::string::npos) << text;
  EXPECT_NE(text.find("factorisation, MUMPS"), std::string::npos) << text;
  EXPECT_GT(poll.seconds_since_request(), 2.);
  std::signal(SIGTERM, before);
}
