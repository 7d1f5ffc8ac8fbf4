// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_case_id_h
#define mixed_cracks_input_case_id_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// Which set of defaults an id rests on, since values that equal their
  /// default do not count. To be raised with every change of a default, of a
  /// derived one, and of the canonical form: a test holds them.
  unsigned int case_id_schema();

  /// "problem": what must not change when a run is resumed. "full": load
  /// steps, solvers and tolerances too. Never what is written and when the
  /// wall time is over: the subsection Output.
  const std::vector<std::string> &case_id_scopes();

  /// Values of entries in effect where their default is derived from others,
  /// by full name.
  using EffectiveValues = std::map<std::string, std::string>;

  /// What an id is the checksum of: the schema, and "name = value" for each
  /// entry that counts and is not at its default, by name. A file counts by
  /// what it holds. @p scope is one of case_id_scopes(). Collective.
  std::string case_id_text(const dealii::ParameterHandler &prm,
                           const EffectiveValues          &derived,
                           const std::string              &scope,
                           MPI_Comm communicator = MPI_COMM_WORLD);

  /// Sixteen hexadecimal digits for a text.
  std::string case_id(const std::string &text);
} // namespace MixedCracks

#endif
