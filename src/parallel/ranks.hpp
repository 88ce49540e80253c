#pragma once
// The processes that share a run (mpirun -np N pfemFsiFoam -parallel).

#include <cstddef>
#include <type_traits>
#include <vector>

#include "base/parallel.hpp"
#include "base/types.hpp"

namespace pfem {

/// Is a value all of its bytes?
template <class Value>
inline constexpr bool isPlain = std::is_trivially_copyable_v<Value>;
template <class Scalar, int Rows, int Columns>
inline constexpr bool isPlain<Eigen::Matrix<Scalar, Rows, Columns>> = Rows > 0 && Columns > 0;

/// They are numbered from 0; the first one reads and writes for all. Without -parallel there is one, which sends
/// nothing. All members that send are collective: every rank calls them in the same order, one thread at a time.
class Ranks {
public:
    Ranks() = default;  // this process alone

    /// All that mpirun has started; they end together. Throws UserError in a build without MPI.
    static Ranks all();

    int size() const { return size_; }
    int rank() const { return rank_; }
    bool isFirst() const { return rank_ == 0; }
    bool isAlone() const { return size_ == 1; }

    /// The value of the first rank.
    template <class Value>
    Value ofFirst(Value value) const {
        static_assert(std::is_trivially_copyable_v<Value>);
        if (!isAlone()) broadcast(&value, sizeof value);
        return value;
    }

    /// What all ranks have, one after the other; `ends`: where each rank's part ends.
    template <class Value>
    std::vector<Value> gather(const std::vector<Value>& mine, std::vector<std::size_t>& ends) const {
        static_assert(std::is_trivially_copyable_v<Value>);
        if (isAlone()) {
            ends = {mine.size()};
            return mine;
        }
        ends = endsOf(mine.size());
        std::vector<Value> all(ends.back());
        gather(mine.data(), all.data(), ends, sizeof(Value));
        return all;
    }
    template <class Value>
    std::vector<Value> gather(const std::vector<Value>& mine) const {
        std::vector<std::size_t> ends;
        return gather(mine, ends);
    }

    /// Of values in runs, which end at `ends`, each rank has its own run; now all have all.
    template <class Value>
    void complete(std::vector<Value>& values, const std::vector<std::size_t>& ends) const {
        static_assert(isPlain<Value>);
        if (!isAlone()) gatherInPlace(values.data(), ends, sizeof(Value));
    }

    /// Where runs of equal lengths of n items end, and where that of this rank begins.
    std::vector<std::size_t> evenEnds(std::size_t n) const {
        std::vector<std::size_t> ends;
        for (int rank = 1; rank <= size_; ++rank) ends.push_back(n * rank / size_);
        return ends;
    }
    int beginOf(const std::vector<std::size_t>& ends) const {
        return rank_ == 0 ? 0 : static_cast<int>(ends[rank_ - 1]);
    }

    /// of(0) ... of(n - 1): each rank works off a run of them, as parallelFor, and all get all.
    template <class Of>
    auto each(int n, const Of& of) const {
        std::vector<decltype(of(0))> values(n);
        const auto ends = evenEnds(n);
        const int first = beginOf(ends), last = static_cast<int>(ends[rank_]);
        parallelFor(last - first, [&](int k) { values[first + k] = of(first + k); });
        complete(values, ends);
        return values;
    }

    /// The bits of parallelSum: each rank works off a run of its blocks.
    template <class Value>
    auto sum(int n, const Value& value) const {
        using Sum = decltype(value(0));
        constexpr int block = 512;  // as parallelSum
        const auto sums = each((n + block - 1) / block, [&](int b) {
            Sum sum{};
            for (int i = b * block; i < n && i < (b + 1) * block; ++i) sum += value(i);
            return sum;
        });
        Sum total{};
        for (const Sum& sum : sums) total += sum;
        return total;
    }

    /// No rank goes on before all have come here.
    void wait() const { gather(std::vector<char>{}); }

    /// Ends all of them at once; for errors, of which the others know nothing.
    [[noreturn]] void abort(int exitCode) const;

private:
    Ranks(int rank, int size) : rank_(rank), size_(size) {}
    void broadcast(void* value, std::size_t bytes) const;
    std::vector<std::size_t> endsOf(std::size_t mine) const;
    void gatherInPlace(void* all, const std::vector<std::size_t>& ends, std::size_t bytes) const;
    void gather(const void* mine, void* all, const std::vector<std::size_t>& ends, std::size_t bytes) const;

    int rank_ = 0, size_ = 1;
};

}  // namespace pfem
