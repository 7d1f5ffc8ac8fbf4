// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_scan_formats_h
#define mixed_cracks_problem_geometries_mesh_scan_formats_h

#include <problem/geometries/mesh_contents.h>
#include <problem/geometries/mesh_shapes.h>

#include <map>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// What scan_mesh() is made of; of no use elsewhere. What cannot be used is
  /// thrown as a MeshProblem.
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
    MeshProblem broken_line(const std::string &kind, const std::string &line);

    /// The cells that a mesh of a dimension is made of.
    struct CellKind
    {
      int         dim;
      std::string name; ///< "quadrilaterals"
    };

    CellKind cell_kind(int dim);

    /// @p found: "triangles", ….
    MeshProblem unusable_element(const std::string &found,
                                 const CellKind    &kind);

    /// A mesh of the other dimension; @p found as above.
    MeshProblem other_dimension(const std::string &found, const CellKind &kind);

    /// What to do about triangles and the like.
    MeshProblem cut_or_remesh(const std::string &found, const CellKind &kind);

    /// Nodes of a cell or face that the file does not list; @p line: where.
    MeshProblem unlisted_node(const std::string &line);

    /// An element as a file lists it.
    struct Element
    {
      long int            number;
      const ElementShape &shape;
      long int            material; ///< of a cell
      /// of a face; not always wanted
      std::vector<unsigned int> groups;
    };

    /// Make the element with these numbers of nodes, corners first, a cell or a
    /// face; one of less dimensions is left out. @p line: where it stands.
    template <typename Iterator>
    void
    add_element(const Element     &element,
                const Iterator     first_node,
                const std::string &line,
                const CellKind    &kind,
                MeshContents      &contents)
    {
      const ElementShape &shape = element.shape;
      if (shape.dim > kind.dim)
        throw other_dimension(shape.in_words() + " (element " +
                                std::to_string(element.number) + ")",
                              kind);
      if (shape.dim < kind.dim - 1)
        return;
      const auto nodes =
        contents.indices_of(first_node, first_node + shape.n_corners);
      if (nodes.size() != shape.n_corners)
        throw unlisted_node(line);
      if (shape.dim == kind.dim)
      {
        contents.cells.push_back({element.number, nodes, element.material});
        contents.n_second_order += shape.is_second_order();
      }
      else
        for (const unsigned int group : element.groups)
          contents.faces.push_back({nodes, group});
    }

    /// When there are no cells. @p has_faces: elements of one dimension less.
    MeshProblem no_cells(bool has_faces, const CellKind &kind);

    /// "4 ('top')", or one of the two.
    std::string in_words(const MeshContents::Group &group);

    void
    scan_gmsh(const Lines &lines, const CellKind &kind, MeshContents &contents);

    /// By dimension and tag: the physical groups of Gmsh's entities.
    using GmshEntities =
      std::map<std::pair<long int, long int>, std::vector<long int>>;

    /// By dimension and number: the names of physical groups.
    using GmshNames = std::map<std::pair<long int, long int>, std::string>;

    /// Section $Elements. @p version: 2, 4 or 4.1.
    void scan_gmsh_elements(const Lines        &section,
                            double              version,
                            const GmshEntities &entities,
                            const GmshNames    &names,
                            const CellKind     &kind,
                            MeshContents       &contents);

    void scan_abaqus(const Lines    &lines,
                     const CellKind &kind,
                     MeshContents   &contents);

    /// Needs a first line of five numbers, and no comments.
    void
    scan_ucd(const Lines &lines, const CellKind &kind, MeshContents &contents);

    void
    scan_vtk(const Lines &lines, const CellKind &kind, MeshContents &contents);

    /// Whether the bytes are a binary Gmsh file.
    bool is_binary_gmsh(const std::string &bytes);

    /// Such a file as the lines of an ASCII file with the same contents.
    Lines gmsh_as_lines(const std::string &bytes);

    /// What kind of file that is not read this is: "a STEP file", …; empty when
    /// it is unknown.
    std::string name_of_other_format(const std::string &bytes);
  } // namespace MeshScanning
} // namespace MixedCracks

#endif
