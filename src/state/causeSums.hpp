#pragma once
// Amounts by cause: what the ledgers of volume and of energy are made of.

#include <array>
#include <map>
#include <string>

namespace pfem {

/// What becomes of an amount.
enum class CauseKind {
    gainOrLoss,  // an error of the method: something has to make up for it
    elastic,     // pressure gives it back
    passage      // it has come from outside or has left
};
/// Is there a nodal field of it from the start, or only once it has been booked?
enum class CauseField { always, onceBooked };

/// What is known of a cause.
struct CauseText {
    const char* name;  // in files: entry of uniform/time, column of a table
    CauseKind kind;
    CauseField field;
    const char* meaning;
};

/// To be specialised for an enum of causes: `static constexpr std::array table` in its order.
template <class Cause>
struct Causes;

template <class Cause>
constexpr const CauseText& textOf(Cause cause) {
    return Causes<Cause>::table[static_cast<std::size_t>(cause)];
}

/// Cumulative amounts by cause. A cause is there once something, perhaps zero, has been booked by it.
template <class Cause>
class CauseSums {
public:
    void book(Cause cause, double amount) { sums_[cause] += amount; }

    /// 0 for a cause that is not there.
    double operator[](Cause cause) const {
        const auto found = sums_.find(cause);
        return found == sums_.end() ? 0 : found->second;
    }
    bool has(Cause cause) const { return sums_.count(cause) > 0; }

    /// All that are there by name, for files and tables; with causes of older versions, which no step books.
    std::map<std::string, double> byName() const {
        std::map<std::string, double> amounts = former_;
        for (const auto& [cause, amount] : sums_) amounts[textOf(cause).name] = amount;
        return amounts;
    }
    /// The inverse of byName().
    void takeFrom(std::map<std::string, double> amounts) {
        sums_.clear();
        for (std::size_t k = 0; k < Causes<Cause>::table.size(); ++k)
            if (auto found = amounts.extract(Causes<Cause>::table[k].name))
                sums_[static_cast<Cause>(k)] = found.mapped();
        former_ = std::move(amounts);
    }

    /// Of all causes, in the order of their names.
    double sum() const {
        double sum = 0;
        for (const auto& [name, amount] : byName()) sum += amount;
        return sum;
    }
    /// Of those of one kind; causes of older versions are gains and losses.
    double sum(CauseKind kind) const {
        auto amounts = byName();
        for (const auto& text : Causes<Cause>::table)
            if (text.kind != kind) amounts.erase(text.name);
        if (kind != CauseKind::gainOrLoss)
            for (const auto& [name, amount] : former_) amounts.erase(name);
        double sum = 0;
        for (const auto& [name, amount] : amounts) sum += amount;
        return sum;
    }

protected:
    void add(const CauseSums& other) {
        for (const auto& [cause, amount] : other.sums_) sums_[cause] += amount;
    }

private:
    std::map<Cause, double> sums_;
    std::map<std::string, double> former_;
};

}  // namespace pfem
