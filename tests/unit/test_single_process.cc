// SPDX-License-Identifier: GPL-2.0-or-later
// What a process that was started without a launcher tells Open MPI.
#include <base/single_process.h>

#include <gtest/gtest.h>

#include <cstdlib>

namespace MixedCracks
{
  namespace
  {
    using Settings = std::vector<std::pair<std::string, std::string>>;

    // as in a terminal of somebody who uses Open MPI
    const std::vector<std::string> terminal{
      "PATH=/usr/bin",
      "HOME=/home/user",
      "OMP_NUM_THREADS=1",
      "OMPI_ALLOW_RUN_AS_ROOT=1",
      "OMPI_MCA_rmaps_base_oversubscribe=1",
      "OMPI_MCA_btl_vader_single_copy_mechanism=none",
      "EMPTY=",
      "PS1=PMI_RANK=0"};

    std::vector<std::string>
    terminal_with(const std::string &variable)
    {
      std::vector<std::string> environment = terminal;
      environment.insert(environment.begin() + 3, variable);
      return environment;
    }

    const Settings all{{"OMPI_MCA_ess_singleton_isolated", "1"},
                       {"OMPI_MCA_pml", "ob1"},
                       {"OMPI_MCA_btl", "self"},
                       {"OMPI_MCA_orte_create_session_dirs", "0"},
                       {"OMPI_MCA_sharedfp", "^sm"}};

    // all but one
    Settings
    without(const unsigned int i)
    {
      Settings result = all;
      result.erase(result.begin() + i);
      return result;
    }
  } // namespace

  TEST(SingleProcess, ATerminalIsNoLauncher)
  {
    EXPECT_FALSE(has_launcher(terminal));
    EXPECT_FALSE(has_launcher({}));
    EXPECT_EQ(single_process_settings(terminal), all);
    EXPECT_EQ(single_process_settings({}), all);
  }

  TEST(SingleProcess, WithALauncherLittleIsSet)
  {
    for (const std::string variable : {"OMPI_COMM_WORLD_SIZE=2",
                                       "OMPI_UNIVERSE_SIZE=2",
                                       "OMPI_MCA_ess=^singleton",
                                       "OMPI_MCA_ess_base_jobid=1432616961",
                                       "OMPI_MCA_orte_hnp_uri=1432616960.0",
                                       "OMPI_MCA_pmix=^s1,s2,cray,isolated",
                                       "PRTE_LAUNCHED=1",
                                       "PMI_RANK=0",
                                       "PMI_FD=5",
                                       "PMIX_RANK=0",
                                       "PMIX_NAMESPACE=",
                                       "SLURM_PROCID=0",
                                       "SLURM_STEP_ID=0",
                                       "SLURM_STEPID=0",
                                       "ALPS_APP_PE=0",
                                       "PALS_RANKID=0",
                                       "FLUX_TASK_RANK=0",
                                       "LSB_JOBID=7",
                                       "JSM_NAMESPACE_RANK=0",
                                       "MP_CHILD=0",
                                       "MPI_LOCALRANKID=0",
                                       "MPI_LOCALNRANKS=1",
                                       "HYDRA_LAUNCHER=ssh",
                                       "HYDI_CONTROL_FD=5",
                                       "MV2_COMM_WORLD_RANK=0"})
    {
      EXPECT_TRUE(has_launcher(terminal_with(variable))) << variable;
      EXPECT_EQ(single_process_settings(terminal_with(variable)),
                Settings{all[4]})
        << variable;
    }
  }

  TEST(SingleProcess, RanksOnOneMachineAskForNoNetwork)
  {
    std::vector<std::string> rank = terminal_with("OMPI_COMM_WORLD_SIZE=2");
    rank.emplace_back("OMPI_COMM_WORLD_LOCAL_SIZE=1");
    EXPECT_EQ(single_process_settings(rank), Settings{all[4]});
    rank.back() = "OMPI_COMM_WORLD_LOCAL_SIZE=2";
    EXPECT_EQ(single_process_settings(rank),
              (Settings{{"OMPI_MCA_pml", "^cm"}, all[4]}));
    rank.emplace_back("OMPI_MCA_pml=ucx");
    EXPECT_EQ(single_process_settings(rank), Settings{all[4]});
    rank.back() = "SLURM_PROCID=0"; // srun below mpirun
    EXPECT_EQ(single_process_settings(rank), Settings{all[4]});
  }

  // main() has prepared this process as that of the program does.
  TEST(SingleProcess, MpirunIsSeen)
  {
    if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr)
      GTEST_SKIP() << "not started by Open MPI's mpirun";
    EXPECT_FALSE(prepare_single_process());
    EXPECT_EQ(std::getenv("OMPI_MCA_ess_singleton_isolated"), nullptr);
    EXPECT_EQ(std::getenv("OMPI_MCA_orte_create_session_dirs"), nullptr);
    EXPECT_NE(std::getenv("OMPI_MCA_sharedfp"), nullptr);
    // who runs the tests may have another one
    const char *const transport = std::getenv("OMPI_MCA_btl");
    EXPECT_STRNE(transport ? transport : "", "self");
  }

  TEST(SingleProcess, WhatTheUserHasSetIsLeftAlone)
  {
    EXPECT_EQ(single_process_settings(
                terminal_with("OMPI_MCA_ess_singleton_isolated=0")),
              (Settings{all[1], all[2]}));
    EXPECT_EQ(single_process_settings(terminal_with("OMPI_MCA_pml=ucx")),
              without(1));
    EXPECT_EQ(single_process_settings(terminal_with("OMPI_MCA_btl=")),
              without(2));
    EXPECT_EQ(
      single_process_settings(terminal_with("OMPI_MCA_sharedfp=individual")),
      without(4));
    // another parameter whose name begins alike
    EXPECT_EQ(
      single_process_settings(terminal_with("OMPI_MCA_pml_ob1_verbose=1")),
      all);
  }
} // namespace MixedCracks
