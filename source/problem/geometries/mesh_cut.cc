// SPDX-License-Identifier: GPL-2.0-or-later
// A cell is cut into one piece for each of its corners. With the mean of the
// corners of an edge, m, of a face, f, and of the cell, c, the piece at the
// corner v, where the edges to a, b, ... leave, is
//
//   2-d   v, m(v a), c, m(v b)
//   3-d   v, m(v a), f(v a b), m(v b); above them m(v c), f(v c a), c, f(v b c)
//
// Neighbours share m and f, so that the pieces fit together, whatever the cells
// are: triangles beside quadrilaterals, tetrahedra beside prisms. Where more
// than three edges leave a corner, as at the top of a pyramid, the piece is no
// hexahedron.
//
// Every edge of a piece leads from v to m, from m to f or from f to c: with
// these directions opposite edges of a piece are parallel, and deal.II can
// order every such mesh.
//
// A triangle with the angles 60 degrees becomes quadrilaterals with 60, 90, 120
// and 90 degrees.

#include <base/ranges.h>

#include <problem/geometries/mesh_cut.h>
#include <problem/geometries/mesh_shapes.h>

#include <algorithm>
#include <map>

namespace MixedCracks
{
  namespace
  {
    using Nodes = std::vector<unsigned int>;

    Nodes
    in_order(Nodes nodes)
    {
      std::sort(nodes.begin(), nodes.end());
      return nodes;
    }



    // The means of nodes, by the sorted nodes
    class Means
    {
    public:
      explicit Means(MeshContents &contents)
        : contents(contents)
      {}

      // made when there is none
      unsigned int
      of(const Nodes &nodes)
      {
        const auto [known, is_new] = means.emplace(
          in_order(nodes), static_cast<unsigned int>(contents.nodes.size()));
        if (is_new)
        {
          dealii::Point<3> mean;
          for (const unsigned int node : nodes)
            mean += (1. / static_cast<double>(nodes.size())) *
                    contents.nodes[node].position;
          contents.nodes.push_back({MeshContents::Node::none, mean});
        }
        return known->second;
      }

      bool
      has(const Nodes &nodes) const
      {
        return means.count(in_order(nodes)) > 0;
      }

      const std::map<Nodes, unsigned int> &
      all() const
      {
        return means;
      }

    private:
      MeshContents                 &contents;
      std::map<Nodes, unsigned int> means;
    };



    // The pieces of a polygon, with the node @p center inside
    std::vector<Nodes>
    pieces_of_polygon(const Nodes       &corners,
                      const unsigned int center,
                      Means             &means)
    {
      std::vector<Nodes> pieces;
      const std::size_t  n = corners.size();
      for (std::size_t i = 0; i < n; ++i)
      {
        const unsigned int here = corners[i];
        pieces.push_back({here,
                          means.of({here, corners[(i + 1) % n]}),
                          center,
                          means.of({here, corners[(i + n - 1) % n]})});
      }
      return pieces;
    }



    // A face of a cell at one of its corners: its node in the middle and the
    // two neighbours of the corner in it
    struct FaceAtCorner
    {
      Nodes        nodes;
      unsigned int next, last;

      bool
      leads_to(const unsigned int node) const
      {
        return next == node || last == node;
      }
    };



    std::vector<FaceAtCorner>
    faces_at(const Nodes &cell, const unsigned int corner)
    {
      std::vector<FaceAtCorner> found;
      for (const auto &side : MeshScanning::sides_of(3, cell.size()))
      {
        const auto here = std::find(side.begin(), side.end(), corner);
        if (here == side.end())
          continue;
        const std::size_t n = side.size();
        const std::size_t i = static_cast<std::size_t>(here - side.begin());
        FaceAtCorner      face;
        for (const unsigned int place : side)
          face.nodes.push_back(cell[place]);
        face.next = face.nodes[(i + 1) % n];
        face.last = face.nodes[(i + n - 1) % n];
        found.push_back(face);
      }
      return found;
    }



    // Three faces meet at the corner
    Nodes
    piece_of_solid(const unsigned int               corner,
                   const std::vector<FaceAtCorner> &faces,
                   const unsigned int               center,
                   Means                           &means)
    {
      const unsigned int  a = faces[0].next, b = faces[0].last;
      const bool          second_has_a = faces[1].leads_to(a);
      const FaceAtCorner &with_a       = faces[second_has_a ? 1 : 2];
      const FaceAtCorner &with_b       = faces[second_has_a ? 2 : 1];
      const unsigned int  c = with_a.next == a ? with_a.last : with_a.next;
      return {corner,
              means.of({corner, a}),
              means.of(faces[0].nodes),
              means.of({corner, b}),
              means.of({corner, c}),
              means.of(with_a.nodes),
              center,
              means.of(with_b.nodes)};
    }



    std::vector<Nodes>
    pieces_of_solid(const Nodes &cell, const unsigned int center, Means &means)
    {
      std::vector<Nodes> pieces;
      for (unsigned int corner = 0; corner < cell.size(); ++corner)
        pieces.push_back(
          piece_of_solid(cell[corner], faces_at(cell, corner), center, means));
      return pieces;
    }



    // Faces that belong to no cell stay what they are, for the message about
    // them.
    void
    cut_faces(MeshContents &contents, const int dim, Means &means)
    {
      std::vector<MeshContents::Face> faces;
      for (const MeshContents::Face &face : contents.faces)
      {
        if (!means.has(face.nodes))
        {
          faces.push_back(face);
          continue;
        }
        const unsigned int center = means.of(face.nodes);
        if (dim == 2)
          for (const unsigned int node : face.nodes)
            faces.push_back({{node, center}, face.group});
        else
          for (const Nodes &piece :
               pieces_of_polygon(face.nodes, center, means))
            faces.push_back({piece, face.group});
      }
      contents.faces.swap(faces);
    }



    // A mean is in a set when all its nodes are
    void
    extend_node_sets(MeshContents &contents, const Means &means)
    {
      for (MeshContents::NodeSet &set : contents.node_sets)
      {
        std::vector<bool> in_set(contents.nodes.size(), false);
        for (const unsigned int node : set.nodes)
          in_set[node] = true;
        for (const auto &[nodes, mean] : means.all())
          if (all_of(nodes, [&](unsigned int node) { return in_set[node]; }))
            set.nodes.push_back(mean);
      }
    }



    MeshProblem
    twice(const MeshContents::Cell &cell, const MeshContents::Cell &other)
    {
      return MeshProblem(
        "lists a cell twice, as the elements " + std::to_string(other.number) +
        " and " + std::to_string(cell.number) +
        (other.material == cell.material
           ? ""
           : ", with the materials " + std::to_string(other.material) +
               " and " + std::to_string(cell.material) +
               ": is it in two physical groups? A cell has one material"));
    }



    // What pieces would hide: a cell twice, and what has none
    void
    check_cells(const MeshContents &contents, const int dim)
    {
      std::map<Nodes, const MeshContents::Cell *> known;
      for (const MeshContents::Cell &cell : contents.cells)
      {
        if (dim == 3 && cell.nodes.size() == 5)
          throw MeshProblem("has pyramids (element " +
                            std::to_string(cell.number) +
                            "), which cannot be cut into hexahedra");
        const auto [other, is_new] = known.emplace(in_order(cell.nodes), &cell);
        if (!is_new)
          throw twice(cell, *other->second);
      }
    }
  } // namespace



  const MeshContents::Cell *
  first_simplex(const MeshContents &contents, const int dim)
  {
    const std::size_t n_corners = dim == 2 ? 4 : 8;
    const auto        cell      = std::find_if(contents.cells.begin(),
                                   contents.cells.end(),
                                   [&](const MeshContents::Cell &each) {
                                     return each.nodes.size() != n_corners;
                                   });
    return cell == contents.cells.end() ? nullptr : &*cell;
  }



  void
  cut_cells(MeshContents &contents, const int dim)
  {
    check_cells(contents, dim);
    Means                           means(contents);
    std::vector<MeshContents::Cell> pieces;
    for (const MeshContents::Cell &cell : contents.cells)
    {
      const unsigned int center = Means(contents).of(cell.nodes);
      for (const Nodes &piece : dim == 2
                                  ? pieces_of_polygon(cell.nodes, center, means)
                                  : pieces_of_solid(cell.nodes, center, means))
        pieces.push_back({cell.number, piece, cell.material});
    }
    contents.cells.swap(pieces);
    cut_faces(contents, dim, means);
    extend_node_sets(contents, means);
  }
} // namespace MixedCracks
