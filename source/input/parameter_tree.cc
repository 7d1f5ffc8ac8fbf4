// SPDX-License-Identifier: GPL-2.0-or-later
// All entries that a ParameterHandler has declared, in the order of
// declaration, as a flat list with paths. It is read from the handler's JSON:
// there is no other access to patterns and descriptions.

#include <base/names.h>

#include <input/parameter_tree.h>

// Boost's parser includes a header of Boost that it calls deprecated.
#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <algorithm>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    std::string
    item(const Tree &entry, const std::string &key)
    {
      return entry.get<std::string>(key, "");
    }

    void
    append_entries(const Tree                     &tree,
                   const std::vector<std::string> &path,
                   std::vector<ParameterEntry>    &entries)
    {
      for (const auto &[name, child] : tree)
        if (child.count("pattern_description") != 0 &&
            child.count("value") != 0)
          entries.push_back({path,
                             name,
                             item(child, "value"),
                             item(child, "default_value"),
                             item(child, "pattern_description"),
                             item(child, "documentation")});
        else if (child.count("alias") == 0)
        {
          std::vector<std::string> deeper = path;
          deeper.push_back(name);
          append_entries(child, deeper, entries);
        }
    }

    bool
    begins_with(const std::vector<std::string> &path,
                const std::vector<std::string> &beginning)
    {
      return path.size() >= beginning.size() &&
             std::equal(beginning.begin(), beginning.end(), path.begin());
    }
  } // namespace



  std::string
  ParameterEntry::full_name() const
  {
    return path.empty() ? name : join_names(path, "/") + "/" + name;
  }



  std::string
  subsection_name(const std::vector<std::string> &path)
  {
    return path.empty() ? "the top level" : join_names(path, "/");
  }



  // The handler keeps its entries to itself; what it prints as JSON is the
  // only complete account of them.
  ParameterTree::ParameterTree(const dealii::ParameterHandler &prm)
  {
    using Handler = dealii::ParameterHandler;
    std::stringstream json;
    prm.print_parameters(json, Handler::JSON | Handler::KeepDeclarationOrder);
    Tree tree;
    boost::property_tree::read_json(json, tree);
    append_entries(tree, {}, all);
  }



  const ParameterEntry *
  ParameterTree::find(const Path &path, const std::string &name) const
  {
    for (const ParameterEntry &entry : all)
      if (entry.name == name && entry.path == path)
        return &entry;
    return nullptr;
  }



  bool
  ParameterTree::has_subsection(const Path &path) const
  {
    return std::any_of(all.begin(), all.end(), [&](const auto &entry) {
      return begins_with(entry.path, path);
    });
  }



  std::vector<std::string>
  ParameterTree::entry_names(const Path &path) const
  {
    std::vector<std::string> names;
    for (const ParameterEntry &entry : all)
      if (entry.path == path)
        names.push_back(entry.name);
    return names;
  }



  std::vector<std::string>
  ParameterTree::subsection_names(const Path &path) const
  {
    std::vector<std::string> names;
    for (const Path &subsection : subsections())
      if (subsection.size() == path.size() + 1 && begins_with(subsection, path))
        names.push_back(subsection.back());
    return names;
  }



  std::vector<ParameterTree::Path>
  ParameterTree::subsections() const
  {
    std::vector<Path> paths;
    for (const ParameterEntry &entry : all)
      for (std::size_t depth = 1; depth <= entry.path.size(); ++depth)
      {
        const Path path(entry.path.begin(), entry.path.begin() + depth);
        if (std::find(paths.begin(), paths.end(), path) == paths.end())
          paths.push_back(path);
      }
    return paths;
  }
} // namespace MixedCracks
