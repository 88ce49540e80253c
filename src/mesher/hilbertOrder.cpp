#include "mesher/hilbertOrder.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

namespace pfem {

std::vector<int> hilbertOrder(const Points<2>& points) {
    if (points.empty()) return {};
    Vec<2> low = points.front(), high = low;
    for (const auto& x : points) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    // in cells of a millionth of the extent, so that round-off decides nothing: the order is the same in all units
    const double extent = (high - low).maxCoeff();
    const double scale = extent > 0 ? (1 << 20) / extent : 0.0;
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Site = std::pair<Kernel::Point_2, int>;
    std::vector<Site> sites;
    sites.reserve(points.size());
    for (const auto& x : points) {
        const Vec<2> cell = (scale * (x - low) + Vec<2>::Constant(1e-6)).array().floor();
        sites.emplace_back(Kernel::Point_2(cell.x(), cell.y()), static_cast<int>(sites.size()));
    }
    using Traits = CGAL::Spatial_sort_traits_adapter_2<Kernel, CGAL::First_of_pair_property_map<Site>>;
    CGAL::hilbert_sort(sites.begin(), sites.end(), Traits());
    std::vector<int> order;
    order.reserve(sites.size());
    for (const auto& [place, i] : sites) order.push_back(i);
    return order;
}

}  // namespace pfem
