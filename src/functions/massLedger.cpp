#include "functions/massLedger.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "io/history.hpp"

namespace pfem {

namespace {

using Row = std::map<std::string, std::string>;  // title -> text

std::vector<Row> rowsOf(const TableText& table) {
    const auto titles = table.titles();
    std::vector<Row> rows;
    for (const auto& line : table.rows) {
        const auto words = wordsOf(line);
        Row& row = rows.emplace_back();
        for (std::size_t i = 0; i < std::min(words.size(), titles.size()); ++i) row[titles[i]] = words[i];
    }
    return rows;
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
MassLedger<Dim>::MassLedger(const Dictionary& dict, const FunctionContext<Dim>& context) : context_(context) {
    readEntries(dict, entries_);
    context_.precision = std::max(10, context_.precision);  // small differences of large numbers
}

/// A run that goes on takes over the rows of the table before; their columns may be others.
template <int Dim>
void MassLedger<Dim>::start(const State<Dim>& state) {
    account_.emplace(initialState(context_.root, state), readDensities(context_.root));
    causes_.clear();
    table_.reset();
    rowsUntil_.reset();
    file_ = context_.folder / "fluidVolume.dat";
    if (!context_.resumeAt)
        return beginTable();  // also when its first row comes much later: a restart before that finds it here
    const auto previous = previousTable(file_);
    if (!previous) return;
    const auto titles = readTable(*previous).titles();
    const auto fixed = massTitles({});
    for (const auto& title : fixed)
        if (std::find(titles.begin(), titles.end(), title) == titles.end()) return;  // another kind of table
    file_ = *previous;
    rowsUntil_ = context_.resumeAt;
    for (const auto& title : titles)
        if (std::find(fixed.begin(), fixed.end(), title) == fixed.end()) causes_.push_back(title);
}

template <int Dim>
void MassLedger<Dim>::execute(const State<Dim>& state) {
    const MassBalance balance = account_->balance(state);
    std::set<std::string> causes(causes_.begin(), causes_.end());
    for (const auto& [cause, volume] : balance.causes) causes.insert(cause);
    const bool anew = !table_ || causes.size() != causes_.size();
    causes_.assign(causes.begin(), causes.end());
    if (anew) beginTable();
    const auto values = massColumns(balance, causes_);
    std::vector<std::string> row{table_->time(values[0])};
    for (std::size_t i = 1; i < values.size(); ++i) row.push_back(table_->number(values[i]));
    table_->row(row);
    rowsUntil_ = state.time.value;
}

/// A cause that appears late brings a column for all rows.
template <int Dim>
void MassLedger<Dim>::beginTable() {
    const bool there = rowsUntil_ && std::filesystem::exists(file_);  // somebody may have removed it meanwhile
    const auto rows = there ? rowsOf(upTo(*rowsUntil_, readTable(file_))) : std::vector<Row>{};
    const auto titles = massTitles(causes_);
    std::vector<std::vector<std::string>> columns;
    for (const auto& row : rows) {
        columns.emplace_back();
        for (const auto& title : titles) columns.back().push_back(row.count(title) ? row.at(title) : "0");
    }
    table_.emplace(file_, context_.precision, 0.0);
    table_->comment(
        "Fluid volume [m2 (2D), m3], mass [kg/m, kg] and cumulative change of volume by cause; compression is no "
        "change of mass");
    table_->header(titles);
    table_->replaceRows(columns);
}

#define PFEM_INSTANTIATE(D) template class MassLedger<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
