// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_registry_h
#define mixed_cracks_base_registry_h

#include <base/errors.h>
#include <base/names.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// A list of named makers: what a name in a .prm stands for. Each room has
  /// one `all_…()` function that returns such a list; parameter patterns,
  /// error messages, the manual and the unit tests all iterate over it.
  template <typename Product, typename... Arguments>
  class Registry
  {
  public:
    struct Entry
    {
      std::string                                           name;
      std::string                                           description;
      std::function<std::unique_ptr<Product>(Arguments...)> make;
    };

    /// @p kind says in error messages what is listed, as in "energy split".
    Registry(std::string kind, std::vector<Entry> entries)
      : kind(std::move(kind))
      , entries(std::move(entries))
    {}

    /// A function for an entry: makes a @p Made, which is a Product.
    template <typename Made>
    static std::unique_ptr<Product>
    make_one(Arguments... arguments)
    {
      return std::make_unique<Made>(std::forward<Arguments>(arguments)...);
    }

    /// Make the product called @p name. Throws InputError with the list of
    /// names and the nearest one.
    std::unique_ptr<Product>
    make(const std::string &name, Arguments... arguments) const
    {
      for (const Entry &entry : entries)
        if (entry.name == name)
          return entry.make(std::forward<Arguments>(arguments)...);
      throw InputError(kind + ": " + unknown_name_message(name, names()));
    }

    std::vector<std::string>
    names() const
    {
      std::vector<std::string> result;
      for (const Entry &entry : entries)
        result.push_back(entry.name);
      return result;
    }

    /// The sentence on @p name, which has to be one of names().
    const std::string &
    description(const std::string &name) const
    {
      for (const Entry &entry : entries)
        if (entry.name == name)
          return entry.description;
      throw InputError(kind + ": " + unknown_name_message(name, names()));
    }

    /// The names as dealii::Patterns::Selection wants them.
    std::string
    selection() const
    {
      return join_names(names(), "|");
    }

    /// "'name': description. 'name': …" for parameter descriptions.
    std::string
    documentation() const
    {
      std::string text;
      for (const Entry &entry : entries)
        text += (text.empty() ? "'" : " '") + entry.name +
                "': " + entry.description + ".";
      return text;
    }

  private:
    std::string        kind;
    std::vector<Entry> entries;
  };
} // namespace MixedCracks

#endif
