#pragma once
// All about one quantity of one probe: the curves of all sizes, band, estimate, a reference where there is
// one.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bounds/estimate.hpp"
#include "study/history.hpp"

namespace pfem {

struct Quantity {
    std::string name;  // "tip_D_x"
    Study study;
    Band band;
    Estimate limit;
    std::optional<std::vector<double>> reference;  // at study.t
};

/// Histories of one table of every twin (nodal and elemental of each size, coarse to fine), and of the
/// reference.
struct TwinHistories {
    double h = 0;
    std::vector<ProbeHistory> nodal, elemental;
};

/// The quantities of the table that all twins have; those that never change (u_z in two dimensions) are left
/// out. The times are those of the twins, and of the reference as far as it goes. `until`: leave out later
/// times [s].
std::vector<Quantity> quantitiesOf(const std::string& function, const std::vector<TwinHistories>& twins,
                                   const std::vector<ProbeHistory>& reference, std::optional<double> until);

/// <folder>/<name>.dat: Time lower upper width bracket estimate uncertainty [nodal_h elemental_h]...
/// [reference], a row for each time; "-" for what is missing. Throws UserError.
void writeQuantity(const std::filesystem::path& folder, const Quantity& quantity, int precision);

}  // namespace pfem
