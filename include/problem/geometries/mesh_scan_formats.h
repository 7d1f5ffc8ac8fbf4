// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_scan_formats_h
#define mixed_cracks_problem_geometries_mesh_scan_formats_h

#include <string>
#include <vector>

namespace MixedCracks
{
  /// What scan_mesh() is made of; of no use elsewhere. Every function named
  /// _problem returns why the file cannot be used, as the end of a sentence
  /// that begins "the file", or an empty string.
  namespace MeshScanning
  {
    /// Lines without blanks around them, without empty ones.
    using Lines = std::vector<std::string>;

    /// All numbers of a line; empty when it holds anything else.
    std::vector<double> numbers_of(const std::string &line);

    /// The same for integers from 0 to 2^31 - 1, what the readers count with.
    std::vector<long int> integers_of(const std::string &line);

    /// @p kind: "node", "element", ….
    std::string broken_line(const std::string &kind, const std::string &line);

    /// The cells of a dimension, by the names and numbers of the formats.
    struct CellKind
    {
      int          dim;
      std::string  name;      ///< "quadrilaterals"
      unsigned int n_nodes;   ///< of a cell
      int          gmsh_type; ///< of Gmsh's list of elements
      std::string  ucd_type;
      char         last_side; ///< of Abaqus' S1, S2, …: its digit
    };

    CellKind cell_kind(int dim);

    /// @p found: "triangles", ….
    std::string unusable_element(const std::string &found,
                                 const CellKind    &kind);

    /// A mesh of the other dimension; @p found as above.
    std::string other_dimension(const std::string &found, const CellKind &kind);

    std::string gmsh_problem(const Lines &lines, const CellKind &kind);

    std::string abaqus_problem(const Lines &lines, const CellKind &kind);

    /// Needs a first line of five numbers, and no comments.
    std::string ucd_problem(const Lines &lines, const CellKind &kind);
  } // namespace MeshScanning
} // namespace MixedCracks

#endif
