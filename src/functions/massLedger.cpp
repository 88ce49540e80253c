#include "functions/massLedger.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "io/history.hpp"

namespace pfem {

namespace {

std::vector<std::string> wordsOf(const std::string& line) {
    std::istringstream stream(line);
    return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace

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

/// A run that goes on takes over the rows of the table before; their columns may be others.
template <int Dim>
void MassLedger<Dim>::start(const State<Dim>& state) {
    account_.emplace(initialState(context_.root, state), readDensities(context_.root));
    rows_.clear();
    causes_.clear();
    table_.reset();
    file_ = context_.folder / "fluidVolume.dat";
    const auto previous = context_.resumeAt ? previousTable(file_) : std::nullopt;
    if (!previous) return;
    const TableText old = readTable(*previous, *context_.resumeAt);
    const auto titles = old.head.empty() ? std::vector<std::string>{} : wordsOf(old.head.back().substr(1));
    const auto fixed = massTitles({});
    for (const auto& title : fixed)
        if (std::find(titles.begin(), titles.end(), title) == titles.end()) return;  // another kind of table
    file_ = *previous;
    for (const auto& title : titles)
        if (std::find(fixed.begin(), fixed.end(), title) == fixed.end()) causes_.push_back(title);
    for (const auto& line : old.rows) {
        const auto words = wordsOf(line);
        Row& row = rows_.emplace_back();
        for (std::size_t i = 0; i < std::min(words.size(), titles.size()); ++i) row[titles[i]] = words[i];
    }
}

template <int Dim>
void MassLedger<Dim>::execute(const State<Dim>& state) {
    const MassBalance balance = account_->balance(state);
    std::set<std::string> causes(causes_.begin(), causes_.end());
    for (const auto& [cause, volume] : balance.causes) causes.insert(cause);
    const bool anew = !table_ || causes.size() != causes_.size();
    causes_.assign(causes.begin(), causes.end());
    const auto titles = massTitles(causes_);
    const auto values = massColumns(balance, causes_);
    if (anew) {
        table_.emplace(file_, context_.precision, state.time.value);
        table_->comment("Fluid volume [m2 (2D), m3], mass [kg/m, kg] and cumulative change of volume by cause");
        table_->header(titles);
    }
    Row& row = rows_.emplace_back();
    for (std::size_t i = 0; i < titles.size(); ++i)
        row[titles[i]] = i == 0 ? table_->time(values[i]) : table_->number(values[i]);
    std::vector<std::vector<std::string>> columns;
    for (std::size_t r = anew ? 0 : rows_.size() - 1; r < rows_.size(); ++r) {
        columns.emplace_back();
        for (const auto& title : titles) columns.back().push_back(rows_[r].count(title) ? rows_[r][title] : "0");
    }
    if (anew)
        table_->replaceRows(columns);
    else
        table_->row(columns[0]);
}

template class MassLedger<2>;

}  // namespace pfem
