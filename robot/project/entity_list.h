// SPDX-License-Identifier: MIT
#pragma once

// An ordered list of objects with an ID and a name: frames, tools, payloads, patterns and others. References
// use the ID, and the user interface shows the name.

#include <QString>
#include <QUuid>
#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace tiller::project {

/// Returns `wanted` if the name is free, otherwise the name with the next free number: "pick", "pick 2",
/// "pick 3".
QString freeName(const QString& wanted, const std::function<bool(const QString&)>& isTaken);

/// Entity  a type with the members `QUuid id` and `QString name`
template <class Entity>
class EntityList {
public:
    EntityList() = default;
    EntityList(std::initializer_list<Entity> entities) : entities_(entities) {}

    std::size_t size() const { return entities_.size(); }
    bool isEmpty() const { return entities_.empty(); }
    const Entity& at(std::size_t index) const { return entities_.at(index); }  ///< Throws std::out_of_range.
    auto begin() const { return entities_.begin(); }
    auto end() const { return entities_.end(); }
    void append(Entity entity) { entities_.push_back(std::move(entity)); }
    /// index  0 ... size()
    void insert(std::size_t index, Entity entity) {
        const std::size_t at = std::min(index, entities_.size());
        entities_.insert(entities_.begin() + static_cast<std::ptrdiff_t>(at), std::move(entity));
    }
    /// Replaces the entry at this index. Throws std::out_of_range.
    void replace(std::size_t index, Entity entity) { entities_.at(index) = std::move(entity); }
    void remove(std::size_t index) {  ///< Removes an entry; later entries move up.
        if (index < entities_.size()) {
            entities_.erase(entities_.begin() + static_cast<std::ptrdiff_t>(index));
        }
    }
    void clear() { entities_.clear(); }

    /// Returns -1 if the ID does not exist.
    int indexOf(const QUuid& id) const {
        return placeOf([&](const Entity& entity) { return entity.id == id; });
    }
    int indexOfName(const QString& name) const {  ///< Returns -1 if the name does not exist.
        return placeOf([&](const Entity& entity) { return entity.name == name; });
    }
    const Entity* find(const QUuid& id) const {
        return pointer(indexOf(id));
    }  ///< Returns null if the ID does not exist.
    /// Like find(), by name. If several entries have this name, returns the first one. The tables of the user
    /// interface prevent duplicate names.
    const Entity* findByName(const QString& name) const { return pointer(indexOfName(name)); }

    QString uniqueName(const QString& wanted) const {  ///< Like freeName(), with the names of this list.
        return freeName(wanted, [this](const QString& name) { return indexOfName(name) >= 0; });
    }
    /// The next free name of the form "frame 1", "frame 2".
    /// stem  the noun in the operator's language
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
