// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_scan_formats_h
#define mixed_cracks_problem_geometries_mesh_scan_formats_h

#include <problem/geometries/mesh_contents.h>

#include <map>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// What scan_mesh() is made of; of no use elsewhere. Functions that return
  /// a problem say why the file cannot be used, as the end of a sentence that
  /// begins "the file"; an empty string when it can.
  namespace MeshScanning
  {
    /// Lines without blanks around them, without empty ones.
    using Lines = std::vector<std::string>;

    /// All numbers of a line; empty when it holds anything else, or a number
    /// that is not finite.
    std::vector<double> numbers_of(const std::string &line);

    /// The same for integers from 0 to 2^31 - 1.
    std::vector<long int> integers_of(const std::string &line);

    /// @p kind: "node", "element", ….
    std::string broken_line(const std::string &kind, const std::string &line);

    /// The cells of a dimension, by the names and numbers of the formats.
    struct CellKind
    {
      int          dim;
      std::string  name;    ///< "quadrilaterals"
      unsigned int n_nodes; ///< of a cell
      unsigned int n_face_nodes;
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

    /// Nodes of a cell or face that the file does not list; @p line: where.
    std::string unlisted_node(const std::string &line);

    /// "4 ('top')", or one of the two.
    std::string in_words(const MeshContents::Group &group);

    std::string
    scan_gmsh(const Lines &lines, const CellKind &kind, MeshContents &contents);

    /// By dimension and tag: the physical groups of Gmsh's entities.
    using GmshEntities =
      std::map<std::pair<long int, long int>, std::vector<long int>>;

    /// By dimension and number: the names of physical groups.
    using GmshNames = std::map<std::pair<long int, long int>, std::string>;

    /// Section $Elements. @p version: 2, 4 or 4.1.
    std::string scan_gmsh_elements(const Lines        &section,
                                   double              version,
                                   const GmshEntities &entities,
                                   const GmshNames    &names,
                                   const CellKind     &kind,
                                   MeshContents       &contents);

    std::string scan_abaqus(const Lines    &lines,
                            const CellKind &kind,
                            MeshContents   &contents);

    /// Needs a first line of five numbers, and no comments.
    std::string
    scan_ucd(const Lines &lines, const CellKind &kind, MeshContents &contents);
  } // namespace MeshScanning
} // namespace MixedCracks

#endif
