// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/single_process.h>

#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace MixedCracks
{
  namespace
  {
    bool
    begins_with(const std::string &text, const std::string &begin)
    {
      return text.compare(0, begin.size(), begin) == 0;
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
    return std::any_of(
      environment.begin(), environment.end(), [](const std::string &variable) {
        return std::any_of(
          beginnings.begin(), beginnings.end(), [&](const std::string &begin) {
            return begins_with(variable, begin);
          });
      });
  }



  std::vector<std::pair<std::string, std::string>>
  single_process_settings(const std::vector<std::string> &environment)
  {
    if (has_launcher(environment))
      return {};
    // Started without mpirun, Open MPI 4 forks a daemon in case the program
    // spawns others, which this one never does. Then it tries all ways to
    // speak to other processes; ob1 over "self" is all that one needs. In the
    // environment these win over Open MPI's files of parameters
    // (openmpi-mca-params.conf), which are written for runs on many.
    std::vector<std::pair<std::string, std::string>> settings{
      {"OMPI_MCA_ess_singleton_isolated", "1"},
      {"OMPI_MCA_pml", "ob1"},
      {"OMPI_MCA_btl", "self"}};
    settings.erase(std::remove_if(settings.begin(),
                                  settings.end(),
                                  [&](const auto &setting) {
                                    return std::any_of(
                                      environment.begin(),
                                      environment.end(),
                                      [&](const std::string &variable) {
                                        return begins_with(variable,
                                                           setting.first + "=");
                                      });
                                  }),
                   settings.end());
    return settings;
  }



  void
  prepare_single_process()
  {
    std::vector<std::string> environment;
    for (char **variable = environ; variable != nullptr && *variable != nullptr;
         ++variable)
      environment.emplace_back(*variable);
    for (const auto &[name, value] : single_process_settings(environment))
      setenv(name.c_str(), value.c_str(), 0);
  }
} // namespace MixedCracks
