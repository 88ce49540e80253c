#include "conditions/damping.hpp"

#include "dictionary/function1.hpp"

namespace pfem {

namespace {

template <int Dim>
Vec<Dim> inSpace(const Dictionary& entry, const std::string& key, const Eigen::Vector3d& value) {
    if (Dim == 2) demandPlane(entry, key, value[2]);
    return value.head<Dim>();
}

}  // namespace

template <int Dim>
DampingZone<Dim> readDamping(const Dictionary& entry) {
    DampingZone<Dim> zone;
    zone.from = inSpace<Dim>(entry, "from", entry.get<Eigen::Vector3d>("from"));
    zone.to = inSpace<Dim>(entry, "to", entry.get<Eigen::Vector3d>("to"));
    zone.rate = entry.get<double>("rate");
    zone.exponent = entry.get("exponent", zone.exponent);
    zone.velocity = inSpace<Dim>(entry, "velocity", entry.get<Eigen::Vector3d>("velocity", Eigen::Vector3d::Zero()));
    if (!((zone.to - zone.from).norm() > 0)) entry.fatal("to", "'from' and 'to' are the same place");
    for (const auto& [key, value] : {std::pair("rate", zone.rate), std::pair("exponent", zone.exponent)})
        if (!(value >= 0)) entry.fatal(key, std::string("Entry '") + key + "' must not be negative");
    return zone;
}

template DampingZone<2> readDamping<2>(const Dictionary&);
template DampingZone<3> readDamping<3>(const Dictionary&);

}  // namespace pfem
