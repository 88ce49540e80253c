#pragma once
// Reads the value of an entry token by token, with errors that name the line.
//
//     TokenReader value = dictionary.reader("table");          // ((0 (0 0 0)) (0.1 (1 0 0)))
//     value.list([&] {
//         value.open();
//         times.push_back(value.read<double>());
//         values.push_back(value.read<Eigen::Vector3d>());
//         value.close();
//     });
//     value.end();

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "dictionary/token.hpp"

namespace pfem {

class TokenReader {
public:
    /// `owner` keeps the tokens alive.
    TokenReader(std::shared_ptr<const void> owner, const Tokens& tokens, std::string key, Location where)
        : owner_(std::move(owner)), tokens_(&tokens), key_(std::move(key)), where_(std::move(where)) {}

    bool atEnd() const { return position_ >= tokens_->size(); }
    /// The next token; one of kind `end` after the last.
    const Token& peek(std::size_t ahead = 0) const;
    Token next();

    /// bool, int, int64_t, double, std::string, Vector3d, Dictionary, std::vector of these.
    template <class T>
    T read() {
        if constexpr (isVector<T>::value) {
            T values;
            list([&] { values.push_back(read<typename T::value_type>()); });
            return values;
        } else {
            T value{};
            readInto(value);
            return value;
        }
    }

    bool opens() const { return peek().is('('); }
    bool closes() const { return peek().is(')'); }
    void open() { expect('('); }
    void close() { expect(')'); }
    void expect(char punctuation);

    /// (a b c), 3(a b c), 3{a} and List<type> 3(a b c): calls `element` for each one.
    void list(const std::function<void()>& element);

    /// Fatal if tokens are left: most often a forgotten semicolon.
    void end() const;

    [[noreturn]] void fatal(const std::string& message) const;
    [[noreturn]] void wrongType(const std::string& expected, const Token& token) const;

private:
    template <class T>
    struct isVector : std::false_type {};
    template <class T>
    struct isVector<std::vector<T>> : std::true_type {};

    void readInto(bool& value);
    void readInto(int& value);
    void readInto(std::int64_t& value);
    void readInto(double& value);
    void readInto(std::string& value);
    void readInto(Eigen::Vector3d& value);
    void readInto(Dictionary& value);

    std::shared_ptr<const void> owner_;
    const Tokens* tokens_;
    std::string key_;
    Location where_;
    std::size_t position_ = 0;
};

}  // namespace pfem
