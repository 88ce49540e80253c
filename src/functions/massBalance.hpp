#pragma once
// How much fluid there is, how much there was at the beginning, and what the ledger says about the
// difference.

#include <filesystem>
#include <map>
#include <string>

#include "state/volume.hpp"

namespace pfem {

/// Density of each material in <case>/constant/materials that has an entry `rho` [kg/m3]. Throws UserError.
std::map<std::string, double> readDensities(const std::filesystem::path& caseRoot);

/// Density times the volume that the fluid would have under the pressures of the start: totalVolume less what the
/// ledger's cause `compression` has taken [kg per m depth (2D), kg]. Isolated particles count as the first fluid
/// material. Throws UserError when a material has no density.
template <int Dim>
double fluidMass(const State<Dim>& state, const std::map<std::string, double>& densities);

struct MassBalance {
    double time = 0;
    double volume = 0;                     // [m2 (2D), m3]
    double mass = 0;                       // [kg/m (2D), kg]
    double relativeChange = 0;             // of the mass, since the beginning
    double withoutPassage = 0;             // the same but for what has come from outside or has left
    std::map<std::string, double> causes;  // change of volume by cause since the beginning
    double sumOfCauses = 0;
    double unexplained = 0;  // change of volume that no cause accounts for
};

/// Compares states with the first one.
template <int Dim>
class MassAccount {
public:
    MassAccount(const State<Dim>& initial, std::map<std::string, double> densities);
    MassBalance balance(const State<Dim>& state) const;

private:
    std::map<std::string, double> densities_;
    std::map<std::string, double> initialLedger_;
    double initialVolume_, initialMass_;
};

}  // namespace pfem
