// SPDX-License-Identifier: MIT
#pragma once

// A list of things with an id and a name, in the operator's order: frames, tools, payloads, patterns and the
// like. Things refer to each other by id; people find them by name.

#include <QString>
#include <QUuid>
#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace tiller::project {

/// `wanted` if nobody has that name, else with the next free number: "pick", "pick 2", "pick 3".
QString freeName(const QString& wanted, const std::function<bool(const QString&)>& isTaken);

/// Entity  has `QUuid id` and `QString name`
template <class Entity>
class EntityList {
public:
    EntityList() = default;
    EntityList(std::initializer_list<Entity> entities) : entities_(entities) {}

    std::size_t size() const { return entities_.size(); }                      ///< How many there are.
    bool isEmpty() const { return entities_.empty(); }                         ///< None at all.
    const Entity& at(std::size_t index) const { return entities_.at(index); }  ///< Throws std::out_of_range.
    auto begin() const { return entities_.begin(); }
    auto end() const { return entities_.end(); }
    void append(Entity entity) { entities_.push_back(std::move(entity)); }  ///< At the end.
    /// index  0 ... size(); the new one stands there afterwards
    void insert(std::size_t index, Entity entity) {
        const std::size_t at = std::min(index, entities_.size());
        entities_.insert(entities_.begin() + static_cast<std::ptrdiff_t>(at), std::move(entity));
    }
    /// Its place stays.
    void replace(std::size_t index, Entity entity) { entities_.at(index) = std::move(entity); }
    void remove(std::size_t index) {  ///< Those behind move up.
        if (index < entities_.size()) {
            entities_.erase(entities_.begin() + static_cast<std::ptrdiff_t>(index));
        }
    }
    void clear() { entities_.clear(); }  ///< All go.

    /// -1 when there is none with that id.
    int indexOf(const QUuid& id) const {
        return placeOf([&](const Entity& entity) { return entity.id == id; });
    }
    int indexOfName(const QString& name) const {  ///< -1 when there is none.
        return placeOf([&](const Entity& entity) { return entity.name == name; });
    }
    const Entity* find(const QUuid& id) const { return pointer(indexOf(id)); }  ///< Null when there is none.
    /// As find(). Where two have that name, which the tables of the window do not let happen, it is the
    /// first of them.
    const Entity* findByName(const QString& name) const { return pointer(indexOfName(name)); }

    QString uniqueName(const QString& wanted) const {  ///< As freeName(), among these.
        return freeName(wanted, [this](const QString& name) { return indexOfName(name) >= 0; });
    }
    /// "frame 1", "frame 2": the next free one. stem  the word in the operator's language
    QString nextName(const QString& stem) const {
        return uniqueName(QStringLiteral("%1 %2").arg(stem).arg(size() + 1));
    }
    friend bool operator==(const EntityList&, const EntityList&) = default;

private:
    template <class Wanted>
    int placeOf(const Wanted& isWanted) const {
        const auto found = std::find_if(entities_.begin(), entities_.end(), isWanted);
        return found == entities_.end() ? -1 : static_cast<int>(found - entities_.begin());
    }
    const Entity* pointer(int index) const {
        return index < 0 ? nullptr : &entities_[static_cast<std::size_t>(index)];
    }

    std::vector<Entity> entities_;
};

}  // namespace tiller::project
