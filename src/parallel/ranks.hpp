#pragma once
// The processes that share a run (mpirun -np N pfemFsiFoam -parallel).

#include <cstddef>
#include <type_traits>
#include <vector>

namespace pfem {

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

    /// No rank goes on before all have come here.
    void wait() const { gather(std::vector<char>{}); }

    /// Ends all of them at once; for errors, of which the others know nothing.
    [[noreturn]] void abort(int exitCode) const;

private:
    Ranks(int rank, int size) : rank_(rank), size_(size) {}
    void broadcast(void* value, std::size_t bytes) const;
    std::vector<std::size_t> endsOf(std::size_t mine) const;
    void gather(const void* mine, void* all, const std::vector<std::size_t>& ends, std::size_t bytes) const;

    int rank_ = 0, size_ = 1;
};

}  // namespace pfem
