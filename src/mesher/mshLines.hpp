#pragma once
// The text of a .msh file line by line, with the line's number in every error.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace pfem {

/// The lines of a text as words, with their numbers. Errors name the file, and the line where it is `numbered`
/// (the text of a binary file has lines that nobody sees).
class MshLines {
public:
    MshLines(std::string content, std::string name, bool numbered)
        : name_(std::move(name)), content_(std::move(content)), numbered_(numbered) {}

    /// A place between two lines.
    struct Place {
        std::size_t at = 0;
        int number = 0;
    };
    Place place() const { return place_; }
    /// What follows `place` is read next.
    void goTo(Place place) { place_ = place; }

    /// The next line that is not empty; false at the end of the file.
    bool next() {
        while (place_.at < content_.size()) {
            const std::size_t end = std::min(content_.find('\n', place_.at), content_.size());
            text_ = content_.substr(place_.at, end - place_.at);
            place_ = {end + 1, place_.number + 1};
            split();
            if (!words_.empty()) return true;
        }
        return false;
    }
    /// The next line of section `name`, which has `least` words or more.
    void demand(const std::string& section, std::size_t least) {
        if (!next()) fail("the file ends within $" + section);
        if (words_.front().front() == '$') fail(fmt::format("$End{} comes before all of its lines", section));
        if (words_.size() < least)
            fail(fmt::format("${}: {} numbers expected, {} found", section, least, words_.size()));
    }

    std::string_view word(std::size_t i) const { return words_[i]; }
    std::size_t size() const { return words_.size(); }
    const std::string& text() const { return text_; }
    int number() const { return numbered_ ? place_.number : 0; }

    double real(std::size_t i) const {
        const auto value = parse<double>(i);
        if (!std::isfinite(value)) fail(fmt::format("'{}' is not a finite number", word(i)));
        return value;
    }
    long whole(std::size_t i) const { return parse<long>(i); }
    long count(std::size_t i) const {
        const long value = whole(i);
        if (value < 0 || value > 1000000000) fail(fmt::format("{} is no number of things", value));
        return value;
    }
    /// For loops over words that must be there.
    void need(std::size_t least) const {
        if (words_.size() < least) fail(fmt::format("{} numbers expected, {} found", least, words_.size()));
    }
    [[noreturn]] void fail(const std::string& message) const { fail(message, number()); }
    [[noreturn]] void fail(const std::string& message, int line) const {
        throw UserError("cannot take the mesh of \"" + name_ + "\": " + message, {name_, line});
    }

private:
    template <class T>
    T parse(std::size_t i) const {
        T value{};
        const auto w = words_[i];
        const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
        if (error != std::errc() || end != w.data() + w.size()) fail(fmt::format("'{}' is not a number", w));
        return value;
    }
    void split() {
        words_.clear();
        std::size_t begin = 0;
        while ((begin = text_.find_first_not_of(" \t\r", begin)) != std::string::npos) {
            const std::size_t end = std::min(text_.find_first_of(" \t\r", begin), text_.size());
            words_.emplace_back(text_.data() + begin, end - begin);
            begin = end;
        }
    }

    std::string name_, content_, text_;
    bool numbered_;
    std::vector<std::string_view> words_;
    Place place_;  // behind the present line
};

}  // namespace pfem
