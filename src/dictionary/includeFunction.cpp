// #includeFunc name(U, key=value): a function object from a file `name`.

#include <iostream>

#include "dictionary/files.hpp"
#include "dictionary/parser.hpp"

namespace fs = std::filesystem;

namespace pfem {

namespace {

/// The arguments between the outer parentheses, without blanks around them.
std::vector<std::string> arguments(const std::string& call) {
    std::vector<std::string> result;
    const auto open = call.find('(');
    if (open == std::string::npos) return result;
    std::string argument;
    int depth = 0;
    for (std::size_t i = open; i < call.size(); ++i) {
        const char c = call[i];
        if (c == ')' && --depth == 0) break;
        if (c == '(' && depth++ == 0) continue;
        if (c == ',' && depth == 1) {
            result.push_back(argument);
            argument.clear();
        } else if (c != ' ' || !argument.empty()) {
            argument += c;
        }
    }
    if (!argument.empty()) result.push_back(argument);
    return result;
}

}  // namespace

/// The file stands beside the including one or in caseDicts/postProcessing of an etc folder. Its entries make
/// a sub-dictionary; arguments become `field`, `fields` or the entries they name. A warning if there is no
/// such file.
void Parser::includeFunction(Lexer& lexer, const NodePtr& node, const Token& token) {
    const std::string call = lexer.lineArgument();
    const std::string name = call.substr(0, call.find('('));
    if (name.empty()) throw UserError("#includeFunc needs a name", token.where());
    std::error_code error;
    fs::path file = fs::path(*token.file).parent_path() / name;
    if (!fs::is_regular_file(file, error)) file = findFunction(name).value_or(fs::path());
    if (file.empty()) {
        std::cerr << "--> PFEM Warning: cannot find function object file " << name << " for " << *token.file << ':'
                  << token.line << '\n';
        return;
    }
    DictionaryEntry entry;
    for (const char c : call) {
        if (c != ' ') entry.key += c;
    }
    entry.where = token.where();
    NodePtr function = makeNode(node, entry.key, token.where());
    includeFile(file, function, token);
    if (const auto* inner = function->find(name, false); inner && inner->dict) {
        function = copyNode(*inner->dict->node(), node, entry.key, token.where(), budget_);
    }
    std::string fields;
    std::string settings;
    for (const auto& argument : arguments(call)) {
        const auto equals = argument.find('=');
        if (equals == std::string::npos) {
            fields += (fields.empty() ? "" : " ") + argument;
        } else {
            settings += argument.substr(0, equals) + ' ' + argument.substr(equals + 1) + ";\n";
        }
    }
    if (!fields.empty()) {
        settings += "fields (" + fields + ");\n";
        if (fields.find(' ') == std::string::npos) settings += "field " + fields + ";\n";
    }
    Lexer set(settings, token.file, token.line);
    entries(set, function, {});
    entry.dict = std::make_shared<Dictionary>(function);
    add(node, std::move(entry));
}

}  // namespace pfem
