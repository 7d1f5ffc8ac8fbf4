// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/ranges.h>
#include <base/single_process.h>
#include <base/text.h>

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace MixedCracks
{
  namespace
  {
    // settings that make sense with the daemon of a singleton, too
    constexpr std::size_t n_with_daemon = 3;

    // of a variable, if there is one
    std::optional<std::string>
    value_of(const std::string              &name,
             const std::vector<std::string> &environment)
    {
      for (const std::string &variable : environment)
        if (starts_with(variable, name + "="))
          return variable.substr(name.size() + 1);
      return {};
    }



    // As Open MPI's mpirun tells each rank. What srun starts below it inherits
    // these variables, and is another program.
    bool
    all_ranks_are_here(const std::vector<std::string> &environment)
    {
      const auto size = value_of("OMPI_COMM_WORLD_SIZE", environment);
      return size &&
             size == value_of("OMPI_COMM_WORLD_LOCAL_SIZE", environment) &&
             !value_of("SLURM_PROCID", environment);
    }



    std::vector<std::pair<std::string, std::string>>
    without_given(std::vector<std::pair<std::string, std::string>> settings,
                  const std::vector<std::string>                  &environment)
    {
      settings.erase(
        std::remove_if(
          settings.begin(),
          settings.end(),
          [&](const auto &setting) {
            return value_of(setting.first, environment).has_value();
          }),
        settings.end());
      return settings;
    }
  } // namespace



  bool
  has_launcher(const std::vector<std::string> &environment)
  {
    // Beginnings of names. A batch script of Slurm or LSF sets some of them
    // without launching anything; to be taken for launched only costs time,
    // while a rank that is taken for single would calculate alone.
    static const std::vector<std::string> beginnings{
      // Open MPI's mpirun, and what its daemons hand on
      "OMPI_COMM_WORLD",
      "OMPI_UNIVERSE_SIZE",
      "OMPI_MCA_ess=",
      "OMPI_MCA_ess_base",
      "OMPI_MCA_orte",
      "OMPI_MCA_prte",
      "OMPI_MCA_pmix",
      "ORTE_",
      "PRTE_",
      // every launcher that speaks PMI-1, PMI-2 or PMIx
      "PMI",
      // srun, aprun and Cray's PALS, flux, LSF and its jsrun, IBM's poe
      "SLURM_PROCID",
      "SLURM_STEP",
      "ALPS",
      "PALS",
      "FLUX",
      "LSB_",
      "JSM_",
      "MP_CHILD",
      // mpiexec of MPICH, Intel MPI and MVAPICH
      "HYDRA",
      "HYDI",
      "MPI_LOCAL",
      "MPIEXEC",
      "MPIRUN",
      "MV2_COMM_WORLD",
      "MVP_COMM_WORLD"};
    return any_of(environment, [](const std::string &variable) {
      return any_of(beginnings, [&](const std::string &begin) {
        return starts_with(variable, begin);
      });
    });
  }



  std::vector<std::pair<std::string, std::string>>
  single_process_settings(const std::vector<std::string> &environment)
  {
    // MPI-IO opens a shared file pointer with every file, which is never used
    // here. Its component "sm" needs memory that processes share, and where
    // /dev/shm cannot be written no checkpoint can.
    const std::pair<std::string, std::string> no_shared_pointers{
      "OMPI_MCA_sharedfp", "^sm"};
    // Ranks on one machine need no network, and "cm" takes 0.2 s of each start
    // to look for Omni-Path where there is none. Which of the others serves is
    // left to Open MPI.
    if (all_ranks_are_here(environment))
      return without_given({{"OMPI_MCA_pml", "^cm"}, no_shared_pointers},
                           environment);
    if (has_launcher(environment))
      return without_given({no_shared_pointers}, environment);
    // Started without mpirun, Open MPI 4 forks a daemon in case the program
    // spawns others, which this one never does. Then it tries all ways to
    // speak to other processes; ob1 over "self" is all that one needs. In the
    // environment these win over Open MPI's files of parameters
    // (openmpi-mca-params.conf), which are written for runs on many.
    // Without the daemon all such processes of a user have one number and one
    // directory for temporary files, which the first one to end takes away
    // from the others. One process needs no such directory, nor the shared file
    // pointers that would look for it.
    std::vector<std::pair<std::string, std::string>> settings{
      {"OMPI_MCA_ess_singleton_isolated", "1"},
      {"OMPI_MCA_pml", "ob1"},
      {"OMPI_MCA_btl", "self"},
      {"OMPI_MCA_orte_create_session_dirs", "0"},
      no_shared_pointers};
    // who wants the daemon has its directory
    if (value_of(settings.front().first, environment))
      settings.resize(n_with_daemon);
    return without_given(settings, environment);
  }



  bool
  prepare_single_process()
  {
    std::vector<std::string> environment;
    for (char **variable = environ; variable != nullptr && *variable != nullptr;
         ++variable)
      environment.emplace_back(*variable);
    for (const auto &[name, value] : single_process_settings(environment))
      setenv(name.c_str(), value.c_str(), 0);
    return !has_launcher(environment);
  }
} // namespace MixedCracks
