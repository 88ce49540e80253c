#include "dictionary/node.hpp"

#include <algorithm>

namespace pfem {

DictionaryEntry* DictionaryNode::find(const std::string& key, bool patterns) {
    const auto exact = index.find(key);
    if (exact != index.end()) return &entries[exact->second];
    if (!patterns) return nullptr;
    const auto last = std::find_if(entries.rbegin(), entries.rend(), [&](const DictionaryEntry& entry) {
        return entry.pattern && entry.pattern->matches(key);
    });
    return last == entries.rend() ? nullptr : &*last;
}

void DictionaryNode::add(DictionaryEntry entry) {
    const auto [place, isNew] = index.emplace(entry.key, entries.size());
    if (isNew) {
        entries.push_back(std::move(entry));
    } else {
        entries[place->second] = std::move(entry);
    }
}

void DictionaryNode::remove(const std::string& key) {
    const auto place = index.find(key);
    if (place == index.end()) return;
    entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(place->second));
    index.clear();
    for (std::size_t i = 0; i < entries.size(); ++i) index.emplace(entries[i].key, i);
}

NodePtr makeNode(const NodePtr& parent, const std::string& keyword, const Location& where) {
    auto node = std::make_shared<DictionaryNode>();
    node->keyword = keyword;
    node->name = parent ? parent->name + '.' + keyword : keyword;
    node->where = where;
    node->parent = parent;
    return node;
}

int depthOf(NodePtr node) {
    int depth = 0;
    for (; node; node = node->parent.lock()) ++depth;
    return depth;
}

namespace {

void spend(long& budget, std::size_t amount, int depth, const Location& where) {
    budget -= static_cast<long>(amount);
    if (budget < 0) throw UserError("The macros of this file expand to too much text", where);
    if (depth > maxDepth) throw UserError("Dictionaries are nested too deeply", where);
}

}  // namespace

NodePtr copyNode(const DictionaryNode& from, const NodePtr& parent, const std::string& keyword, const Location& where,
                 long& budget, int depth) {
    if (depth == 0) depth = parent ? depthOf(parent) + 1 : 1;
    auto copy = makeNode(parent, keyword, from.where);
    for (const auto& entry : from.entries) {
        spend(budget, 1 + entry.tokens.size(), depth, where);
        DictionaryEntry mine = entry;
        mine.used = mine.inMacro = false;
        if (entry.dict) {
            mine.dict =
                std::make_shared<Dictionary>(copyNode(*entry.dict->node(), copy, entry.key, where, budget, depth + 1));
        }
        for (auto& token : mine.tokens) {
            if (!token.dict) continue;
            const auto& inner = *token.dict->node();
            token.dict = std::make_shared<Dictionary>(copyNode(inner, copy, inner.keyword, where, budget, depth + 1));
        }
        copy->add(std::move(mine));
    }
    return copy;
}

void mergeInto(const NodePtr& to, const NodePtr& from) {
    for (auto& entry : from->entries) {
        DictionaryEntry* mine = to->find(entry.key, false);
        if (mine && mine->dict && entry.dict) {
            mergeInto(mine->dict->node(), entry.dict->node());
        } else {
            if (entry.dict) entry.dict->node()->parent = to;
            for (auto& token : entry.tokens) {
                if (token.dict) token.dict->node()->parent = to;
            }
            to->add(std::move(entry));
        }
    }
}

}  // namespace pfem
