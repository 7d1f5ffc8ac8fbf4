// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_case_signature_h
#define mixed_cracks_input_case_signature_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// The entries of a .prm by what they mean to a run that is resumed, as
  /// lines "Subsection/Entry = value".
  struct CaseSignature
  {
    /// What makes up the problem, and hence must not change. An entry "File
    /// name" counts by what the file holds, and not by where it is; so does a
    /// table in an expression.
    std::string problem;
    /// What a step is tried with: load steps and solvers, and the program. A
    /// step that failed is tried again only where this has changed.
    std::string attempt;
  };

  /// Collective; the first rank reads the files.
  CaseSignature case_signature(const dealii::ParameterHandler &prm,
                               MPI_Comm communicator = MPI_COMM_WORLD);

  /// What stands for a file where it counts by what it holds: size and
  /// checksum, as the first rank finds them; "" for no name. Collective.
  std::string description_of_file(const std::string &path,
                                  MPI_Comm           communicator);

  /// An expression with its tables, table("load.csv"), as what the files hold.
  /// Collective.
  std::string with_contents_of_tables(const std::string &value,
                                      MPI_Comm           communicator);

  /// Whether an entry, or "contents of" one, belongs to a geometry that is not
  /// the one with this name.
  bool is_of_other_geometry(const std::string &name,
                            const std::string &geometry);

  /// Throws InputError with the first difference when @p now is not the
  /// problem that @p before is of. Values are compared by what they mean, and
  /// geometries that are not chosen are left out. @p failure: the message of
  /// the expression that has ended the run, if one has: the expressions of its
  /// entry may then change. Returns such a change in words, or "".
  std::string require_same_case(const std::string &before,
                                const std::string &now,
                                const std::string &failure = "");

  /// Whether a step would be tried again with what it was tried with.
  bool is_same_attempt(const std::string &before, const std::string &now);

  /// Whether a resumed run may have other expressions in the entry that this
  /// message of an error is about.
  bool can_be_mended(const std::string &failure);

  /// Whether an entry, or all of a subsection, may change when a run is
  /// resumed.
  struct ResumeRule
  {
    enum Change
    {
      no,
      if_empty,  ///< from nothing to something
      if_failed, ///< its expressions, when one of them has ended the run
      yes
    };

    std::string name; ///< "Output", "Output/Field format"
    Change      change;
  };

  /// One list for all entries; of two rules the longer one holds.
  const std::vector<ResumeRule> &resume_rules();

  /// The rule for an entry; nullptr when there is none, which a test forbids.
  const ResumeRule *resume_rule(const std::string &full_name);
} // namespace MixedCracks

#endif
