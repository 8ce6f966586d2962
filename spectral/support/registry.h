// A registry holds everything of one kind that the program knows by name. An entry registers itself
// from its own source file with one line; nothing else is edited when an entry is added.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace karat {

// Entries are shared, stateless and live as long as the program. `Entry` has no requirements.
template <typename Entry>
class Registry {
 public:
  static Registry& instance() {
    static Registry registry;
    return registry;
  }

  // Returns true so that a namespace-scope constant can hold the call. A name given twice replaces
  // the first entry only in tests; in the program it is a mistake that the contract tests find.
  bool add(std::string name, std::unique_ptr<const Entry> entry) {
    entries_[std::move(name)] = std::move(entry);
    return true;
  }
  bool remove(const std::string& name) { return entries_.erase(name) > 0; }

  // The entry of that name, or nullptr.
  const Entry* find(const std::string& name) const {
    const auto it = entries_.find(name);
    return it == entries_.end() ? nullptr : it->second.get();
  }

  // All names in alphabetical order.
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& [name, entry] : entries_) names.push_back(name);
    return names;
  }

 private:
  std::map<std::string, std::unique_ptr<const Entry>> entries_;
};

}  // namespace karat

// One line at the end of an entry's source file:
//   KARAT_REGISTER(FresnelModel, "schlick", SchlickFresnel);
#define KARAT_REGISTER_CONCAT_(a, b) a##b
#define KARAT_REGISTER_NAME_(line) KARAT_REGISTER_CONCAT_(karat_registered_, line)
#define KARAT_REGISTER(Kind, name, Class)                             \
  [[maybe_unused]] static const bool KARAT_REGISTER_NAME_(__LINE__) = \
      ::karat::Registry<Kind>::instance().add(name, std::make_unique<const Class>())
