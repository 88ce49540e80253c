#include "functions/sensors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace pfem {

template <int Dim>
void warnOutOfPlane(const Dictionary& dict, const std::string& key, const std::vector<Eigen::Vector3d>& points) {
    if (Dim != 2 || std::all_of(points.begin(), points.end(), [](const auto& x) { return x[2] == 0; })) return;
    const Location where = dict.where(key);
    std::cerr << fmt::format(
        "--> PFEM Warning: z in entry '{}' in {}:{} is not heeded: the case lies in the plane of x and y\n", key,
        where.file, where.line);
}

template <int Dim>
Table sensorTable(const FunctionContext<Dim>& context, const std::string& file, const std::string& word,
                  const std::vector<Eigen::Vector3d>& points, const std::vector<bool>& found) {
    Table table(context.folder / file, context.precision, context.resumeAt);
    std::vector<std::string> titles{word};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool present = found.empty() || found[i];
        table.comment(fmt::format("{} {} ({} {} {}){}", word, i, table.number(points[i][0]), table.number(points[i][1]),
                                  table.number(points[i][2]), present ? "" : "  # Not Found"));
        titles.push_back(std::to_string(i));
    }
    table.header(titles);
    table.header({"Time"});
    return table;
}

void sensorRow(Table& table, double time, const std::vector<double>& values) {
    std::vector<std::string> row{table.time(time)};
    for (const double value : values) row.push_back(table.number(value));
    table.row(row);
}

#define PFEM_INSTANTIATE(D)                                                                                      \
    template void warnOutOfPlane<D>(const Dictionary&, const std::string&, const std::vector<Eigen::Vector3d>&); \
    template Table sensorTable<D>(const FunctionContext<D>&, const std::string&, const std::string&,             \
                                  const std::vector<Eigen::Vector3d>&, const std::vector<bool>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
