// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_case_identity_h
#define mixed_cracks_simulation_case_identity_h

#include <input/case_id.h>
#include <input/command_line.h>
#include <input/parameter_file.h>

#include <simulation/parameters.h>

namespace MixedCracks
{
  /// Reads a case with what the command line changes of it, and checks all that
  /// can be checked without a mesh. @p prm holds the entries afterwards. Throws
  /// InputError and FileError, on all ranks alike. Collective.
  template <int dim>
  void read_case(const std::vector<SourceLine> &source,
                 const CommandLine             &command,
                 Parameters<dim>               &parameters,
                 dealii::ParameterHandler      &prm);

  /// Entries whose default follows from other entries, with the values in
  /// effect. After Parameters::check().
  template <int dim>
  EffectiveValues derived_values(const Parameters<dim> &parameters);

  /// The id of a case, see case_id.h. @p prm holds what @p parameters were read
  /// from; after Parameters::check(). Throws FileError when a file that counts
  /// cannot be read. Collective; no mesh is built.
  template <int dim>
  std::string case_identity(const Parameters<dim>          &parameters,
                            const dealii::ParameterHandler &prm,
                            const std::string              &scope);
} // namespace MixedCracks

#endif
