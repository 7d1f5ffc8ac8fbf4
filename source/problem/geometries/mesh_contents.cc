// SPDX-License-Identifier: GPL-2.0-or-later
// Nodes and groups of a mesh file, known by the numbers and names of the file,
// in the order in which they come: indices, not numbers of the file, which may
// have gaps and be large, are what cells and faces refer to.

#include <problem/geometries/mesh_contents.h>

namespace MixedCracks
{
  bool
  MeshContents::add_node(const long int          number,
                         const dealii::Point<3> &position)
  {
    if (!index_by_number
           .emplace(number, static_cast<unsigned int>(nodes.size()))
           .second)
      return false;
    nodes.push_back({number % numbers_per_body, position});
    return true;
  }



  unsigned int
  MeshContents::group(const long int number, const std::string &name)
  {
    const auto [known, is_new] =
      group_by_key.emplace(std::to_string(number) + ' ' + name,
                           static_cast<unsigned int>(groups.size()));
    if (is_new)
      groups.push_back({number, name});
    return known->second;
  }
} // namespace MixedCracks
