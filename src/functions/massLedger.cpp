#include "functions/massLedger.hpp"

#include <algorithm>
#include <set>

namespace pfem {

std::vector<std::string> causesOf(const std::vector<MassBalance>& rows) {
    std::set<std::string> causes;
    for (const auto& row : rows)
        for (const auto& [cause, volume] : row.causes) causes.insert(cause);
    return {causes.begin(), causes.end()};
}

std::vector<std::string> massTitles(const std::vector<std::string>& causes) {
    std::vector<std::string> titles{"Time", "volume", "mass", "relativeChange"};
    titles.insert(titles.end(), causes.begin(), causes.end());
    titles.insert(titles.end(), {"sumOfCauses", "unexplained"});
    return titles;
}

std::vector<double> massColumns(const MassBalance& balance, const std::vector<std::string>& causes) {
    std::vector<double> values{balance.time, balance.volume, balance.mass, balance.relativeChange};
    for (const auto& cause : causes) {
        const auto found = balance.causes.find(cause);
        values.push_back(found == balance.causes.end() ? 0.0 : found->second);
    }
    values.insert(values.end(), {balance.sumOfCauses, balance.unexplained});
    return values;
}

template <int Dim>
MassLedger<Dim>::MassLedger(const Dictionary&, const FunctionContext<Dim>& context) : context_(context) {
    context_.precision = std::max(10, context_.precision);  // small differences of large numbers
}

template <int Dim>
void MassLedger<Dim>::start(const State<Dim>& state) {
    account_.emplace(initialState(context_.root, state), readDensities(context_.root));
    rows_.clear();
    table_.reset();
}

template <int Dim>
void MassLedger<Dim>::execute(const State<Dim>& state) {
    rows_.push_back(account_->balance(state));
    const auto causes = causesOf(rows_);
    std::size_t from = rows_.size() - 1;
    if (!table_ || causes != causes_) {  // begin anew
        causes_ = causes;
        table_.emplace(context_.folder / "fluidVolume.dat", context_.precision);
        table_->comment(
            "Fluid volume [m2 (2D), m3], mass [kg/m, kg] and cumulative change of volume by cause");
        table_->header(massTitles(causes_));
        from = 0;
    }
    for (; from < rows_.size(); ++from) {
        std::vector<std::string> columns;
        for (const double value : massColumns(rows_[from], causes_)) columns.push_back(table_->number(value));
        table_->row(columns);
    }
}

template class MassLedger<2>;

}  // namespace pfem
