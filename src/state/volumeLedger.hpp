#pragma once
// The account of the fluid's volume: how much has appeared, by which cause and, where somebody has asked, at which
// nodes.

#include <map>
#include <vector>

#include "state/volumeCauses.hpp"

namespace pfem {

/// Amounts [m2 (2D), m3] are positive for volume that appears. Everything is booked once; what nodes have got
/// (atNodes) and the fields by cause follow from it. A sheet is the ledger of one event: its sums begin with zero and
/// are posted as a whole, so that their round-off does not depend on what was before.
class VolumeLedger : public CauseSums<VolumeCause> {
public:
    using CauseSums::book;
    void book(VolumeCause cause, int node, double amount) {
        book(cause, amount);
        place(cause, node, amount);
    }
    /// In a cell: an even part for each of its nodes.
    template <std::size_t N>
    void book(VolumeCause cause, const std::array<int, N>& cell, double amount) {
        book(cause, amount);
        for (const int node : cell) place(cause, node, amount / static_cast<double>(N));
    }
    /// At all nodes; their sum is booked as a whole and returned.
    double book(VolumeCause cause, const std::vector<double>& amounts);

    /// Where an amount that is (or will be) booked as a whole has appeared.
    void place(VolumeCause cause, int node, double amount);
    void place(VolumeCause cause, const std::vector<double>& amounts, double factor = 1);

    /// The ledger of an event of as many nodes.
    VolumeLedger sheet(int nNodes) const;
    /// What the nodes of a sheet have got, of causes that something has to make up for.
    const std::vector<double>& atNodes() const { return atNodes_; }
    /// The sheet's sums come in; its fields take the place of those here, to which they must have been added.
    void post(VolumeLedger sheet);

    using Fields = std::map<VolumeCause, std::vector<double>>;
    /// Fields from zero for as many nodes.
    void countFields(int nNodes);
    void stopCounting() { fields_.clear(); }
    bool counting() const { return !fields_.empty(); }
    const Fields& fields() const { return fields_; }
    Fields& fields() { return fields_; }

private:
    Fields fields_;  // empty: nobody has asked
    std::vector<double> atNodes_;
};

}  // namespace pfem
