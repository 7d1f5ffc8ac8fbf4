// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_parameter_tree_h
#define mixed_cracks_input_parameter_tree_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// One declared entry.
  struct ParameterEntry
  {
    std::vector<std::string> path; ///< its subsections, outermost first
    std::string              name;
    std::string              value;
    std::string              default_value;
    std::string              pattern_description;
    std::string              documentation;

    /// "Geometry/Punctured strip/Hole radius"
    std::string full_name() const;
  };

  /// "Geometry/Punctured strip", or "the top level".
  std::string subsection_name(const std::vector<std::string> &path);

  /// The declared entries of a ParameterHandler as a list, in the order of
  /// declaration, with the questions a reader asks. A copy: later changes of
  /// the handler are not seen. Names must not contain '.' or '/'.
  class ParameterTree
  {
  public:
    using Path = std::vector<std::string>;

    explicit ParameterTree(const dealii::ParameterHandler &prm);

    const std::vector<ParameterEntry> &
    entries() const
    {
      return all;
    }

    /// nullptr when there is none.
    const ParameterEntry *find(const Path &path, const std::string &name) const;

    /// Whether a subsection holds an entry, itself or in its subsections.
    bool has_subsection(const Path &path) const;

    /// Names of the entries directly in a subsection.
    std::vector<std::string> entry_names(const Path &path) const;

    /// Names of the subsections directly in a subsection.
    std::vector<std::string> subsection_names(const Path &path) const;

    /// Every subsection that holds entries, with its parents.
    std::vector<Path> subsections() const;

  private:
    std::vector<ParameterEntry> all;
  };
} // namespace MixedCracks

#endif
