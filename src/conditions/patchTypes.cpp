#include <algorithm>

#include "conditions/patchType.hpp"

namespace pfem {

PatchType slipPatch();
PatchType noSlipPatch();
PatchType clampedPatch();
PatchType symmetryPatch();
PatchType tractionPatch();
PatchType slipInterfacePatch();
PatchType inletPatch();
PatchType outletPatch();

const std::vector<PatchType>& patchTypes() {
    static const std::vector<PatchType> types{
        slipPatch(),           //
        noSlipPatch(),         //
        clampedPatch(),        //
        symmetryPatch(),       //
        tractionPatch(),       //
        slipInterfacePatch(),  //
        inletPatch(),          //
        outletPatch(),         //
    };
    return types;
}

bool PatchType::has(const std::string& entry) const {
    return std::any_of(entries.begin(), entries.end(), [&](const auto& row) { return row.name == entry; });
}

std::vector<std::string> typeNames(const std::function<bool(const PatchType&)>& wanted) {
    std::vector<std::string> names;
    for (const auto& type : patchTypes())
        if (!wanted || wanted(type)) names.push_back(type.name);
    return names;
}

std::string typeList(const std::function<bool(const PatchType&)>& wanted, const std::string& last) {
    const auto names = typeNames(wanted);
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? last : ", ") + names[i];
    return text;
}

}  // namespace pfem
