#include "state/volumeLedger.hpp"

#include <numeric>

namespace pfem {

double VolumeLedger::book(VolumeCause cause, const std::vector<double>& amounts) {
    const double sum = std::accumulate(amounts.begin(), amounts.end(), 0.0);
    book(cause, sum);
    place(cause, amounts);
    return sum;
}

void VolumeLedger::place(VolumeCause cause, int node, double amount) {
    if (!atNodes_.empty() && textOf(cause).kind == CauseKind::gainOrLoss) atNodes_[node] += amount;
    if (!counting()) return;
    const std::size_t nNodes = fields_.begin()->second.size();
    fields_.try_emplace(cause, nNodes, 0.0).first->second[node] += amount;
}

void VolumeLedger::place(VolumeCause cause, const std::vector<double>& amounts, double factor) {
    if (atNodes_.empty() && !counting()) return;
    for (std::size_t i = 0; i < amounts.size(); ++i) place(cause, static_cast<int>(i), factor * amounts[i]);
}

VolumeLedger VolumeLedger::sheet(int nNodes) const {
    VolumeLedger sheet;
    sheet.atNodes_.assign(nNodes, 0.0);
    for (const auto& [cause, amounts] : fields_) sheet.fields_[cause].assign(nNodes, 0.0);
    return sheet;
}

void VolumeLedger::post(VolumeLedger sheet) {
    add(sheet);
    fields_ = std::move(sheet.fields_);
}

void VolumeLedger::countFields(int nNodes) {
    fields_.clear();
    for (std::size_t k = 0; k < Causes<VolumeCause>::table.size(); ++k) {
        const auto cause = static_cast<VolumeCause>(k);
        if (textOf(cause).field == CauseField::always || has(cause)) fields_[cause].assign(nNodes, 0.0);
    }
}

}  // namespace pfem
