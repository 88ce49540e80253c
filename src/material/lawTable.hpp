#pragma once
// The laws by their words in constant/materials.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "material/fluidLaw.hpp"
#include "material/lawEntries.hpp"
#include "material/solidLaw.hpp"

namespace pfem {

/// A word of constant/materials: what it means, its entries, and how a dictionary with it is read. Law: SolidLaw or
/// FluidLaw.
template <class Law>
struct LawType {
    std::string name;
    std::string meaning;
    std::vector<EntryDescription> entries;
    std::function<std::shared_ptr<const Law>(const Dictionary&)> read;
};

/// All that are known: the library's, then those that were added.
std::vector<LawType<SolidLaw>>& solidLaws();
std::vector<LawType<FluidLaw>>& fluidLaws();

/// The type whose class is Own.
template <class Law, class Own>
LawType<Law> lawType(const std::string& name, const std::string& meaning) {
    return {name, meaning, describeEntries<Own>(),
            [](const Dictionary& dict) { return std::make_shared<const Own>(readLaw<Own>(dict)); }};
}

/// Make the law Own known to constant/materials; false when another has the name already. In one file of a project
/// outside the library:
///
///     const bool added = addSolidLaw<MyLaw>("myLaw", "What it is, in a sentence.");
template <class Own>
bool addSolidLaw(const std::string& name, const std::string& meaning);
template <class Own>
bool addFluidLaw(const std::string& name, const std::string& meaning);

namespace lawTableDetail {

bool add(const LawType<SolidLaw>& type);
bool add(const LawType<FluidLaw>& type);

}  // namespace lawTableDetail

template <class Own>
bool addSolidLaw(const std::string& name, const std::string& meaning) {
    return lawTableDetail::add(lawType<SolidLaw, Own>(name, meaning));
}
template <class Own>
bool addFluidLaw(const std::string& name, const std::string& meaning) {
    return lawTableDetail::add(lawType<FluidLaw, Own>(name, meaning));
}

}  // namespace pfem
