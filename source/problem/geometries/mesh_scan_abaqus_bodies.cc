// SPDX-License-Identifier: GPL-2.0-or-later
// Parts of Abaqus and their instances. The lines of a part are kept, and read
// for each of its instances with the place that it has:
//
//   *INSTANCE, NAME=, PART=
//   u, v, w                      a translation
//   x1, y1, z1, x2, y2, z2, phi  then a rotation about the axis from 1 to 2,
//                                degrees
//
// Nodes and elements of an instance are known by their numbers and that of the
// instance, sets and surfaces as "instance.name"; with one instance the name
// alone will do.
//
// Surfaces that are tied (*TIE) become one, node by node: each face of the
// first has to be one of the second. Bodies that touch where they are not tied
// are refused, since cracks and slits are what two nodes at one place stand
// for.

#include <base/text.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <problem/geometries/mesh_scan_abaqus.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      // of the size of the body: nodes that are closer are at one place
      constexpr double same_place = 1e-6;



      /// Some of the nodes of a file, found by their position.
      class NodesByPlace
      {
      public:
        NodesByPlace(const MeshContents              &contents,
                     const std::vector<unsigned int> &nodes)
        {
          std::vector<Entry> entries;
          for (const unsigned int node : nodes)
            entries.emplace_back(contents.nodes[node].position, node);
          tree = dealii::pack_rtree(entries);
        }

        /// Those at most @p limit from @p place, ascending.
        std::vector<unsigned int>
        near(const dealii::Point<3> &place, const double limit) const
        {
          dealii::BoundingBox<3> around(std::make_pair(place, place));
          around.extend(limit);
          std::vector<Entry> entries;
          tree.query(boost::geometry::index::intersects(around),
                     std::back_inserter(entries));
          std::vector<unsigned int> result;
          for (const auto &[position, node] : entries)
            if (position.distance(place) <= limit)
              result.push_back(node);
          std::sort(result.begin(), result.end());
          return result;
        }

      private:
        using Entry = std::pair<dealii::Point<3>, unsigned int>;

        dealii::RTree<Entry> tree;
      };
    } // namespace



    // Rodrigues: R y = y cos + (k x y) sin + k (k . y) (1 - cos)
    dealii::Point<3>
    AbaqusPlacement::operator()(const dealii::Point<3> &x) const
    {
      const dealii::Tensor<1, 3> y = x + shift - a;
      return a + std::cos(angle) * y +
             std::sin(angle) * dealii::cross_product_3d(axis, y) +
             (1. - std::cos(angle)) * (axis * y) * axis;
    }



    bool
    AbaqusReader::keep_for_part(const std::string &line)
    {
      const std::string word = upper_case(line);
      if (starts_with(word, "*PART"))
      {
        begin(line);
        open_part = upper_case(keyword.value("NAME"));
        parts[open_part];
        return true;
      }
      if (starts_with(word, "*END PART") || starts_with(word, "*ASSEMBLY"))
        open_part.clear();
      if (!open_part.empty())
        parts[open_part].push_back(line);
      return !open_part.empty();
    }



    void
    AbaqusReader::begin_instance()
    {
      const std::string name = keyword.value("NAME");
      for (const AbaqusInstance &other : instances)
        if (other.name == upper_case(name))
          throw MeshProblem("has two instances with the name " +
                            in_quotes(name));
      in_instance = true;
      scope.base  = static_cast<long int>(instances.size()) *
                   MeshContents::numbers_per_body;
      scope.prefix = n_instances > 1 ? name + "." : "";
      AbaqusInstance instance;
      instance.name = upper_case(name);
      instance.part = upper_case(keyword.value("PART"));
      instances.push_back(instance);
    }



    void
    AbaqusReader::move_instance(const std::string &line)
    {
      const std::vector<double> numbers  = numbers_of(without_commas(line));
      AbaqusInstance           &here     = instances.back();
      AbaqusPlacement          &place    = here.place;
      const bool                is_shift = here.n_lines++ == 0;
      if (is_shift ? numbers.empty() || numbers.size() > 3
                   : here.n_lines > 2 || numbers.size() != 7)
        throw broken_line("place of an instance", line);
      for (unsigned int d = 0; d < 3; ++d)
        if (is_shift)
          place.shift[d] = d < numbers.size() ? numbers[d] : 0.;
        else
        {
          place.a[d]    = numbers[d];
          place.axis[d] = numbers[3 + d] - numbers[d];
        }
      if (is_shift)
        return;
      const double length = place.axis.norm();
      place.angle         = numbers[6] * std::acos(-1.) / 180.;
      if (length == 0. && place.angle != 0.)
        throw MeshProblem("turns its instance about an axis of no length: " +
                          in_quotes(line));
      if (length > 0.)
        place.axis /= length;
    }



    void
    AbaqusReader::end_instance()
    {
      if (!in_instance || instances.empty())
        throw MeshProblem("has an *END INSTANCE without an *INSTANCE");
      const std::string part = instances.back().part;
      if (parts.count(part) > 0)
        place_part(part);
      else if (!part.empty() && !parts.empty())
        throw MeshProblem("has an instance of the part " + in_quotes(part) +
                          ", which it does not list");
      in_instance = false;
      scope       = AbaqusScope();
    }



    void
    AbaqusReader::place_part(const std::string &part)
    {
      for (const std::string &line : parts.at(part))
        line[0] == '*' ? begin(line) : add_line(line);
    }



    AbaqusScope
    AbaqusReader::scope_of(const std::string &instance) const
    {
      for (std::size_t i = 0; i < instances.size(); ++i)
        if (instances[i].name == upper_case(instance) && n_instances > 1)
          return {instance + ".",
                  static_cast<long int>(i) * MeshContents::numbers_per_body};
      return scope;
    }



    const AbaqusSet *
    AbaqusReader::find_set(const std::map<std::string, AbaqusSet> &sets,
                           const AbaqusScope                      &at,
                           const std::string                      &name) const
    {
      auto set = sets.find(upper_case(at.prefix + name));
      if (set == sets.end())
        set = sets.find(upper_case(name));
      if (set == sets.end() && n_instances <= 1)
        set = sets.find(upper_case(name.substr(name.find_last_of('.') + 1)));
      return set == sets.end() ? nullptr : &set->second;
    }



    double
    AbaqusReader::tolerance() const
    {
      double size = 0.;
      for (const MeshContents::Node &node : contents.nodes)
        size = std::max(
          size, node.position.distance(contents.nodes.front().position));
      return same_place * size;
    }



    std::vector<unsigned int>
    AbaqusReader::nodes_of_surface(const std::string &name) const
    {
      std::set<unsigned int> nodes;
      for (const auto &face : faces_of_surface(name))
        nodes.insert(face.begin(), face.end());
      return {nodes.begin(), nodes.end()};
    }



    std::set<std::vector<unsigned int>>
    AbaqusReader::faces_of_surface(const std::string &name) const
    {
      std::set<std::vector<unsigned int>> faces;
      for (const MeshContents::Face &face : contents.faces)
        if (upper_case(contents.groups[face.group].name) == upper_case(name))
        {
          std::vector<unsigned int> nodes = face.nodes;
          std::sort(nodes.begin(), nodes.end());
          faces.insert(nodes);
        }
      return faces;
    }



    void
    AbaqusReader::tie(const std::string &first, const std::string &second)
    {
      const std::vector<unsigned int> moved = nodes_of_surface(first);
      const std::vector<unsigned int> kept  = nodes_of_surface(second);
      const std::string               what =
        "ties " + in_quotes(first) + " to " + in_quotes(second);
      if (moved.empty() || kept.empty())
        throw MeshProblem(what + ", which are not both surfaces of elements");
      const double              limit = tolerance();
      std::vector<unsigned int> becomes(contents.nodes.size());
      for (unsigned int i = 0; i < becomes.size(); ++i)
        becomes[i] = i;
      const NodesByPlace kept_by_place(contents, kept);
      for (const unsigned int node : moved)
      {
        const auto partners =
          kept_by_place.near(contents.nodes[node].position, limit);
        if (partners.empty())
          throw MeshProblem(
            what + ", but node " + std::to_string(contents.nodes[node].number) +
            " of the first meets none of the second: only meshes that "
            "fit node by node become one");
        becomes[node] = partners.front();
      }
      const auto rename = [&](std::vector<unsigned int> &nodes) {
        for (unsigned int &node : nodes)
          node = becomes[node];
      };
      for (auto &cell : contents.cells)
        rename(cell.nodes);
      for (auto &face : contents.faces)
        rename(face.nodes);
      for (auto &set : contents.node_sets)
        rename(set.nodes);
      for (const unsigned int node : moved)
        body_of_node[node] = body_of_node[becomes[node]];
      const auto faces = faces_of_surface(second);
      for (const auto &face : faces_of_surface(first))
        if (faces.count(face) == 0)
          throw MeshProblem(
            what + ", but the first has faces that are none of the second: "
                   "only meshes that fit face by face become one");
    }



    void
    AbaqusReader::check_touching() const
    {
      std::set<unsigned int> used;
      for (const MeshContents::Cell &cell : contents.cells)
        used.insert(cell.nodes.begin(), cell.nodes.end());
      const NodesByPlace by_place(contents, {used.begin(), used.end()});
      const double       limit = tolerance();
      for (const unsigned int node : used)
      {
        const auto &one = contents.nodes[node];
        for (const unsigned int other : by_place.near(one.position, limit))
        {
          const auto &two = contents.nodes[other];
          if (body_of_node[node] != body_of_node[other])
            throw MeshProblem(
              "has instances that touch at nodes " +
              std::to_string(one.number) + " and " +
              std::to_string(two.number) +
              " and are not tied there: merge them into one part, or tie "
              "their surfaces (*TIE)");
        }
      }
    }



    void
    AbaqusReader::join_bodies()
    {
      if (n_instances < 2)
        return;
      for (const auto &[first, second] : ties)
        tie(first, second);
      check_touching();
    }
  } // namespace MeshScanning
} // namespace MixedCracks
