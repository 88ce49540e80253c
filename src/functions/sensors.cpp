#include "functions/sensors.hpp"

#include <fmt/format.h>

namespace pfem {

template <int Dim>
Table sensorTable(const FunctionContext<Dim>& context, const std::string& file, const std::string& word,
                  const std::vector<Eigen::Vector3d>& points, const std::vector<bool>& found) {
    Table table(context.folder / file, context.precision, context.resumeAt);
    std::vector<std::string> titles{word};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool present = found.empty() || found[i];
        table.comment(fmt::format("{} {} ({} {} {}){}", word, i, table.number(points[i][0]),
                                  table.number(points[i][1]), table.number(points[i][2]),
                                  present ? "" : "  # Not Found"));
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

template Table sensorTable<2>(const FunctionContext<2>&, const std::string&, const std::string&,
                              const std::vector<Eigen::Vector3d>&, const std::vector<bool>&);

}  // namespace pfem
